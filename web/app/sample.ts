import { DeciWatchError } from '../errors.ts';
import type { ClipFile } from './recover-job.ts';

const SAMPLE_NAME = 'walk.mp4';

/**
 * Fetches the video that the site brings with it.
 * @throws DeciWatchError `file-unreadable`
 */
export async function fetchSample(): Promise<ClipFile> {
  try {
    const response = await fetch(new URL(`samples/${SAMPLE_NAME}`, document.baseURI));
    if (!response.ok) throw new Error(`status ${response.status}`);
    return { blob: await response.blob(), name: SAMPLE_NAME };
  } catch (cause) {
    throw new DeciWatchError(
      'file-unreadable',
      'The sample video could not be loaded: open a video of your own, or check the connection and reload.',
      { cause },
    );
  }
}
