import type { Dimensions } from '../pose/sequence.ts';
import type { Normalisation } from './manifest.ts';

/** Where the nets' zero lies and how long their one is, in the pose's own units. */
export interface NetFrame {
  /** D values. */
  readonly origin: Float64Array;
  readonly unit: number;
}

/** A person smaller than this is a failure of the estimator, and would blow up the values. */
const MIN_BOX_PX = 1;

/**
 * The frame of one window.
 *
 * `scale` (3D) has its origin at the mid-hip. `window-box` (2D) has it at the mean of the middles of
 * the samples' boxes (least to greatest over the landmarks); its unit is the mean of the boxes'
 * longer sides. So the person's path through the picture is kept, and the picture's size is not.
 *
 * The same as `export/deciwatch/normalise.py`, which the nets were trained with.
 *
 * @param samples S·K·D values
 */
export function windowFrame(
  normalisation: Normalisation,
  samples: Float32Array,
  keypoints: number,
  dims: Dimensions,
): NetFrame {
  const origin = new Float64Array(dims);
  if (normalisation.kind === 'scale') return { origin, unit: normalisation.scale };
  const size = keypoints * dims;
  const count = samples.length / size;
  let unit = 0;
  for (let s = 0; s < count; s++) {
    let longest = 0;
    for (let d = 0; d < dims; d++) {
      let low = Number.POSITIVE_INFINITY;
      let high = Number.NEGATIVE_INFINITY;
      for (let i = s * size + d; i < (s + 1) * size; i += dims) {
        low = Math.min(low, samples[i]!);
        high = Math.max(high, samples[i]!);
      }
      origin[d]! += (low + high) / 2 / count;
      longest = Math.max(longest, high - low);
    }
    unit += longest / count;
  }
  return { origin, unit: Math.max(unit, MIN_BOX_PX) };
}

/** Poses to the nets' values; as many as came. */
export function toNet(poses: Float32Array, { origin, unit }: NetFrame): Float32Array<ArrayBuffer> {
  const dims = origin.length;
  return Float32Array.from(poses, (value, i) => (value - origin[i % dims]!) / unit);
}

/** The nets' values to poses: the inverse of `toNet`. */
export function fromNet(
  values: Float32Array,
  { origin, unit }: NetFrame,
): Float32Array<ArrayBuffer> {
  const dims = origin.length;
  return Float32Array.from(values, (value, i) => value * unit + origin[i % dims]!);
}
