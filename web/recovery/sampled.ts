import type { SpatialEstimate } from '../estimators/estimator.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import type { InputName, PairEntry } from './manifest.ts';
import { type NetFrame, toNet, windowFrame } from './normalise.ts';
import type { Matrix } from './runtime.ts';

const KEYPOINTS = BLAZEPOSE_33.joints.length;

/** Numbers of each keypoint, and where an estimate has them. */
const SOURCES = {
  '3d': { dims: 3, of: (estimate: SpatialEstimate) => estimate.keypoints3d },
  '2d': { dims: 2, of: (estimate: SpatialEstimate) => estimate.keypoints2d },
  scores: { dims: 1, of: (estimate: SpatialEstimate) => estimate.scores },
} as const;

const AS_IT_IS: NetFrame = { origin: Float64Array.of(0), unit: 1 };

/** DenoiseNet's input for one window, and the frame of the poses that the nets give back. */
export interface Sampled {
  /** 1 × S × I: the blocks that the pair's `inputs` name, side by side. */
  readonly sampled: Matrix;
  readonly frame: NetFrame;
}

/**
 * Puts the S estimates of a window side by side as its pair of nets wants them, each block in a frame
 * of its own. The same as `sampled_values` in `export/deciwatch/normalise.py`, which the nets were
 * trained with.
 */
export function buildSampled(
  { inputs, normalisation }: Pick<PairEntry, 'inputs' | 'normalisation'>,
  samples: readonly SpatialEstimate[],
): Sampled {
  const frameOf = (name: InputName, values: Float32Array): NetFrame => {
    if (name === 'scores') return AS_IT_IS;
    // A manifest without it is turned away when it is read.
    return windowFrame(normalisation[name]!, values, KEYPOINTS, SOURCES[name].dims);
  };
  const blocks = inputs.map((name) => {
    const values = joined(samples.map(SOURCES[name].of));
    const frame = frameOf(name, values);
    return { frame, values: toNet(values, frame), size: KEYPOINTS * SOURCES[name].dims };
  });
  const width = blocks.reduce((sum, { size }) => sum + size, 0);
  const data = new Float32Array(samples.length * width);
  for (let s = 0; s < samples.length; s++) {
    let start = s * width;
    for (const { values, size } of blocks) {
      data.set(values.subarray(s * size, (s + 1) * size), start);
      start += size;
    }
  }
  return { sampled: { data, dims: [1, samples.length, width] }, frame: blocks[0]!.frame };
}

function joined(parts: readonly Float32Array[]): Float32Array {
  const size = parts[0]?.length ?? 0;
  const all = new Float32Array(parts.length * size);
  parts.forEach((part, i) => {
    all.set(part, i * size);
  });
  return all;
}
