/** The MediaPipe Pose variants that the project ships, from the quickest to the most accurate. */
export const ESTIMATOR_NAMES = ['lite', 'full', 'heavy'] as const;

export type EstimatorName = (typeof ESTIMATOR_NAMES)[number];

export const DEFAULT_ESTIMATOR: EstimatorName = 'full';
