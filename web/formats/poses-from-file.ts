import type { Dimensions, PoseSequence } from '../pose/sequence.ts';
import { type Skeleton, sideOf } from '../pose/skeleton.ts';
import type { PoseFile } from './pose-file-types.ts';

/** The two sequences in a pose file that `parsePoseFile` has let through. */
export function posesFromFile(file: PoseFile): { poses2d: PoseSequence; poses3d: PoseSequence } {
  const skeleton = skeletonOf(file);
  const joints = skeleton.joints.length;
  const scores = file.frames.map((frame) => frame.scores);
  const shared = {
    skeleton,
    times: Float64Array.from(file.frames, (frame) => frame.time),
    scores: flatten(scores, joints, 0),
    watched: Uint8Array.from(file.frames, (frame) => (frame.watched ? 1 : 0)),
  };
  const sequence = (dims: Dimensions, field: 'keypoints2d' | 'keypoints3d'): PoseSequence => {
    const rows = file.frames.map((frame) => frame[field]?.flat() ?? null);
    return { ...shared, dims, values: flatten(rows, joints * dims, NaN) };
  };
  return { poses2d: sequence(2, 'keypoints2d'), poses3d: sequence(3, 'keypoints3d') };
}

/** T rows of `size` numbers in one array; rows that are null are filled with `missing`. */
function flatten(rows: readonly (number[] | null)[], size: number, missing: number): Float32Array {
  const out = new Float32Array(rows.length * size).fill(missing);
  rows.forEach((row, t) => {
    if (row) out.set(row, t * size);
  });
  return out;
}

/** The skeleton with what the file leaves out: sides by the joints' names, the hips as the root. */
function skeletonOf({ skeleton: { name, joints, bones } }: PoseFile): Skeleton {
  const root = ['left_hip', 'right_hip'].map((hip) => joints.indexOf(hip));
  return { name, joints, bones, sides: joints.map(sideOf), root: root.filter((hip) => hip >= 0) };
}
