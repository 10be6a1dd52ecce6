import type { Skeleton } from '../pose/skeleton.ts';

/** The poses of one person in one frame, as an estimator sees them: noisy. */
export interface PoseEstimate {
  /** K·2 pixels of the frame that was given, origin top left. */
  readonly keypoints2d: Float32Array;
  /** K·3 metres relative to the mid-hip: x right, y up, z towards the camera. */
  readonly keypoints3d: Float32Array;
  /** K scores, 0 to 1. */
  readonly scores: Float32Array;
}

/** What an estimator can look at. */
export type EstimatorImage = OffscreenCanvas | ImageBitmap | VideoFrame;

/** A single-frame pose estimator: MediaPipe by default, or anybody's own. */
export interface PoseEstimator {
  readonly name: string;
  readonly skeleton: Skeleton;
  /** FLOPs of one call (2 × multiply-accumulates). */
  readonly flops: number;
  /** Null means that nobody was seen. The image is not kept and stays the caller's to close. */
  estimate(image: EstimatorImage, timeMs: number): Promise<PoseEstimate | null>;
  close(): void;
}
