/** How T·K·D values are laid out: frame by frame, in each joint by joint. */
export interface PoseShape {
  /** K */
  readonly joints: number;
  /** D */
  readonly dims: number;
}

/**
 * Mean Per Joint Position Error: the mean distance between predicted and true joints, in the unit of
 * the values. Frames with a NaN in either are left out.
 *
 * @param predicted T·K·D values
 * @param truth T·K·D values
 * @returns NaN if no frame counts
 * @throws RangeError where the two are not of one length, or not of whole frames
 */
export function mpjpe(
  predicted: ArrayLike<number>,
  truth: ArrayLike<number>,
  shape: PoseShape,
): number {
  const frames = comparableFrames(predicted, truth, shape);
  return meanOverJoints(frames, shape, (at) =>
    lengthOf(at, shape, (d) => predicted[d]! - truth[d]!),
  );
}

/**
 * Mean acceleration error: the mean, over joints and inner frames, of the distance between the second
 * differences over time of prediction and truth, in units per frame². A frame counts if neither it nor
 * a neighbour has a NaN.
 *
 * @param predicted T·K·D values, of frames evenly spaced in time
 * @param truth T·K·D values, of the same frames
 * @returns NaN if no frame counts
 * @throws RangeError where the two are not of one length, or not of whole frames
 * @see https://arxiv.org/abs/1812.01601 (HMMR), section 4.1
 */
export function accelError(
  predicted: ArrayLike<number>,
  truth: ArrayLike<number>,
  shape: PoseShape,
): number {
  const size = shape.joints * shape.dims;
  const comparable = new Set(comparableFrames(predicted, truth, shape));
  const inner = [...comparable].filter((t) => comparable.has(t - 1) && comparable.has(t + 1));
  const bend = (values: ArrayLike<number>, d: number) =>
    values[d - size]! - 2 * values[d]! + values[d + size]!;
  return meanOverJoints(inner, shape, (at) =>
    lengthOf(at, shape, (d) => bend(predicted, d) - bend(truth, d)),
  );
}

/**
 * Percentage of Correct Keypoints, as a fraction from 0 to 1: how many predicted joints are no further
 * from the truth than `alpha` times the longer side of the box around the frame's true joints. Frames
 * with a NaN in either are left out.
 *
 * @param predicted T·K·D values
 * @param truth T·K·D values
 * @param alpha 0.2, 0.1 or 0.05 in the paper's tables
 * @returns NaN if no frame counts
 * @throws RangeError where the two are not of one length, or not of whole frames
 */
export function pck(
  predicted: ArrayLike<number>,
  truth: ArrayLike<number>,
  shape: PoseShape,
  alpha: number,
): number {
  const frames = comparableFrames(predicted, truth, shape);
  const size = shape.joints * shape.dims;
  const correct = frames.map((t) => {
    const reach = alpha * longestSide(truth, t * size, shape);
    return meanOverJoints([t], shape, (at) => {
      const distance = lengthOf(at, shape, (d) => predicted[d]! - truth[d]!);
      return distance <= reach ? 1 : 0;
    });
  });
  return correct.reduce((sum, share) => sum + share, 0) / correct.length;
}

/** The length of a joint's vector whose D components `component` gives, from index `at` on. */
function lengthOf(at: number, { dims }: PoseShape, component: (d: number) => number): number {
  let squares = 0;
  for (let d = at; d < at + dims; d++) squares += component(d) ** 2;
  return Math.sqrt(squares);
}

/** The longest side of the box around one frame's joints. */
function longestSide(values: ArrayLike<number>, start: number, { joints, dims }: PoseShape) {
  let longest = 0;
  for (let d = 0; d < dims; d++) {
    let low = Infinity;
    let high = -Infinity;
    for (let k = 0; k < joints; k++) {
      const value = values[start + k * dims + d]!;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    longest = Math.max(longest, high - low);
  }
  return longest;
}

/** The frames without a NaN in either sequence. */
function comparableFrames(a: ArrayLike<number>, b: ArrayLike<number>, shape: PoseShape): number[] {
  const size = shape.joints * shape.dims;
  if (a.length !== b.length || a.length % size !== 0) {
    throw new RangeError(
      `Sequences of ${a.length} and ${b.length} values cannot be compared in frames of ${size}.`,
    );
  }
  const frames: number[] = [];
  for (let t = 0; t < a.length / size; t++) {
    let isWhole = true;
    for (let d = t * size; d < (t + 1) * size; d++) {
      isWhole &&= !Number.isNaN(a[d]) && !Number.isNaN(b[d]);
    }
    if (isWhole) frames.push(t);
  }
  return frames;
}

/** The mean of `measure` over all joints of the frames; it gets the index of a joint's first value. */
function meanOverJoints(
  frames: readonly number[],
  { joints, dims }: PoseShape,
  measure: (at: number) => number,
): number {
  let sum = 0;
  for (const t of frames) {
    for (let k = 0; k < joints; k++) sum += measure((t * joints + k) * dims);
  }
  return sum / (frames.length * joints);
}
