import { splitSegments } from './segments.ts';

/** Q: intervals in a full window, as in the paper and as the nets were trained. */
export const WINDOW_INTERVALS = 10;

/** Intervals from one window's start to the next one's: half a window, so that all frames but the
 * ends are seen from two sides. */
export const WINDOW_STRIDE = 5;

/** A stretch of the clip that the nets take at once: its first and last frame are watched. */
export interface SampleWindow {
  /** Positions of its S samples in the list of seen samples, consecutive; 1 ≤ S ≤ 11. */
  readonly samples: readonly number[];
  /** The frames of its first and last sample; all frames from one to the other are recovered. */
  readonly firstFrame: number;
  readonly lastFrame: number;
}

/**
 * Cuts the samples in which somebody was seen into overlapping windows. Frames that no window covers
 * (before the first sample, after the last one, in long gaps) stay without a pose.
 *
 * A segment's last window is moved back to full length; a segment shorter than a window is one
 * window; a lone sample is a window of one frame.
 *
 * @param seen watched frames with an estimate, ascending
 * @param times T times of all frames of the clip, in seconds
 * @param every N
 */
export function cutWindows(
  seen: ArrayLike<number>,
  times: ArrayLike<number>,
  every: number,
): SampleWindow[] {
  return splitSegments(seen, times, every).flatMap(([start, end]) =>
    windowStarts(start, end).map((first) => {
      const length = Math.min(WINDOW_INTERVALS + 1, end - first);
      const samples = Array.from({ length }, (_, i) => first + i);
      return { samples, firstFrame: seen[first]!, lastFrame: seen[first + length - 1]! };
    }),
  );
}

/** Where the windows of the segment [start, end) begin. */
function windowStarts(start: number, end: number): number[] {
  const lastStart = Math.max(start, end - 1 - WINDOW_INTERVALS);
  const starts: number[] = [];
  for (let first = start; first < lastStart; first += WINDOW_STRIDE) starts.push(first);
  starts.push(lastStart);
  return starts;
}
