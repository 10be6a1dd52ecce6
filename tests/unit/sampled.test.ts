import { expect, it } from 'vitest';
import type { PairEntry } from '../../web/recovery/manifest.ts';
import { buildSampled } from '../../web/recovery/sampled.ts';

const NORMALISATION: PairEntry['normalisation'] = {
  '3d': { kind: 'scale', scale: 0.5 },
  '2d': { kind: 'window-box' },
};

/** Every x is `from` apart from one that is `to`, so that the box is as wide as they are apart. */
function estimate(from: number, to: number, depth: number, score: number) {
  const keypoints2d = new Float32Array(33 * 2).fill(from);
  keypoints2d[0] = to;
  return {
    keypoints2d,
    keypoints3d: new Float32Array(33 * 3).fill(depth),
    scores: new Float32Array(33).fill(score),
  };
}

const samples = [estimate(100, 200, 0.25, 0.5), estimate(200, 500, 1, 1)];

it('puts the blocks of each sample side by side, each in its own frame', () => {
  const { sampled, frame } = buildSampled(
    { inputs: ['3d', '2d', 'scores'], normalisation: NORMALISATION },
    samples,
  );
  expect(sampled.dims).toEqual([1, 2, 33 * 6]);
  expect(frame).toEqual({ origin: new Float64Array(3), unit: 0.5 });
  // Boxes: 100 and 300 wide, the middles at x = 150 and 350; y lies at 100 and at 200 in both.
  const first = sampled.data.subarray(0, 33 * 6);
  const second = sampled.data.subarray(33 * 6);
  expect([first[0], first[98], second[0], second[98]]).toEqual([0.5, 0.5, 2, 2]);
  expect([first[99], first[100], first[101], first[164]]).toEqual([-0.25, -0.25, -0.75, -0.25]);
  expect([second[99], second[100], second[101], second[164]]).toEqual([1.25, 0.25, -0.25, 0.25]);
  expect([first[165], first[197], second[165], second[197]]).toEqual([0.5, 0.5, 1, 1]);
});

it('gives the frame of the first block, in which the nets answer', () => {
  const { sampled, frame } = buildSampled(
    { inputs: ['2d', 'scores'], normalisation: { '2d': { kind: 'window-box' } } },
    samples,
  );
  expect(sampled.dims).toEqual([1, 2, 33 * 3]);
  expect(frame).toEqual({ origin: Float64Array.of(250, 150), unit: 200 });
});
