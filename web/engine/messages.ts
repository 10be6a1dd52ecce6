import type { DeciWatchErrorCode } from '../errors.ts';
import type { EstimatorName } from '../estimators/names.ts';
import type { ModelUrls } from './models.ts';
import type { RecoveredClip, RecoverProgress } from './types.ts';

/** A job as it goes to the worker; a Blob is passed by reference, not copied. */
export interface JobMessage {
  readonly file: Blob;
  readonly name: string;
  readonly every: number;
  readonly estimator: EstimatorName;
  readonly urls: ModelUrls;
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
}
