import type { DeciWatchErrorCode } from '../errors.ts';
import type { PoseEstimate, PoseEstimator } from '../estimators/estimator.ts';
import type { EstimatorName } from '../estimators/names.ts';
import type { EngineFiles } from './files.ts';
import type {
  LiveNeeds,
  LiveReady,
  RecordedStretch,
  WatchAnswer,
  WatchRequest,
} from './live/messages.ts';
import type { RecoveredClip, RecoverProgress } from './types.ts';

/** A job as it goes to the worker; a Blob is passed by reference, not copied. */
export interface JobMessage {
  readonly file: Blob;
  readonly name: string;
  readonly every: number;
  /** One of the engine's own, or one of the caller's, which is reached by a {@link Look}. */
  readonly estimator: EstimatorName | CallerEstimatorMessage;
  readonly files: EngineFiles;
}

/** An estimator of the caller's, in plain values. */
export type CallerEstimatorMessage = Pick<PoseEstimator, 'name' | 'flops' | 'skeleton'>;

/** What the caller's estimator made of a frame. */
export type LookAnswer =
  | { readonly kind: 'seen'; readonly estimate: PoseEstimate | null }
  | { readonly kind: 'failed'; readonly message: string };

/** The caller's estimator, which the worker calls from afar. Closes the image. Never rejects. */
export type Look = (image: ImageBitmap, timeMs: number) => Promise<LookAnswer>;

/**
 * How a job ended. Said in a value, since an error that crosses from a worker keeps its message alone.
 */
export type Outcome =
  | { readonly kind: 'done'; readonly clip: RecoveredClip }
  | { readonly kind: 'aborted' }
  | { readonly kind: 'failed'; readonly code: DeciWatchErrorCode; readonly message: string }
  /** Nothing that was foreseen: the worker's state is unknown from here on. */
  | { readonly kind: 'crashed'; readonly message: string };

/** The page's listener, which the worker calls from afar. */
export type ProgressListener = (progress: RecoverProgress) => void | Promise<void>;

/** What the worker offers, by Comlink. One job at a time. */
export interface EngineWorker {
  /**
   * Never rejects. The last call of `onProgress` is waited for.
   * @param look there where the job's estimator is the caller's
   */
  recover(job: JobMessage, onProgress: ProgressListener, look: Look | null): Promise<Outcome>;
  /** Ends the job that is under way, if any. */
  abort(): void;
  /** Loads what live playback needs. This and the next two never reject. */
  prepareLive(needs: LiveNeeds): Promise<LiveReady>;
  /** Looks at a camera frame, which is the worker's from then on. One at a time. */
  watch(image: VideoFrame, request: WatchRequest): Promise<WatchAnswer>;
  /** Recovers a recorded stretch of live playback. */
  recoverStretch(stretch: RecordedStretch): Promise<Outcome>;
  /** Live playback has ended. */
  stopLive(): void;
}
