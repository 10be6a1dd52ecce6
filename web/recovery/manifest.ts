import * as v from 'valibot';
import { type FileSet, fetchManifest, fileEntries } from '../download.ts';
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

/** Values are divided by `scale`, in metres. */
const metres = v.object({ kind: v.literal('scale'), scale: v.pipe(v.number(), v.minValue(1e-6)) });

/** Values are taken relative to the box of the window's samples. */
const pixels = v.object({ kind: v.literal('window-box') });

const inputName = v.picklist(['3d', '2d', 'scores']);

function pair<TDims extends 2 | 3>(dims: TDims) {
  const entry = v.object({
    dims: v.literal(dims),
    skeleton: v.literal(BLAZEPOSE_33.name),
    keypoints: v.literal(BLAZEPOSE_33.joints.length),
    /** Seconds of one unit of the nets' time. */
    timeUnit: v.pipe(v.number(), v.minValue(1e-6)),
    /** What stands side by side in DenoiseNet's `sampled`; the pair's own poses come first. */
    inputs: v.tupleWithRest([v.literal(`${dims}d`)], inputName),
    /** Of the poses among the inputs; scores are taken as they are. */
    normalisation: v.object({ '3d': v.optional(metres), '2d': v.optional(pixels) }),
    denoise: net,
    recover: net,
    /** Poses after the last sample, for live playback; not every pair has one. */
    forecast: v.optional(net),
  });
  return v.pipe(
    entry,
    v.check(
      ({ inputs, normalisation }) =>
        inputs.every((name) => name === 'scores' || normalisation[name] !== undefined),
      'an input has no normalisation',
    ),
  );
}

const schema = v.object({
  format: v.literal('deciwatch-models/2'),
  pairs: v.object({ '3d': pair(3), '2d': pair(2) }),
});

/** What the engine reads of `models/manifest.json`: the two nets of each representation. */
export type ModelManifest = v.InferOutput<typeof schema>;

/** One representation's DenoiseNet and RecoverNet, and how to feed them. */
export type PairEntry = ModelManifest['pairs']['2d'] | ModelManifest['pairs']['3d'];

/** Something that DenoiseNet is given of every sample. */
export type InputName = v.InferOutput<typeof inputName>;

/** How poses become the numbers that the nets take. */
export type Normalisation = v.InferOutput<typeof metres> | v.InferOutput<typeof pixels>;

/**
 * Reads the models' manifest.
 * @throws DeciWatchError `model-missing` or `model-mismatch`
 */
export function fetchModelManifest(set: FileSet, signal?: AbortSignal): Promise<ModelManifest> {
  return fetchManifest(set, schema, signal);
}
