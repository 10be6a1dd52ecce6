import { expect, it } from 'vitest';
import { interpolateScores } from '../../web/recovery/scores.ts';

const K = 33;

function sample(frame: number, score: number) {
  const scores = new Float32Array(K).fill(score);
  const estimate = { keypoints2d: new Float32Array(), keypoints3d: new Float32Array(), scores };
  return { frame, estimate };
}

it('runs in straight lines of time between samples, and is 0 where no window reaches', () => {
  const scores = interpolateScores(
    {
      times: Float64Array.of(0, 1, 3, 4, 5, 6, 7),
      seen: [sample(0, 0.2), sample(3, 1), sample(6, 0.4)],
    },
    [
      { samples: [0, 1], firstFrame: 0, lastFrame: 3 },
      { samples: [2], firstFrame: 6, lastFrame: 6 },
    ],
  );
  const first = Array.from({ length: 7 }, (_, frame) => scores[frame * K]);
  for (const [frame, score] of [0.2, 0.4, 0.8, 1, 0, 0, 0.4].entries()) {
    expect(first[frame]).toBeCloseTo(score, 6);
  }
  expect(scores.slice(K, 2 * K)).toEqual(new Float32Array(K).fill(first[1]!));
});
