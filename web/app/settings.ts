import { DEFAULT_ESTIMATOR, type EstimatorName } from '../estimators/names.ts';

/** What a person chooses on the page. */
export interface Settings {
  /** N: one frame in N is watched. */
  readonly every: number;
  readonly estimator: EstimatorName;
}

export const MIN_EVERY = 1;
export const MAX_EVERY = 20;

export const DEFAULT_SETTINGS: Settings = { every: 10, estimator: DEFAULT_ESTIMATOR };

/** N moved by a step and kept in range. */
export function stepEvery(settings: Settings, by: number): Settings {
  const every = Math.min(MAX_EVERY, Math.max(MIN_EVERY, settings.every + by));
  return { ...settings, every };
}
