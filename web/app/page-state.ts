import type { RecoverProgress } from '../engine/types.ts';

/**
 * The page's state in one word, as `data-state` on the document says it. `ready`: there is a result on
 * screen, whatever has failed since. `error`: there is none, and the page says why.
 */
export type PageState = 'loading' | 'processing' | 'ready' | 'error' | 'idle';

/**
 * @param progress the running job's, if one runs
 * @param failed an error is on screen
 * @param done there is a result on screen
 */
export function pageState(
  progress: RecoverProgress | null,
  failed: boolean,
  done: boolean,
): PageState {
  if (progress) return progress.stage === 'loading' ? 'loading' : 'processing';
  if (done) return 'ready';
  return failed ? 'error' : 'idle';
}
