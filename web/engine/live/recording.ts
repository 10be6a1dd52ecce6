import type { SpatialEstimate } from '../../estimators/estimator.ts';
import type { SpatialSample } from '../../recovery/watched-clip.ts';
import type { ClipInfo } from '../../sources/clip.ts';

/** Fewer frames are no movement. */
const FEWEST_FRAMES = 2;

/** No longer is waited for the look that ends a recording: frames may have stopped to come. */
const LAST_LOOK_MS = 1500;

/** What has to be kept of live playback to recover it afterwards like a file. */
export class Recording {
  #times: number[] = [];
  #watched: number[] = [];
  #seen: SpatialSample[] = [];
  #estimatorMs = 0;
  #ending = false;
  #until: number | null = null;
  #ended: () => void = () => {};
  #size = { width: 0, height: 0 };

  /** Seconds on the page's clock: the first watched frame's; null until there is one. */
  get since(): number | null {
    return this.#times[0] ?? null;
  }

  /** The last frame's time, on the same clock; null until that has come. */
  get until(): number | null {
    return this.#until;
  }

  /**
   * A camera frame; the recording begins with the first one that is watched, and ends where the picture gets
   * another size: the camera was turned.
   * @param time seconds on the page's clock
   * @param size pixels
   */
  addFrame(
    time: number,
    watched: boolean,
    size: { readonly width: number; readonly height: number },
  ): void {
    if (this.#until !== null || !(watched || this.#times.length > 0)) return;
    if (this.#times.length === 0) this.#size = size;
    if (size.width !== this.#size.width || size.height !== this.#size.height) {
      this.#until = this.#times.at(-1)!;
      this.#ended();
      return;
    }
    this.#times.push(time);
    if (this.#ending && watched) this.#until = time;
  }

  /** Ends with the next look, so that frames up to now are recovered too. Waits for its answer. */
  async end(): Promise<void> {
    if (this.#until !== null) return;
    this.#ending = true;
    await new Promise<void>((resolve) => {
      const timer = setTimeout(resolve, LAST_LOOK_MS);
      this.#ended = () => {
        clearTimeout(timer);
        resolve();
      };
    });
  }

  /** What the estimator found in one of them. */
  addWatched(time: number, estimate: SpatialEstimate | null, estimatorMs: number): void {
    const frame = this.#times.indexOf(time);
    if (frame < 0) return;
    this.#watched.push(frame);
    this.#estimatorMs += estimatorMs;
    if (estimate) this.#seen.push({ frame, estimate });
    if (time === this.#until) this.#ended();
  }

  /**
   * The stretch from the first watched frame to the last one, times from 0; null where it is too short,
   * or nobody was seen in it.
   */
  finish(name: string) {
    const first = this.#watched[0];
    const last = this.#watched.at(-1);
    if (first === undefined || last === undefined || this.#seen.length === 0) return null;
    const frameCount = last - first + 1;
    if (frameCount < FEWEST_FRAMES) return null;
    const begin = this.#times[first]!;
    const times = Float64Array.from(this.#times.slice(first, last + 1), (time) => time - begin);
    const period = times.at(-1)! / (frameCount - 1);
    const duration = times.at(-1)! + period;
    const info: ClipInfo = {
      name,
      ...this.#size,
      frameCount,
      frameRate: frameCount / duration,
      duration,
    };
    return {
      info,
      times,
      begin,
      watched: this.#watched.map((frame) => frame - first),
      seen: this.#seen.map(({ frame, estimate }) => ({ frame: frame - first, estimate })),
      estimatorMs: this.#estimatorMs,
    };
  }
}
