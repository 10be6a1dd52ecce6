import { checkInterval, MAX_INTERVAL } from './watched.ts';

/**
 * What to do where the estimator is slower than the interval. `adapt`: watch less often until it keeps
 * up. `skip`: keep N, and leave out samples that come while it is busy.
 */
export type LoadPolicy = 'adapt' | 'skip';

/** N grows when this many samples in a row found the estimator busy … */
const LATE_TO_GROW = 2;
/** … to where a call takes this share of the interval. */
const ROOM = 0.8;
/** N falls again once a call would have taken less than this share of the shorter interval … */
const EASY = 0.6;
/** … for so many samples in a row. */
const EASY_TO_SHRINK = 6;
/** How much the newest call counts in the mean. */
const NEWEST = 0.3;

/**
 * Decides, camera frame by camera frame, which ones are watched: one in N. There is never more than
 * one call under way, so nothing queues.
 */
export class LiveSampler {
  #chosen: number;
  #every: number;
  #policy: LoadPolicy;
  #due = 0;
  #late = 0;
  #easy = 0;
  #callSeconds: number | undefined;

  /**
   * @param every N as chosen, 1 to 20
   * @throws DeciWatchError `bad-option`
   */
  constructor(every: number, policy: LoadPolicy) {
    checkInterval(every);
    this.#chosen = every;
    this.#every = every;
    this.#policy = policy;
  }

  /** N in force: larger than the chosen one while the estimator is too slow for that. */
  get every(): number {
    return this.#every;
  }

  /** N as chosen. */
  get chosen(): number {
    return this.#chosen;
  }

  /** @throws DeciWatchError `bad-option` */
  choose(every: number, policy: LoadPolicy): void {
    checkInterval(every);
    this.#chosen = every;
    this.#every = every;
    this.#policy = policy;
    this.#due = 0;
    this.#late = 0;
    this.#easy = 0;
  }

  /**
   * Whether this frame is to be watched.
   * @param index its place among the camera's frames, increasing; frames may be missing
   * @param busy a call is still under way
   * @param period seconds from frame to frame
   */
  offer(index: number, busy: boolean, period: number): boolean {
    if (index < this.#due) return false;
    if (busy) {
      if (this.#policy === 'skip') this.#due = this.#next(index);
      else this.#growIfLate(index, period);
      return false;
    }
    if (index === this.#due) this.#late = 0;
    this.#due = this.#next(index);
    return true;
  }

  /**
   * A call has come back.
   * @param seconds from the frame being sent to its answer
   * @param period seconds from frame to frame
   */
  answered(seconds: number, period: number): void {
    const before = this.#callSeconds ?? seconds;
    this.#callSeconds = before + NEWEST * (seconds - before);
    if (this.#every === this.#chosen) return;
    const fits = this.#callSeconds < EASY * (this.#every - 1) * period;
    this.#easy = fits ? this.#easy + 1 : 0;
    if (this.#easy < EASY_TO_SHRINK) return;
    this.#easy = 0;
    this.#every--;
  }

  /** Multiples of N, so that a frame that came late does not shift all the others. */
  #next(index: number): number {
    return (Math.floor(index / this.#every) + 1) * this.#every;
  }

  #growIfLate(index: number, period: number): void {
    // Counted once for each sample that is due, however many frames it waits.
    if (index !== this.#due && index % this.#every !== 0) return;
    this.#late++;
    if (this.#late < LATE_TO_GROW) return;
    this.#late = 0;
    // While no call has come back yet, all that is known is that N is too small.
    const needed =
      this.#callSeconds === undefined
        ? this.#every + 1
        : Math.ceil(this.#callSeconds / (ROOM * period));
    this.#every = Math.min(MAX_INTERVAL, Math.max(this.#every, needed));
  }
}
