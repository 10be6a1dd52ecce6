import type { DeciWatchErrorCode } from '../errors.ts';
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
  readonly estimator: EstimatorName;
  readonly files: EngineFiles;
}

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
  /** Never rejects. The last call of `onProgress` is waited for. */
  recover(job: JobMessage, onProgress: ProgressListener): Promise<Outcome>;
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
