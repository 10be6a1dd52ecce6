import { ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';
import { MAX_INTERVAL, MIN_INTERVAL } from '../sampling/watched.ts';

/** A command line that cannot be followed; the message is one sentence for people. */
export class UsageError extends Error {
  override readonly name = 'UsageError';
}

/** N from the command line: a whole number within the nets' range. */
export function parseEvery(text: string): number {
  const every = Number(text);
  if (!Number.isInteger(every) || every < MIN_INTERVAL || every > MAX_INTERVAL) {
    throw new UsageError(
      `--every wants a whole number from ${MIN_INTERVAL} to ${MAX_INTERVAL}, not "${text}".`,
    );
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
