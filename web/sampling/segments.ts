/** A gap in the samples is bridged while no more samples than this are missing in a row … */
export const MAX_MISSING_SAMPLES = 2;

/**
 * … and it is no longer than this many seconds: over a longer one the nets, which were trained on
 * intervals of up to two thirds of a second, would make a movement up.
 */
export const MAX_GAP_SECONDS = 1.5;

/**
 * A gap no longer than this is bridged however many samples are missing. With a small N the
 * estimator often loses a person for several samples in a row, and 0.7 s is no longer than the
 * longest usual interval (N = 20 at 30 frames a second).
 */
export const SHORT_GAP_SECONDS = 0.7;

/**
 * Splits the samples in which somebody was seen wherever nobody was seen for too long. Between two
 * segments, no frame has a pose.
 *
 * @param seen watched frames with an estimate, ascending
 * @param times T times of all frames of the clip, in seconds
 * @param every N
 * @returns ranges of positions in `seen`: [start, end), in order, none of them empty
 */
export function splitSegments(
  seen: ArrayLike<number>,
  times: ArrayLike<number>,
  every: number,
): (readonly [start: number, end: number])[] {
  const segments: [number, number][] = [];
  let start = 0;
  for (let i = 1; i <= seen.length; i++) {
    if (i < seen.length && isBridged(seen[i - 1]!, seen[i]!, times, every)) continue;
    segments.push([start, i]);
    start = i;
  }
  return segments;
}

function isBridged(from: number, to: number, times: ArrayLike<number>, every: number): boolean {
  // Rounded up because the clip's last sample may come after less than a whole interval.
  return bridges(Math.ceil((to - from) / every) - 1, times[to]! - times[from]!);
}

/**
 * Whether frames between two samples are recovered.
 * @param missing samples between them in which nobody was seen
 * @param gap seconds from one to the other
 */
export function bridges(missing: number, gap: number): boolean {
  // Two samples in a row are joined at any frame rate.
  if (missing === 0) return true;
  return gap <= SHORT_GAP_SECONDS || (missing <= MAX_MISSING_SAMPLES && gap <= MAX_GAP_SECONDS);
}
