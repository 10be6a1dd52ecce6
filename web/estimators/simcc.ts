import { type DecodedKeypoints, peakIndex } from './peak.ts';

/**
 * Finds each keypoint at the peaks of its two distributions, over x and over y (SimCC: RTMPose and others).
 * Its score is the lower of the two peaks.
 *
 * @param x K·Wx values
 * @param y K·Wy values
 * @param keypoints K
 * @param splitRatio bins for each pixel of the model's input: 2 for RTMPose
 * @returns positions as indices of the input's pixels (0: the first one itself): a bin's index over
 *   `splitRatio`
 * @throws RangeError where the values cannot be spread over K keypoints, or the ratio is not above 0
 * @see https://arxiv.org/abs/2107.03332
 */
export function decodeSimcc(
  x: Float32Array,
  y: Float32Array,
  keypoints: number,
  splitRatio: number,
): DecodedKeypoints {
  if (!(splitRatio > 0)) throw new RangeError(`The split ratio is ${splitRatio}; it is above 0.`);
  const positions = new Float32Array(keypoints * 2);
  const scores = new Float32Array(keypoints).fill(Number.POSITIVE_INFINITY);
  for (const [axis, values] of [x, y].entries()) {
    const bins = values.length / keypoints;
    if (bins === 0 || !Number.isInteger(bins)) {
      throw new RangeError(`${values.length} values cannot be spread over ${keypoints} keypoints.`);
    }
    for (let k = 0; k < keypoints; k++) {
      const peak = peakIndex(values, k * bins, (k + 1) * bins);
      positions[k * 2 + axis] = (peak - k * bins) / splitRatio;
      scores[k] = Math.min(scores[k]!, values[peak]!);
    }
  }
  return { positions, scores };
}
