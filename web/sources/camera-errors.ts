import { DeciWatchError } from '../errors.ts';

/** Why a camera could not be had, as one sentence with what to do about it. */
export function cameraError(cause: unknown): DeciWatchError {
  const name = cause instanceof Error || cause instanceof DOMException ? cause.name : '';
  const of = (code: DeciWatchError['code'], message: string) =>
    new DeciWatchError(code, message, { cause });
  switch (name) {
    case 'NotAllowedError':
    case 'SecurityError':
      return of(
        'camera-refused',
        'The camera was refused: allow it for this page in the address bar, then try again.',
      );
    case 'NotFoundError':
    case 'OverconstrainedError':
      return of(
        'camera-missing',
        'No camera was found: connect one, or choose another, then try again.',
      );
    case 'NotReadableError':
    case 'AbortError':
      return of(
        'camera-busy',
        'The camera is in use by another program, or does not answer: close that program, then try again.',
      );
    default:
      return of(
        'camera-missing',
        `The camera could not be started (${name || String(cause)}): connect it again, then try again.`,
      );
  }
}

/** The page is not served over https, where browsers give no camera. */
export function insecurePage(): DeciWatchError {
  return new DeciWatchError(
    'camera-insecure',
    'Browsers give the camera to secure pages only: open this page over https or on localhost.',
  );
}

/** It was there, and is gone. */
export function cameraLost(): DeciWatchError {
  return new DeciWatchError(
    'camera-lost',
    'The camera stopped: it was unplugged, or taken by another program; connect it, then start it again.',
  );
}
