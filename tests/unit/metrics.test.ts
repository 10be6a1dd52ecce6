import { describe, expect, it } from 'vitest';
import { accelError, mpjpe, pck } from '../../web/pose/metrics.ts';
import { readFixture } from './fixture.ts';

const shape = { joints: 2, dims: 2 };

/** Poses and truth [T·K·D], and their distance, added up joint by joint by other code. */
interface Case {
  readonly keypoints: number;
  readonly dims: number;
  readonly poses: number[];
  readonly truth: number[];
  readonly mpjpe: number;
  readonly accel: number;
  readonly pck?: Record<string, number>;
}

it('all agree with numbers worked out elsewhere', () => {
  const { cases } = readFixture<{ cases: Case[] }>('metrics.json');
  expect(cases.length).toBeGreaterThan(2);
  for (const { poses, truth, keypoints, dims, ...expected } of cases) {
    const layout = { joints: keypoints, dims };
    expect(mpjpe(poses, truth, layout)).toBeCloseTo(expected.mpjpe, 6);
    expect(accelError(poses, truth, layout)).toBeCloseTo(expected.accel, 6);
    for (const [alpha, share] of Object.entries(expected.pck ?? {})) {
      expect(pck(poses, truth, layout, Number(alpha))).toBeCloseTo(share, 9);
    }
  }
});

describe('mpjpe', () => {
  it('is the mean distance of the joints', () => {
    const predicted = [3, 4, 0, 0, /**/ 0, 0, 1, 0];
    expect(mpjpe(predicted, new Float32Array(8), shape)).toBeCloseTo((5 + 0 + 0 + 1) / 4, 12);
  });

  it('leaves frames with a NaN in either out', () => {
    const truth = [0, 0, 0, 0, /**/ 0, 0, NaN, 0, /**/ 0, 0, 0, 0];
    const predicted = [3, 4, 3, 4, /**/ 9, 9, 9, 9, /**/ NaN, NaN, NaN, NaN];
    expect(mpjpe(predicted, truth, shape)).toBe(5);
    expect(mpjpe(predicted, [NaN, ...truth.slice(1)], shape)).toBeNaN();
  });

  it('refuses sequences that cannot be compared', () => {
    expect(() => mpjpe([1, 2, 3, 4], [1, 2], shape)).toThrow(RangeError);
    expect(() => mpjpe([1, 2], [1, 2], shape)).toThrow(RangeError);
  });
});

describe('accelError', () => {
  const one = { joints: 1, dims: 2 };

  it('is blind to position and velocity, and sees second differences', () => {
    const truth = [0, 0, 0, 0, 0, 0, 0, 0];
    expect(accelError([5, 1, 6, 3, 7, 5, 8, 7], truth, one)).toBe(0);
    // x jumps by 3 and y by 4 in the last frame: only the last inner frame sees it.
    expect(accelError([0, 0, 0, 0, 0, 0, 3, 4], truth, one)).toBe(5 / 2);
  });

  it('leaves a missing frame and its neighbours out', () => {
    const truth = new Float64Array(14);
    const predicted = [0, 0, 9, 9, NaN, NaN, 9, 9, 0, 0, 3, 4, 0, 0];
    // Frames 4 and 5 count: second differences (3 + 9, 4 + 9) and (−6, −8).
    expect(accelError(predicted, truth, one)).toBeCloseTo((Math.hypot(12, 13) + 10) / 2, 12);
  });
});

describe('pck', () => {
  it("counts joints within alpha of the true box's longer side", () => {
    // The box is 10 wide and 4 high; at 0.2 the reach is 2.
    const truth = [0, 0, 10, 4];
    expect(pck([2, 0, 10, 6.1], truth, shape, 0.2)).toBe(0.5);
    expect(pck([2, 0, 10, 6.1], truth, shape, 0.3)).toBe(1);
    expect(pck([2, 0, 10, 6.1], truth, shape, 0.1)).toBe(0);
  });

  it("takes each frame's own box and leaves missing frames out", () => {
    const truth = [0, 0, 10, 4, /**/ 0, 0, 100, 4, /**/ 0, 0, 1, 1];
    const predicted = [3, 0, 10, 4, /**/ 3, 0, 100, 4, /**/ NaN, NaN, NaN, NaN];
    expect(pck(predicted, truth, shape, 0.2)).toBe(3 / 4);
  });
});
