import { DeciWatchError } from '../errors.ts';

/** One frame that a camera's `<video>` has on screen. */
export interface CameraFrame {
  /** Seconds on the page's own clock (`performance.now() / 1000`), when it was captured. */
  readonly time: number;
  /** Seconds, when the page was told of it. */
  readonly told: number;
  /** Camera frames since the last one that the page was not told of. */
  readonly missed: number;
}

/**
 * Tells of every frame that a `<video>` with a camera's stream shows. Nothing comes while the tab is
 * hidden, since the browser shows nothing then.
 * @param video that plays the stream
 * @param onFrame to be handed to {@link LiveSession.frame}
 * @returns stops it
 * @throws DeciWatchError `browser-unsupported`
 */
export function watchCameraFrames(
  video: HTMLVideoElement,
  onFrame: (frame: CameraFrame) => void,
): () => void {
  if (!('requestVideoFrameCallback' in video)) {
    throw new DeciWatchError(
      'browser-unsupported',
      'This browser does not tell when a camera frame comes (requestVideoFrameCallback): use a current Chrome, Edge, Firefox or Safari.',
    );
  }
  let presented: number | undefined;
  let last = Number.NEGATIVE_INFINITY;
  let handle = 0;
  const next = () => {
    handle = video.requestVideoFrameCallback((now, metadata) => {
      next();
      const told = performance.now() / 1000;
      // Not every browser says when it was captured; then what it was shown at is the nearest.
      const time = (metadata.captureTime ?? now) / 1000;
      const missed = Math.max(
        0,
        metadata.presentedFrames - (presented ?? metadata.presentedFrames) - 1,
      );
      presented = metadata.presentedFrames;
      // The same frame can be presented twice, and a clock can be set back by a hair.
      if (time <= last) return;
      last = time;
      onFrame({ time, told, missed });
    });
  };
  next();
  return () => video.cancelVideoFrameCallback(handle);
}
