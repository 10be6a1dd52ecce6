import { DEFAULT_ESTIMATOR, type EstimatorName } from '../estimators/names.ts';
import { DEFAULT_INTERVAL, MAX_INTERVAL, MIN_INTERVAL } from '../sampling/watched.ts';

/** What a person chooses on the page. */
export interface Settings {
  /** N: one frame in N is watched. */
  readonly every: number;
  readonly estimator: EstimatorName;
}

export const DEFAULT_SETTINGS: Settings = { every: DEFAULT_INTERVAL, estimator: DEFAULT_ESTIMATOR };

/** N moved by a step and kept in range. */
export function stepEvery(settings: Settings, by: number): Settings {
  const every = Math.min(MAX_INTERVAL, Math.max(MIN_INTERVAL, settings.every + by));
  return { ...settings, every };
}

export function isSame(one: Settings, other: Settings | undefined): boolean {
  return one.every === other?.every && one.estimator === other.estimator;
}
