import { hasPose, type PoseSequence, poseAt } from '../pose/sequence.ts';

/** Half the window over which the hip's height is averaged: long enough to hide jitter, short enough to keep a step's bob. */
const SMOOTHING_S = 0.1;

/** How far from the lowest joint's centre the sole is. */
export const SOLE_M = 0.022;

const NEAR_GROUND_M = 0.2;

/** Where a person stands: what a 3D sequence relative to the mid-hip does not say. */
export interface Standing {
  /** T heights of the mid-hip above the ground, in metres; 0 where nobody was seen. */
  readonly hipHeights: Float32Array;
  /** Where the feet are on average, relative to the mid-hip: x and z in metres. A tilted camera makes people lean. */
  readonly feet: readonly [x: number, z: number];
  /** Metres from the ground to the top of the person, in all but the tallest twentieth of the frames. */
  readonly stature: number;
}

/**
 * Puts the lowest joint of every frame on the ground, smoothed over time within each stretch in which
 * somebody was seen.
 *
 * @param sequence 3D, metres, y up
 */
export function estimateStanding(sequence: PoseSequence): Standing {
  const frames = sequence.times.length;
  const lowest = new Float32Array(frames).fill(Number.NaN);
  const tops: number[] = [];
  const feet = { x: 0, z: 0, count: 0 };
  for (let frame = 0; frame < frames; frame++) {
    if (!hasPose(sequence, frame)) continue;
    const [low, high] = verticalExtent(poseAt(sequence, frame));
    lowest[frame] = low;
    tops.push(high - low);
    addFeet(feet, poseAt(sequence, frame), low);
  }
  const hipHeights = new Float32Array(frames);
  const half = Math.max(1, Math.round(SMOOTHING_S * frameRate(sequence.times)));
  for (let frame = 0; frame < frames; frame++) {
    if (Number.isNaN(lowest[frame]!)) continue;
    hipHeights[frame] = SOLE_M - meanAround(lowest, frame, half);
  }
  tops.sort((a, b) => a - b);
  const count = Math.max(1, feet.count);
  return {
    hipHeights,
    feet: [feet.x / count, feet.z / count],
    stature: tops[Math.floor((tops.length - 1) * 0.95)] ?? 1.7,
  };
}

/** The lowest and the highest joint of a pose, in metres. */
export function verticalExtent(pose: Float32Array): [low: number, high: number] {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (let y = 1; y < pose.length; y += 3) {
    low = Math.min(low, pose[y]!);
    high = Math.max(high, pose[y]!);
  }
  return [low, high];
}

/** Adds the places of the joints that are close to the ground. */
export function addFeet(
  feet: { x: number; z: number; count: number },
  pose: Float32Array,
  low: number,
) {
  for (let at = 0; at < pose.length; at += 3) {
    if (pose[at + 1]! > low + NEAR_GROUND_M) continue;
    feet.x += pose[at]!;
    feet.z += pose[at + 2]!;
    feet.count++;
  }
}

function frameRate(times: Float64Array): number {
  return times.length < 2 ? 1 : (times.length - 1) / (times.at(-1)! - times[0]!);
}

/** The mean of up to `half` values on each side, as many on one as on the other, none beyond a NaN. */
function meanAround(values: Float32Array, at: number, half: number): number {
  let sum = values[at]!;
  for (let step = 1; step <= half; step++) {
    const pair = (values[at - step] ?? Number.NaN) + (values[at + step] ?? Number.NaN);
    if (Number.isNaN(pair)) return sum / (2 * step - 1);
    sum += pair;
  }
  return sum / (2 * half + 1);
}
