import type { EstimatorImage } from '../estimators/estimator.ts';

/** What is known of a clip before any of its frames is decoded. */
export interface ClipInfo {
  /** As it was given. */
  readonly name: string;
  /** Pixels, as displayed: rotation applied. */
  readonly width: number;
  /** Pixels. */
  readonly height: number;
  /** T. */
  readonly frameCount: number;
  /** Mean frames per second, from the file's own timestamps. */
  readonly frameRate: number;
  /** Seconds, from the first frame's timestamp to the end of the last frame. */
  readonly duration: number;
}

/** One decoded frame of a clip, as it is displayed. */
export interface ClipFrame {
  /** Its place in the clip, from 0. */
  readonly index: number;
  /** Seconds, the file's own timestamp. */
  readonly time: number;
  /** `ClipInfo.width` × `ClipInfo.height`. The clip's own: valid until the next frame is asked for. */
  readonly image: EstimatorImage;
}

/** A clip whose frames can be had by their index. */
export interface Clip {
  readonly info: ClipInfo;
  /** T seconds, strictly increasing: the file's own timestamps. */
  readonly times: Float64Array;
  /**
   * Decodes the frames asked for, in order. Pulling one at a time is the back-pressure; leaving the
   * loop frees every frame that was decoded ahead.
   * @param indices increasing
   * @throws DeciWatchError `file-truncated` or `file-unreadable` where the file's data ends or is damaged
   */
  frames(indices: Iterable<number>): AsyncGenerator<ClipFrame, void, undefined>;
  close(): void;
}
