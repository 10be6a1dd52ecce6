import type { CostReport } from '../cost/report.ts';
import type { EstimatorName } from '../estimators/names.ts';
import type { PoseSequence } from '../pose/sequence.ts';
import type { ClipInfo } from '../sources/clip.ts';
import type { LiveSession, LiveSettings } from './live/types.ts';

export type { ClipInfo };

/** The two sequences recovered from a clip, what was seen of it, and what that cost. */
export interface RecoveredClip {
  /** What the file says of itself. */
  readonly source: ClipInfo;
  /** N: one frame in N was watched. */
  readonly interval: number;
  readonly estimator: { readonly name: string; readonly flops: number };
  /** In pixels; with the same T, times and watched flags as `poses3d`. */
  readonly poses2d: PoseSequence;
  readonly poses3d: PoseSequence;
  readonly cost: CostReport;
}

/** What a job is at: `loading` the models, `watching` one frame in N, `recovering` those between. */
export type RecoverStage = 'loading' | 'watching' | 'recovering';

/** How far a job is. */
export interface RecoverProgress {
  readonly stage: RecoverStage;
  /** 0 to 1 over the whole job; never falls, ends at 1. */
  readonly fraction: number;
  /** Frames of the clip passed so far. */
  readonly framesDone: number;
  /** Frames of the clip; 0 while not yet known. */
  readonly framesTotal: number;
}

/** How a clip is to be recovered. */
export interface RecoverOptions {
  /** N, 1 to 20: the estimator watches one frame in N. */
  readonly every: number;
  readonly estimator: EstimatorName;
  /** Ends the job within one estimator call, or one window of frames. */
  readonly signal?: AbortSignal;
  /** Told at each step. What it throws is reported as an uncaught error, and does not end the job. */
  readonly onProgress?: (progress: RecoverProgress) => void;
}

/** What {@link createEngine} makes. One job at a time: a second one waits for the first. */
export interface Engine {
  /**
   * Recovers a pose for every frame of a clip.
   * @param clip a video file: MP4, MOV, WebM, MKV or MPEG-TS, in a codec that the browser can decode
   * @param name of the file, for messages and for {@link RecoveredClip.source}
   * @throws DeciWatchError with one sentence for people; `AbortError` (DOMException) when aborted.
   */
  recover(clip: Blob, name: string, options: RecoverOptions): Promise<RecoveredClip>;
  /**
   * Follows a camera whose frames the caller hands over. One session at a time: a new one ends the one
   * before.
   * @throws DeciWatchError `bad-option`
   */
  live(settings: LiveSettings): LiveSession;
  /** Ends the worker and frees all that it holds. Jobs under way reject with an `AbortError`. */
  close(): void;
}
