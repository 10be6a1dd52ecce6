import { expect, it } from 'vitest';
import { skeletonFrom } from '../../web/pose/skeleton.ts';
import { recoverCubic } from '../../web/recovery/cubic.ts';
import type { SeenSample } from '../../web/recovery/watched-clip.ts';

const HIPS = skeletonFrom('hips', ['left_hip', 'right_hip'], [[0, 1]]);

/** A cubic of time, which a cubic spline through its samples is. */
const path = (time: number, channel: number) =>
  100 + channel * 10 + 7 * time - 3 * (channel + 1) * time ** 2 + 0.5 * time ** 3;

function sample(frame: number, time: number, hasDepth = false): SeenSample {
  const values = (count: number) =>
    Float32Array.from({ length: count }, (_, channel) => path(time, channel));
  const scores = Float32Array.of(time / 10, 1 - time / 10);
  const keypoints3d = hasDepth ? values(6) : null;
  return { frame, estimate: { keypoints2d: values(4), keypoints3d, scores } };
}

/** Frames at uneven times; those named were watched, somebody in them. */
function clipOf(times: Float64Array, frames: readonly number[], every: number, hasDepth = false) {
  const seen = frames.map((frame) => sample(frame, times[frame]!, hasDepth));
  return { times, watched: frames, seen, every };
}

const UNEVEN = Float64Array.from({ length: 21 }, (_, t) => t / 30 + (t % 3) * 0.004);

it('goes through the samples in cubics, in 2D, scores in straight lines', () => {
  const { poses2d, poses3d } = recoverCubic(clipOf(UNEVEN, [0, 5, 10, 15, 20], 5), HIPS);
  expect(poses3d).toBeNull();
  expect(poses2d).toMatchObject({ dims: 2, skeleton: HIPS, times: UNEVEN });
  expect(Array.from(poses2d.watched).flatMap((flag, t) => (flag ? [t] : []))).toEqual([
    0, 5, 10, 15, 20,
  ]);
  UNEVEN.forEach((time, t) => {
    for (let channel = 0; channel < 4; channel++) {
      expect(poses2d.values[t * 4 + channel]).toBeCloseTo(path(time, channel), 3);
    }
    expect(poses2d.scores[t * 2]).toBeCloseTo(time / 10, 5);
    expect(poses2d.scores[t * 2 + 1]).toBeCloseTo(1 - time / 10, 5);
  });
});

it('has 3D where the samples have, about the mid-hip', () => {
  const { poses3d } = recoverCubic(clipOf(UNEVEN, [0, 5, 10, 15, 20], 5, true), HIPS);
  UNEVEN.forEach((time, t) => {
    for (let d = 0; d < 3; d++) {
      const half = (path(time, d) - path(time, d + 3)) / 2;
      expect(poses3d!.values[t * 6 + d]).toBeCloseTo(half, 3);
      expect(poses3d!.values[t * 6 + 3 + d]).toBeCloseTo(-half, 3);
    }
  });
});

it('leaves a skeleton without hips where it is', () => {
  const arm = skeletonFrom('arm', ['left_elbow', 'left_wrist'], [[0, 1]]);
  const { poses3d } = recoverCubic(clipOf(UNEVEN, [0, 5, 10, 15, 20], 5, true), arm);
  expect(poses3d!.values[0]).toBeCloseTo(path(0, 0), 4);
});

it('leaves long gaps, the time before the first and after the last sample empty', () => {
  const times = Float64Array.from({ length: 100 }, (_, t) => t / 30);
  // Three samples missing in a row, over 1.3 s; then a lone one.
  const clip = clipOf(times, [10, 20, 30, 70, 80], 10);
  const { poses2d } = recoverCubic({ ...clip, watched: [0, 10, 20, 30, 40, 50, 60, 70, 80] }, HIPS);
  const filled = Array.from(times.keys()).filter((t) => Number.isFinite(poses2d.values[t * 4]));
  const range = (from: number, to: number) =>
    Array.from({ length: to - from + 1 }, (_, i) => from + i);
  expect(filled).toEqual([...range(10, 30), ...range(70, 80)]);
  expect(poses2d.values.subarray(31 * 4, 70 * 4).every(Number.isNaN)).toBe(true);
  expect(poses2d.scores.subarray(31 * 2, 70 * 2).every((score) => score === 0)).toBe(true);
  expect(poses2d.watched[50]).toBe(1);
});

it('needs no more than one sample', () => {
  const { poses2d } = recoverCubic(clipOf(Float64Array.of(0, 1), [1], 1), HIPS);
  expect(poses2d.values[0]).toBeNaN();
  expect(poses2d.values[4]).toBeCloseTo(path(1, 0), 4);
});
