import { expect, it } from 'vitest';
import { faultIn } from '../../web/estimators/check-estimate.ts';

const sound = {
  keypoints2d: Float32Array.of(1, 2, 3, 4),
  keypoints3d: null as Float32Array | null,
  scores: Float32Array.of(0, 1),
};

it('lets poses pass, with and without 3D, and nobody', () => {
  expect(faultIn(sound, 2)).toBeNull();
  expect(faultIn({ ...sound, keypoints3d: new Float32Array(6) }, 2)).toBeNull();
  expect(faultIn(null, 2)).toBeNull();
});

it.each<[string, unknown, string]>([
  ['no answer', undefined, 'the answer should be a pose or null, but is undefined'],
  ['a word', 'nobody', 'the answer should be a pose or null, but is nobody'],
  ['nothing in it', {}, 'keypoints2d should be a Float32Array of 4 numbers, but is undefined'],
  [
    'a list',
    { ...sound, keypoints2d: [1, 2, 3, 4] },
    'keypoints2d should be a Float32Array of 4 numbers, but is an Array',
  ],
  [
    'too few',
    { ...sound, keypoints2d: new Float32Array(3) },
    'keypoints2d should be a Float32Array of 4 numbers, but has 3',
  ],
  [
    'too few in 3D',
    { ...sound, keypoints3d: new Float32Array(4) },
    'keypoints3d should be a Float32Array of 6 numbers, but has 4',
  ],
  [
    'scores for others',
    { ...sound, scores: new Float32Array(3) },
    'scores should be a Float32Array of 2 numbers, but has 3',
  ],
  [
    'NaN',
    { ...sound, keypoints2d: Float32Array.of(1, NaN, 3, 4) },
    'keypoints2d should be finite, but keypoints2d[1] is NaN',
  ],
  [
    'infinity',
    { ...sound, keypoints3d: new Float32Array(6).fill(-Infinity) },
    'keypoints3d should be finite, but keypoints3d[0] is -Infinity',
  ],
  [
    'percent',
    { ...sound, scores: Float32Array.of(0.5, 50) },
    'scores should be from 0 to 1, but scores[1] is 50',
  ],
])('says what is wrong: %s', (_, answer, fault) => {
  expect(faultIn(answer, 2)).toBe(fault);
});
