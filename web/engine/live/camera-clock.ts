import { FramePeriod } from '../../sampling/frame-period.ts';
import type { CameraFrame } from '../../sources/camera-frames.ts';

/** Camera frames that are remembered, in seconds: longer than any delay. */
const REMEMBERED_S = 4;

/** How much the newest frame counts in the mean lag. */
const NEWEST = 0.1;

/** What the camera's frames so far tell of time. In seconds. */
export class CameraClock {
  readonly #period = new FramePeriod();
  #frames: number[] = [];
  #sinceLook: number[] = [];
  #index = -1;
  #lag = 0;

  /** A frame. @returns seconds since the one before; infinite for the first, null if it is no later */
  add({ time, told, missed }: CameraFrame): number | null {
    const last = this.#frames.at(-1);
    if (last !== undefined && time <= last) return null;
    this.#frames = this.#frames.filter((past) => past > time - REMEMBERED_S);
    this.#frames.push(time);
    this.#sinceLook.push(time);
    this.#period.add(time, 1 + missed);
    this.#lag += NEWEST * (told - time - this.#lag);
    this.#index += 1 + (this.#index < 0 ? 0 : missed);
    return last === undefined ? Number.POSITIVE_INFINITY : time - last;
  }

  /** The newest frame's place among the camera's, those that were missed included. */
  get index(): number {
    return this.#index;
  }

  /** From frame to frame. */
  get period(): number {
    return this.#period.seconds;
  }

  /** Frames per second; 0 until known. */
  get rate(): number {
    return this.#frames.length > 1 ? 1 / this.period : 0;
  }

  /** From a frame's capture until the page is told of it. */
  get lag(): number {
    return this.#lag;
  }

  /** The last frame that was captured up to a time. */
  frameAt(time: number): number | null {
    return this.#frames.findLast((captured) => captured <= time) ?? null;
  }

  /** Frames since this was asked last. */
  takeFrames(): Float64Array {
    const frames = Float64Array.from(this.#sinceLook);
    this.#sinceLook = [];
    return frames;
  }

  /** Counts frames from 0 again. */
  restart(): void {
    this.#index = -1;
  }
}
