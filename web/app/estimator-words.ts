import { engineFiles } from '../engine/files.ts';
import { type EstimatorManifest, fetchEstimatorManifest } from '../estimators/manifest.ts';
import type { EstimatorName } from '../estimators/names.ts';

/** What each variant means to somebody who chooses one. */
export const ESTIMATOR_WORDS: Readonly<Record<EstimatorName, { label: string; meaning: string }>> =
  {
    lite: { label: 'Lite', meaning: 'quickest' },
    full: { label: 'Full', meaning: 'balanced' },
    heavy: { label: 'Heavy', meaning: 'most accurate' },
  };

/** Download size and FLOPs of each variant, from the site's own manifest. */
export async function fetchEstimatorFigures(): Promise<EstimatorManifest['estimators']> {
  return (await fetchEstimatorManifest(engineFiles().estimators)).estimators;
}
