import { describe, expect, it } from 'vitest';
import { fromNet, toNet, windowFrame } from '../../web/recovery/normalise.ts';
import fixture from '../fixtures/normalise.json';

function expectClose(actual: ArrayLike<number>, expected: readonly number[], tolerance: number) {
  expect(actual.length).toBe(expected.length);
  for (const [i, value] of expected.entries()) {
    expect(Math.abs(actual[i]! - value)).toBeLessThanOrEqual(tolerance);
  }
}

describe('2D: the window box', () => {
  it.each(fixture.windowBox)('$samples samples of $keypoints keypoints', (box) => {
    const pixels = Float32Array.from(box.pixels);
    const frame = windowFrame({ kind: 'window-box' }, pixels, box.keypoints, 2);
    expectClose(frame.origin, box.centre, 1e-3);
    expect(frame.unit).toBeCloseTo(box.scale, 3);
    const values = toNet(pixels, frame);
    expectClose(values, box.normalised, 1e-5);
    expectClose(fromNet(values, frame), box.pixels, 1e-3);
  });

  it('of a pose without any size is one pixel, so that values stay finite', () => {
    const point = Float32Array.of(5, 7, 5, 7);
    const frame = windowFrame({ kind: 'window-box' }, point, 2, 2);
    expect(Array.from(toNet(point, frame))).toEqual([0, 0, 0, 0]);
  });
});

it('3D: metres by a constant scale, the mid-hip where it is', () => {
  const { metres, scale, normalised } = fixture.scale;
  const poses = Float32Array.from(metres);
  const frame = windowFrame({ kind: 'scale', scale }, poses, metres.length / 3, 3);
  const values = toNet(poses, frame);
  expectClose(values, normalised, 1e-6);
  expectClose(fromNet(values, frame), metres, 1e-6);
});
