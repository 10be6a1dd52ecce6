import * as v from 'valibot';
import { fetchManifest, fileEntries } from '../../download.ts';
import { ESTIMATOR_NAMES, type EstimatorName } from '../../estimators/names.ts';
import { LIST } from './addresses.ts';

const entry = v.object({
  ...fileEntries,
  /** Only for this estimator; the others are needed always. */
  estimator: v.optional(v.picklist(ESTIMATOR_NAMES)),
});

const schema = v.object({
  format: v.literal('deciwatch-offline/1'),
  /** Of all files together. */
  release: v.pipe(v.string(), v.regex(/^[0-9a-f]{16}$/)),
  files: v.array(entry),
});

/** A file of the page, under the address that it is asked for with, relative to the page's folder. */
export type ReleaseEntry = v.InferOutput<typeof entry>;

/** All files that the page needs without a connection: `offline.json`, which the build writes. */
export type Release = v.InferOutput<typeof schema>;

/** @throws DeciWatchError `model-missing` or `model-mismatch` */
export function fetchRelease(scope: URL): Promise<Release> {
  return fetchManifest({ manifest: new URL(LIST, scope).href }, schema);
}

/** A release's list as it was kept, or null where this version cannot read it. */
export async function parseRelease(response: Response): Promise<Release | null> {
  const result = v.safeParse(schema, await response.json().catch(() => null));
  return result.success ? result.output : null;
}

/** The files to keep for some estimators. */
export function entriesFor(
  { files }: Release,
  estimators: readonly EstimatorName[],
): ReleaseEntry[] {
  return files.filter(({ estimator }) => !estimator || estimators.includes(estimator));
}

/** Bytes on the device. */
export function bytesOf(entries: readonly ReleaseEntry[]): number {
  return entries.reduce((sum, { bytes }) => sum + bytes, 0);
}
