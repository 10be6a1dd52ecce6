import { frameAtTime } from '../../pose/sequence.ts';

/** Browsers and demuxers round a timestamp each in their own way; no two frames are this close. */
const ROUNDING_S = 0.0005;

/**
 * Turns a `<video>`'s clock into frame numbers and back. The file's own timestamps are the truth; the
 * element may count from its first frame instead, which is what `offset` is for.
 */
export class FrameClock {
  readonly #times: Float64Array;
  readonly #offset: number;

  /**
   * @param times T timestamps in seconds, increasing
   * @param firstMediaTime the element's own time of the first frame, in seconds, where it is known
   */
  constructor(times: Float64Array, firstMediaTime: number | null = null) {
    this.#times = times;
    const offset = firstMediaTime === null ? 0 : firstMediaTime - times[0]!;
    this.#offset = Math.abs(offset) > ROUNDING_S ? offset : 0;
  }

  get frameCount(): number {
    return this.#times.length;
  }

  /** The frame that is on screen at the element's time. */
  frameAt(mediaTime: number): number {
    return frameAtTime(this.#times, mediaTime - this.#offset + ROUNDING_S);
  }

  /**
   * The element's time to seek to so that frame `frame` shows: the middle of the frame, because at its
   * very edge rounding decides, and often for the neighbour.
   */
  seekTarget(frame: number): number {
    const last = this.#times.length - 1;
    const index = Math.min(Math.max(Math.round(frame), 0), last);
    const length =
      index < last
        ? this.#times[index + 1]! - this.#times[index]!
        : last > 0
          ? this.#times[last]! - this.#times[last - 1]!
          : 0;
    return this.#times[index]! + length / 2 + this.#offset;
  }
}
