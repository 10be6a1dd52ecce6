import type { Dimensions, PoseSequence } from '../pose/sequence.ts';
import { skeletonFrom } from '../pose/skeleton.ts';
import type { PoseFile } from './pose-file-types.ts';

/**
 * The sequences in a pose file that `parsePoseFile` has let through. What the file leaves out of the
 * skeleton is worked out from the joints' names.
 * @returns no 3D sequence where somebody was seen, but never in 3D
 */
export function posesFromFile(file: PoseFile): {
  poses2d: PoseSequence;
  poses3d: PoseSequence | null;
} {
  const { name, joints: names, bones } = file.skeleton;
  const skeleton = skeletonFrom(name, names, bones);
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
  const isFlat = file.frames.some((frame) => frame.keypoints2d !== null && !frame.keypoints3d);
  return {
    poses2d: sequence(2, 'keypoints2d'),
    poses3d: isFlat ? null : sequence(3, 'keypoints3d'),
  };
}

/** T rows of `size` numbers in one array; rows that are null are filled with `missing`. */
function flatten(rows: readonly (number[] | null)[], size: number, missing: number): Float32Array {
  const out = new Float32Array(rows.length * size).fill(missing);
  rows.forEach((row, t) => {
    if (row) out.set(row, t * size);
  });
  return out;
}
