import * as v from 'valibot';
import { fetchManifest, fileEntries } from '../download.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';

const count = v.pipe(v.number(), v.integer(), v.minValue(1));
const coefficient = v.pipe(v.number(), v.minValue(0));

const net = v.object({
  ...fileEntries,
  parameters: count,
  /** Of the polynomial in S (samples) and T (frames) that gives the FLOPs of one call. */
  flops: v.object({
    '1': coefficient,
    S: coefficient,
    SS: coefficient,
    T: coefficient,
    ST: coefficient,
    TT: coefficient,
  }),
});

const normalisation = v.variant('kind', [
  /** Values are divided by `scale`, in metres. */
  v.object({ kind: v.literal('scale'), scale: v.pipe(v.number(), v.minValue(1e-6)) }),
  /** Values are taken relative to the box of the window's samples. */
  v.object({ kind: v.literal('window-box') }),
]);

function pair<TDims extends 2 | 3>(dims: TDims) {
  return v.object({
    dims: v.literal(dims),
    skeleton: v.literal(BLAZEPOSE_33.name),
    keypoints: v.literal(BLAZEPOSE_33.joints.length),
    /** Seconds of one unit of the nets' time. */
    timeUnit: v.pipe(v.number(), v.minValue(1e-6)),
    normalisation,
    denoise: net,
    recover: net,
  });
}

const schema = v.object({
  format: v.literal('deciwatch-models/1'),
  pairs: v.object({ '3d': pair(3), '2d': pair(2) }),
});

/** What the engine reads of `models/manifest.json`: the two nets of each representation. */
export type ModelManifest = v.InferOutput<typeof schema>;

/** One representation's DenoiseNet and RecoverNet, and how to feed them. */
export type PairEntry = ModelManifest['pairs']['2d'] | ModelManifest['pairs']['3d'];

/** How poses become the numbers that the nets take. */
export type Normalisation = v.InferOutput<typeof normalisation>;

/**
 * Reads the models' manifest.
 * @throws DeciWatchError `model-missing` or `model-mismatch`
 */
export function fetchModelManifest(url: URL, signal?: AbortSignal): Promise<ModelManifest> {
  return fetchManifest(url, schema, signal);
}
