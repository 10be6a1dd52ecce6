/** A picture that comes later than this after the one before was held up. */
const LATE_MS = 45;

/** So many pictures in time, and the 3D view may be drawn more often again. */
const GOOD_TO_RISE = 90;

/** The 3D view is drawn at least with every so many-th picture. */
const SELDOM = 6;

/**
 * Decides with which pictures the 3D view is drawn too: with all of them where the device keeps up, with
 * fewer where drawing it holds the page up, so that the skeleton over the picture stays in time.
 */
export class DrawGovernor {
  #every = 1;
  #good = 0;
  #count = 0;
  #last: number | null = null;

  /** How many pictures there are to one of the 3D view. */
  get every(): number {
    return this.#every;
  }

  /** @param stamp milliseconds of this picture. @returns whether the 3D view is to be drawn with it */
  offer(stamp: number): boolean {
    const gap = this.#last === null ? 0 : stamp - this.#last;
    this.#last = stamp;
    if (gap > LATE_MS) {
      this.#good = 0;
      // A tab that was hidden is no sign.
      if (gap < 1000) this.#every = Math.min(SELDOM, this.#every + 1);
    } else if (++this.#good >= GOOD_TO_RISE) {
      this.#good = 0;
      this.#every = Math.max(1, this.#every - 1);
    }
    this.#count++;
    return this.#count % this.#every === 0;
  }
}
