import type { SampleWindow } from './windows.ts';

/**
 * The weight of a window's own first and last frame, where inner frames have 1, 4, 9, … from the
 * nearer end. It decides only where no other window covers the frame: at the ends of the clip. At all
 * other ends it is next to nothing, so that there is no jump where a window begins.
 */
const EDGE_WEIGHT = 1e-3;

/**
 * Joins the poses of overlapping windows: each frame's pose is the mean over the windows that cover
 * it, weighted by the square of how far the frame is from the window's nearer end, where the nets know only
 * one side of it.
 */
export class Stitcher {
  readonly #size: number;
  readonly #sums: Float64Array;
  readonly #weights: Float64Array;

  /**
   * @param frameCount T, frames of the clip
   * @param size K·D, values of one pose
   */
  constructor(frameCount: number, size: number) {
    this.#size = size;
    this.#sums = new Float64Array(frameCount * size);
    this.#weights = new Float64Array(frameCount);
  }

  /** @param poses the poses of all frames from the window's first to its last: Tw·K·D values */
  add({ firstFrame, lastFrame }: SampleWindow, poses: Float32Array): void {
    const size = this.#size;
    const frames = lastFrame - firstFrame + 1;
    if (poses.length !== frames * size || lastFrame >= this.#weights.length) {
      throw new RangeError(
        `${poses.length} values do not fit frames ${firstFrame} to ${lastFrame} of ${size} values ` +
          `each in a clip of ${this.#weights.length} frames.`,
      );
    }
    for (let t = 0; t < frames; t++) {
      const weight = Math.min(t, frames - 1 - t) ** 2 + EDGE_WEIGHT;
      const frame = firstFrame + t;
      this.#weights[frame]! += weight;
      for (let i = 0; i < size; i++) {
        this.#sums[frame * size + i]! += weight * poses[t * size + i]!;
      }
    }
  }

  /** T·K·D values; NaN in frames that no window covers. */
  finish(): Float32Array {
    const out = new Float32Array(this.#sums.length);
    this.#weights.forEach((weight, frame) => {
      for (let i = frame * this.#size; i < (frame + 1) * this.#size; i++) {
        // 0 / 0 is the NaN of the uncovered frames.
        out[i] = this.#sums[i]! / weight;
      }
    });
    return out;
  }
}
