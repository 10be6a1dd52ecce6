import { expect, it } from 'vitest';
import { frameAtTime } from '../../web/pose/sequence.ts';

it('finds the last frame that is not after a time', () => {
  const times = Float64Array.of(0.1, 0.2, 0.25, 0.9);
  const frames = [-5, 0.1, 0.19, 0.2, 0.3, 0.9, 60].map((time) => frameAtTime(times, time));
  expect(frames).toEqual([0, 0, 0, 1, 2, 3, 3]);
  expect(frameAtTime(Float64Array.of(7), 3)).toBe(0);
});
