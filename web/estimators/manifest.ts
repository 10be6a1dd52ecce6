import * as v from 'valibot';
import { type FileSet, fetchManifest, fileEntries } from '../download.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import { ESTIMATOR_NAMES } from './names.ts';

const flops = v.pipe(v.number(), v.minValue(1));

const estimator = v.object({
  ...fileEntries,
  flops: v.object({ detector: flops, landmarks: flops, perCall: flops }),
});

const schema = v.object({
  format: v.literal('deciwatch-estimators/1'),
  skeleton: v.literal(BLAZEPOSE_33.name),
  estimators: v.object(
    Object.fromEntries(ESTIMATOR_NAMES.map((name) => [name, estimator])) as Record<
      (typeof ESTIMATOR_NAMES)[number],
      typeof estimator
    >,
  ),
});

/** What `estimators/manifest.json` says: one bundle for each variant, and the FLOPs of its nets. */
export type EstimatorManifest = v.InferOutput<typeof schema>;

/**
 * Reads the estimators' manifest.
 * @throws DeciWatchError `model-missing` or `model-mismatch`
 */
export function fetchEstimatorManifest(
  set: FileSet,
  signal?: AbortSignal,
): Promise<EstimatorManifest> {
  return fetchManifest(set, schema, signal);
}
