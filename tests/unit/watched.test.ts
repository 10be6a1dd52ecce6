import { expect, it } from 'vitest';
import { DeciWatchError } from '../../web/errors.ts';
import { watchedFrames } from '../../web/sampling/watched.ts';

it('watches one frame in N and the last', () => {
  expect([...watchedFrames(21, 10)]).toEqual([0, 10, 20]);
  expect([...watchedFrames(22, 10)]).toEqual([0, 10, 20, 21]);
  expect([...watchedFrames(4, 1)]).toEqual([0, 1, 2, 3]);
});

it('copes with clips of no, one and two frames at every N', () => {
  for (let every = 1; every <= 20; every++) {
    expect([...watchedFrames(0, every)]).toEqual([]);
    expect([...watchedFrames(1, every)]).toEqual([0]);
    expect([...watchedFrames(2, every)]).toEqual([0, 1]);
  }
});

it.each([0, -1, 21, 2.5, NaN, Infinity])('refuses N = %s', (every) => {
  expect(() => watchedFrames(100, every)).toThrow(DeciWatchError);
  expect(() => watchedFrames(100, every)).toThrow(/from 1 to 20/);
});
