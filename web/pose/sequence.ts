import type { Skeleton } from './skeleton.ts';

/** D of a sequence: 2 for pixels, 3 for metres. */
export type Dimensions = 2 | 3;

/**
 * A pose for each of T frames. K joints, D dimensions.
 *
 * 2D values are pixels of the source frame as it is displayed (rotation applied), origin top left.
 * 3D values are metres relative to the mid-hip, in the axes that the skeleton's own file describes.
 * Where nobody was seen, a frame's values are NaN and its scores 0: never a zero pose.
 */
export interface PoseSequence {
  readonly skeleton: Skeleton;
  readonly dims: Dimensions;
  /** T times in seconds, strictly increasing: the file's own timestamps. */
  readonly times: Float64Array;
  /** T·K·D values. */
  readonly values: Float32Array;
  /** T·K scores, 0 to 1. */
  readonly scores: Float32Array;
  /** T flags: 1 where the estimator looked at the frame, 0 where the pose was recovered. */
  readonly watched: Uint8Array;
}

/**
 * One frame's K·D values, as a view on the sequence's memory.
 * @param frame its place in the sequence, from 0
 */
export function poseAt(sequence: PoseSequence, frame: number): Float32Array {
  const size = sequence.skeleton.joints.length * sequence.dims;
  return sequence.values.subarray(frame * size, (frame + 1) * size);
}

/**
 * Whether somebody was seen in a frame, or in the watched frames around it.
 * @param frame its place in the sequence, from 0
 */
export function hasPose(sequence: PoseSequence, frame: number): boolean {
  return Number.isFinite(poseAt(sequence, frame)[0]);
}

/**
 * The frame on screen at a time: the last one whose timestamp is not after it, or the first frame before
 * them all.
 * @param times T seconds, increasing
 * @param time seconds
 * @returns the frame's place in the sequence, from 0
 */
export function frameAtTime(times: Float64Array, time: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle]! <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}
