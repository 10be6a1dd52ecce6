import type { PoseEstimate } from '../../estimators/estimator.ts';

/** The best third of a body's scores must reach this on the average: a face alone is enough. */
const LEAST_SCORE = 0.5;
const SHARE = 1 / 3;

/** Whether an estimate is of somebody: an estimator that sees next to nothing guesses all the same. */
export function isSomebody<T extends PoseEstimate>(estimate: T | null): estimate is T {
  if (!estimate) return false;
  const best = [...estimate.scores].sort((a, b) => b - a);
  const counted = best.slice(0, Math.max(1, Math.round(best.length * SHARE)));
  return counted.reduce((sum, score) => sum + score, 0) / counted.length >= LEAST_SCORE;
}
