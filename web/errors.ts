/**
 * What went wrong, for code that must act on it; the message is for people. `model-missing` could not be
 * fetched, `model-mismatch` is not what its manifest says; the others say what they mean.
 */
export type DeciWatchErrorCode =
  | 'bad-option'
  | 'file-missing'
  | 'file-unreadable'
  | 'file-truncated'
  | 'no-video-track'
  | 'codec-unsupported'
  | 'model-missing'
  | 'model-mismatch'
  | 'nobody-in-view'
  | 'estimator-failed'
  | 'camera-refused'
  | 'camera-missing'
  | 'camera-busy'
  | 'camera-insecure'
  | 'camera-lost'
  | 'browser-unsupported'
  | 'webgl-unavailable'
  | 'play-refused'
  | 'pose-file-invalid'
  | 'engine-crashed';

/**
 * A failure that a user can be told about: `message` is one sentence that says what was wrong and
 * what to do. Anything else that is thrown is a bug, but for an `AbortError` (a DOMException) where the
 * caller aborted.
 */
export class DeciWatchError extends Error {
  override readonly name = 'DeciWatchError';

  constructor(
    /** What went wrong. */
    readonly code: DeciWatchErrorCode,
    message: string,
    options?: ErrorOptions,
  ) {
    super(message, options);
  }
}
