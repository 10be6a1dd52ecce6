/** The MediaPipe Pose variants that the project ships, from the quickest to the most accurate. */
export const ESTIMATOR_NAMES = ['lite', 'full', 'heavy'] as const;

/** One of {@link ESTIMATOR_NAMES}. */
export type EstimatorName = (typeof ESTIMATOR_NAMES)[number];

/** What the demo and the player choose. */
export const DEFAULT_ESTIMATOR: EstimatorName = 'full';
