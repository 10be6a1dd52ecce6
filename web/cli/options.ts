import { ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';

/** A command line that cannot be followed; the message is one sentence for people. */
export class UsageError extends Error {
  override readonly name = 'UsageError';
}

/** N from the command line: a whole number from 1 to 20. */
export function parseEvery(text: string): number {
  const every = Number(text);
  if (!Number.isInteger(every) || every < 1 || every > 20) {
    throw new UsageError(`--every wants a whole number from 1 to 20, not "${text}".`);
  }
  return every;
}

/** The estimator's name from the command line. */
export function parseEstimator(text: string): EstimatorName {
  const name = ESTIMATOR_NAMES.find((known) => known === text);
  if (!name) {
    throw new UsageError(`--estimator wants one of ${ESTIMATOR_NAMES.join(', ')}, not "${text}".`);
  }
  return name;
}
