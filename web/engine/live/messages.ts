import type { DeciWatchErrorCode } from '../../errors.ts';
import type { SpatialEstimate } from '../../estimators/estimator.ts';
import type { EstimatorName } from '../../estimators/names.ts';
import type { LiveChunk } from '../../recovery/live-recoverer.ts';
import type { SpatialSample } from '../../recovery/watched-clip.ts';
import type { ClipInfo } from '../../sources/clip.ts';
import type { EngineFiles } from '../files.ts';

/** Said in a value, since an error that crosses from a worker keeps its message alone. */
export type Failure =
  | { readonly kind: 'failed'; readonly code: DeciWatchErrorCode; readonly message: string }
  | { readonly kind: 'crashed'; readonly message: string };

/** What live playback needs to have loaded. */
export interface LiveNeeds {
  readonly estimator: EstimatorName;
  /** The nets that look ahead too. */
  readonly forecast: boolean;
  readonly files: EngineFiles;
}

/** Loaded and warm, with the FLOPs of one estimator call. */
export type LiveReady = { readonly kind: 'ready'; readonly estimatorFlops: number } | Failure;

/** A camera frame to look at. */
export interface WatchRequest {
  readonly estimator: EstimatorName;
  /** Seconds. */
  readonly time: number;
  /** Seconds, of the camera's frames since the last one looked at, this one included. */
  readonly frameTimes: Float64Array;
  /** Seconds to look ahead to; none in smooth mode. */
  readonly ahead: Float64Array;
  /** Forget the samples before: N or the camera has changed. */
  readonly afresh: boolean;
}

/** What one look gave and cost. */
export type WatchAnswer =
  | {
      readonly kind: 'watched';
      readonly estimate: SpatialEstimate | null;
      /** What to show next: the newest interval, or what is to come. */
      readonly chunk: LiveChunk | null;
      readonly estimatorMs: number;
      readonly denoiseMs: number;
      readonly recoverMs: number;
      readonly denoiseFlops: number;
      readonly recoverFlops: number;
    }
  | Failure;

/** A stretch of live playback to be recovered like a file. */
export interface RecordedStretch {
  readonly info: ClipInfo;
  readonly times: Float64Array;
  readonly watched: readonly number[];
  readonly seen: readonly SpatialSample[];
  readonly every: number;
  readonly estimator: { readonly name: string; readonly flops: number };
  readonly estimatorMs: number;
  readonly files: EngineFiles;
}
