import type { EstimatorName } from '../../estimators/names.ts';
import { formatMegabytes } from '../../player/parts/format.ts';
import type { OfflineFailure } from './offline-copy.ts';

/** Why nothing was kept and what to do, in one sentence. */
export function failureWords(why: OfflineFailure): string {
  switch (why) {
    case 'no-room':
      return 'This browser has no room for it: free some space on this device, or choose a smaller estimator.';
    case 'no-answer':
      return 'A file did not come: check the connection and try again.';
    case 'another-file':
      return 'A file was not the one that was expected: the site may be changing just now, so reload the page and try again.';
    case 'no-worker':
      return 'This browser did not accept the page’s offline helper: leave private browsing, or allow this site to store data.';
    case 'busy':
      return 'Another tab is at it already: wait until it is done.';
  }
}

/** How far it is, for the eye. */
export function progressWords(done: number, total: number): string {
  return `${formatMegabytes(done)} of ${formatMegabytes(total)}`;
}

/** How far it is, for screen readers: said at each quarter, not at each step. */
export function spokenProgress(done: number, total: number): string {
  const quarters = Math.floor((4 * done) / total);
  return quarters === 0 ? 'Keeping this page.' : `Keeping this page: ${quarters * 25} % is here.`;
}

/** `the full estimator`, `the lite and full estimators`. */
export function estimatorWords(names: readonly EstimatorName[]): string {
  return names.length === 1
    ? `the ${names[0]} estimator`
    : `the ${new Intl.ListFormat('en').format(names)} estimators`;
}
