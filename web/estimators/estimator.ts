import type { Skeleton } from '../pose/skeleton.ts';

/** The poses of one person in one frame, as an estimator sees them: noisy. */
export interface PoseEstimate {
  /** K·2 pixels of the frame that was given, origin top left. */
  readonly keypoints2d: Float32Array;
  /**
   * K·3 metres relative to the mid-hip: x right, y up, z towards the camera. Null from an estimator that
   * knows no depth, and then always.
   */
  readonly keypoints3d: Float32Array | null;
  /** K scores, 0 to 1. */
  readonly scores: Float32Array;
}

/** An estimate in 2D and in 3D: what the nets take. */
export interface SpatialEstimate extends PoseEstimate {
  readonly keypoints3d: Float32Array;
}

/** What an estimator can look at. */
export type EstimatorImage = OffscreenCanvas | ImageBitmap | VideoFrame;

/**
 * A single-frame pose estimator: MediaPipe's, which come with the engine, or anybody's own, which
 * `Engine.recover` takes as its option `estimator`.
 */
export interface PoseEstimator {
  readonly name: string;
  readonly skeleton: Skeleton;
  /** FLOPs of one call (2 × multiply-accumulates); 0 where they are not known. */
  readonly flops: number;
  /**
   * Looks at one frame. It is asked for one frame at a time.
   * @param image stays the caller's to close, and is closed once the answer is there: keep no hold of it
   * @param timeMs milliseconds: the frame's own time
   * @returns null where nobody was seen
   */
  estimate(image: EstimatorImage, timeMs: number): Promise<PoseEstimate | null>;
  /** Frees what it holds. For whoever made it: an engine that is given an estimator never closes it. */
  close(): void;
}
