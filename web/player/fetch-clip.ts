import { DeciWatchError } from '../errors.ts';

/** A clip and what to call it. */
export interface FetchedClip {
  readonly blob: Blob;
  readonly name: string;
}

/**
 * Fetches a clip whole.
 * @throws DeciWatchError `file-missing` or `file-truncated`; the signal's reason when aborted
 */
export async function fetchClip(url: URL, signal: AbortSignal): Promise<FetchedClip> {
  const name = nameOf(url);
  let response: Response;
  try {
    response = await fetch(url, { signal });
  } catch (error) {
    signal.throwIfAborted();
    throw missing(name, 'no answer', error);
  }
  if (!response.ok) throw missing(name, `status ${response.status}`);
  if (isWebPage(response)) throw missing(name, 'a web page came');
  try {
    return { blob: await response.blob(), name };
  } catch (cause) {
    signal.throwIfAborted();
    throw new DeciWatchError(
      'file-truncated',
      `${name} stopped coming half way: check the connection, and try again.`,
      { cause },
    );
  }
}

/**
 * Asks whether a clip is there, without fetching it.
 * @throws DeciWatchError `file-missing`
 */
export async function checkClip(url: URL): Promise<void> {
  const name = nameOf(url);
  let response: Response;
  try {
    response = await fetch(url, { method: 'HEAD' });
  } catch (error) {
    throw missing(name, 'no answer', error);
  }
  // Some hosts know no HEAD: what else is wrong shows when the clip is fetched.
  const { status } = response;
  if (status === 404 || status === 410) throw missing(name, `status ${status}`);
  if (response.ok && isWebPage(response)) throw missing(name, 'a web page came');
}

/** Many servers answer with their start page where a file is missing. */
function isWebPage(response: Response): boolean {
  return response.headers.get('content-type')?.startsWith('text/html') ?? false;
}

function missing(name: string, why: string, cause?: unknown): DeciWatchError {
  return new DeciWatchError(
    'file-missing',
    `${name} could not be loaded (${why}): check its address, the connection, and that its host allows other pages to read it (CORS).`,
    { cause },
  );
}

/** The last part of an address, as people know the file: `clip.mp4`. */
export function nameOf(url: URL): string {
  if (url.protocol === 'data:' || url.protocol === 'blob:') return 'The clip';
  const last = url.pathname.split('/').at(-1) ?? '';
  try {
    return decodeURIComponent(last) || url.host;
  } catch {
    return last;
  }
}
