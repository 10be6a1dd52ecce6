import { DeciWatchError } from '../errors.ts';

/** The smallest interval N that can be asked for: every frame is watched. */
export const MIN_INTERVAL = 1;

/** The largest interval N that can be asked for. */
export const MAX_INTERVAL = 20;

/** N unless chosen: the paper's sampling ratio of 10 %. */
export const DEFAULT_INTERVAL = 10;

/**
 * The frames that the estimator watches: 0, N, 2N, … and always the last one, since frames after the
 * last watched one could not be recovered.
 *
 * @param frameCount frames of the clip; 0 gives no frames
 * @param every N
 * @throws DeciWatchError `bad-option` if N is not a whole number from 1 to 20
 */
export function watchedFrames(frameCount: number, every: number): Int32Array {
  checkInterval(every);
  const last = frameCount - 1;
  const length = frameCount === 0 ? 0 : Math.ceil(last / every) + 1;
  return Int32Array.from({ length }, (_, i) => Math.min(i * every, last));
}

/** @throws DeciWatchError `bad-option` if N is not a whole number from 1 to 20 */
export function checkInterval(every: number): void {
  if (Number.isInteger(every) && every >= MIN_INTERVAL && every <= MAX_INTERVAL) return;
  throw new DeciWatchError(
    'bad-option',
    `The interval N (one frame in N is watched) is ${every}; choose a whole number from ` +
      `${MIN_INTERVAL} to ${MAX_INTERVAL}.`,
  );
}
