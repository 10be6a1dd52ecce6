import { type DecodedKeypoints, peakIndex } from './peak.ts';

/** How K heatmaps of one person are laid out. */
export interface HeatmapShape {
  /** K. */
  readonly keypoints: number;
  /** Cells. */
  readonly width: number;
  readonly height: number;
}

/** How far a peak is moved towards its higher neighbour, in cells. */
const SHIFT = 0.25;

/**
 * Finds each keypoint at its heatmap's peak, moved by a quarter of a cell towards the higher of the two
 * neighbours in x, and likewise in y; at the border there is but one neighbour, and no shift.
 *
 * @param heatmaps K·H·W values
 * @returns positions in cells: (0, 0) is the first cell itself. SimpleBaseline, HRNet and ViTPose are
 *   trained with a cell's index × stride being the index of a pixel of the input.
 * @throws RangeError where the values do not fill the shape
 * @see https://arxiv.org/abs/1603.06937 (stacked hourglass networks), section 3.3
 */
export function decodeHeatmaps(
  heatmaps: Float32Array,
  { keypoints, width, height }: HeatmapShape,
): DecodedKeypoints {
  const size = width * height;
  if (size === 0 || heatmaps.length !== keypoints * size) {
    throw new RangeError(
      `${heatmaps.length} values do not fill ${keypoints} heatmaps of ${width} × ${height}.`,
    );
  }
  const positions = new Float32Array(keypoints * 2);
  const scores = new Float32Array(keypoints);
  for (let k = 0; k < keypoints; k++) {
    const peak = peakIndex(heatmaps, k * size, (k + 1) * size);
    const x = (peak - k * size) % width;
    const y = Math.floor((peak - k * size) / width);
    positions[k * 2] = x + shift(heatmaps, peak, 1, x, width);
    positions[k * 2 + 1] = y + shift(heatmaps, peak, width, y, height);
    scores[k] = heatmaps[peak]!;
  }
  return { positions, scores };
}

/** @param step from a cell to its neighbour; `at` is the cell's place among `cells` in that direction */
function shift(
  values: Float32Array,
  peak: number,
  step: number,
  at: number,
  cells: number,
): number {
  if (at === 0 || at === cells - 1) return 0;
  return SHIFT * (Math.sign(values[peak + step]! - values[peak - step]!) || 0);
}
