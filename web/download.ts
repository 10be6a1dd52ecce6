import * as v from 'valibot';
import { sha256, versionQuery } from './digest.ts';
import { DeciWatchError } from './errors.ts';

/** What a manifest says of a file beside it. */
export interface FileEntry {
  /** Relative to the manifest. */
  readonly file: string;
  readonly bytes: number;
  /** Lower-case hexadecimal. */
  readonly sha256: string;
}

/** A manifest, and where the files that it lists are: beside it, unless named here. */
export interface FileSet {
  /** The manifest's address. */
  readonly manifest: string;
  /** Addresses by the file's name in the manifest; bundlers give files names of their own. */
  readonly files?: Readonly<Record<string, string>>;
}

/** The part that every file entry of a manifest has. */
export const fileEntries = {
  file: v.pipe(v.string(), v.minLength(1)),
  bytes: v.pipe(v.number(), v.integer(), v.minValue(1)),
  sha256: v.pipe(v.string(), v.regex(/^[0-9a-f]{64}$/)),
};

async function get(url: URL, signal?: AbortSignal): Promise<Uint8Array<ArrayBuffer>> {
  const missing = (why: string, cause?: unknown) =>
    new DeciWatchError(
      'model-missing',
      `${url.href} could not be loaded (${why}): check that the site was copied whole, and the connection.`,
      { cause },
    );
  let response: Response;
  try {
    response = await fetch(url, signal ? { signal } : {});
  } catch (error) {
    signal?.throwIfAborted();
    throw missing('no answer', error);
  }
  if (!response.ok) throw missing(`status ${response.status}`);
  // Many servers answer with their start page where a file is missing.
  if (response.headers.get('content-type')?.startsWith('text/html'))
    throw missing('a web page came');
  try {
    return new Uint8Array(await response.arrayBuffer());
  } catch (error) {
    signal?.throwIfAborted();
    throw missing('it broke off half-way', error);
  }
}

/**
 * Fetches a manifest and checks it.
 * @throws DeciWatchError `model-missing` where it cannot be had, `model-mismatch` where it does not fit the schema.
 */
export async function fetchManifest<TSchema extends v.GenericSchema>(
  { manifest }: FileSet,
  schema: TSchema,
  signal?: AbortSignal,
): Promise<v.InferOutput<TSchema>> {
  const url = new URL(manifest);
  const bytes = await get(url, signal);
  const mismatch = (why: string) =>
    new DeciWatchError(
      'model-mismatch',
      `${url.href} is not a manifest that this version can read (${why}): deploy the page and its models together.`,
    );
  let json: unknown;
  try {
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw mismatch('it is not JSON');
  }
  const result = v.safeParse(schema, json);
  if (result.success) return result.output;
  const issue = result.issues[0];
  throw mismatch(`${v.getDotPath(issue) ?? 'the whole'}: ${issue.message}`);
}

/**
 * Fetches a file that a manifest lists, and checks its length and, where the browser can (a secure
 * context), its SHA-256.
 * @throws DeciWatchError `model-missing` where it cannot be had, `model-mismatch` where it is another file.
 */
export async function fetchListed(
  set: FileSet,
  entry: FileEntry,
  signal?: AbortSignal,
): Promise<Uint8Array<ArrayBuffer>> {
  const url = new URL(set.files?.[entry.file] ?? entry.file, set.manifest);
  // Another file has another address: no cache answers with the one of an earlier release.
  if (url.protocol.startsWith('http')) url.search = versionQuery(entry.sha256);
  const bytes = await get(url, signal);
  const mismatch = (why: string) =>
    new DeciWatchError(
      'model-mismatch',
      `${url.href} is not the file that its manifest lists (${why}): deploy both together, and empty the cache.`,
    );
  if (bytes.length !== entry.bytes) {
    throw mismatch(`${bytes.length} bytes instead of ${entry.bytes}`);
  }
  if (globalThis.crypto?.subtle && (await sha256(bytes)) !== entry.sha256) {
    throw mismatch('another SHA-256');
  }
  return bytes;
}
