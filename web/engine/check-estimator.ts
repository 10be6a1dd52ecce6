import { DeciWatchError } from '../errors.ts';
import { ESTIMATOR_NAMES } from '../estimators/names.ts';

/**
 * For callers whom no compiler has told.
 * @throws DeciWatchError `bad-option` where it is not the name of one
 */
export function checkEstimator(name: unknown): void {
  if (ESTIMATOR_NAMES.some((known) => known === name)) return;
  if (typeof name === 'object' && name !== null) {
    throw new DeciWatchError(
      'bad-option',
      `Live playback takes no estimator of your own; choose one of ${ESTIMATOR_NAMES.join(', ')}.`,
    );
  }
  const given = typeof name === 'function' ? 'a function' : name;
  throw new DeciWatchError(
    'bad-option',
    `The estimator is ${given}; choose one of ${ESTIMATOR_NAMES.join(', ')}.`,
  );
}
