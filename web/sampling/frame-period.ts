/** As many frames are looked back on. */
const MEMORY = 30;

/** A longer pause is no frame's length: the tab was hidden, or the camera restarted. */
const LONGEST_S = 0.5;

/** What a camera is taken to give until it has shown what it does. */
const USUAL_S = 1 / 30;

/**
 * The seconds from one camera frame to the next, measured: the median of the last second or so, so that a
 * frame that came late or not at all changes nothing, and another rate is noticed.
 */
export class FramePeriod {
  readonly #periods: number[] = [];
  #last: number | undefined;

  /**
   * @param time seconds, increasing
   * @param frames camera frames since the last call: more than one where some were not seen
   */
  add(time: number, frames = 1): void {
    const gap = this.#last === undefined ? undefined : (time - this.#last) / Math.max(1, frames);
    this.#last = time;
    if (gap === undefined || !(gap > 0) || gap > LONGEST_S) return;
    this.#periods.push(gap);
    if (this.#periods.length > MEMORY) this.#periods.shift();
  }

  /** Seconds. */
  get seconds(): number {
    if (this.#periods.length === 0) return USUAL_S;
    const sorted = [...this.#periods].sort((a, b) => a - b);
    return sorted[sorted.length >> 1]!;
  }
}
