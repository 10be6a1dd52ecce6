import { DeciWatchError } from '../errors.ts';
import type { Failure } from './live/messages.ts';

/** @param detail what happened, in a few words */
export function crash(detail: string): DeciWatchError {
  return new DeciWatchError(
    'engine-crashed',
    `The engine stopped working (${detail}): try again, and reload the page if it happens twice.`,
  );
}

/** What the worker's answer stands for. */
export function errorOf(failure: Failure): DeciWatchError {
  return failure.kind === 'failed'
    ? new DeciWatchError(failure.code, failure.message)
    : crash(failure.message);
}
