/** What a model's maps say of K keypoints. */
export interface DecodedKeypoints {
  /** K·2 positions, x then y; in which unit, the decoder says. */
  readonly positions: Float32Array;
  /** K values of the peaks, as the model gave them: not every model's end at 1. */
  readonly scores: Float32Array;
}

/** The index of the greatest of `values[start]` to `values[end - 1]`; of several, the first. */
export function peakIndex(values: Float32Array, start: number, end: number): number {
  let best = start;
  for (let i = start + 1; i < end; i++) {
    if (values[i]! > values[best]!) best = i;
  }
  return best;
}
