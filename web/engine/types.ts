import type { CostReport } from '../cost/report.ts';
import type { PoseEstimator } from '../estimators/estimator.ts';
import type { EstimatorName } from '../estimators/names.ts';
import type { PoseSequence } from '../pose/sequence.ts';
import type { ClipInfo } from '../sources/clip.ts';
import type { LiveSession, LiveSettings } from './live/types.ts';

export type { ClipInfo };

/**
 * How the frames between the watched ones got their poses. `nets`: by DenoiseNet and RecoverNet.
 * `cubic`: by a cubic spline through the samples as they are, where the nets were not trained on what
 * the estimator gives.
 */
export type Recovery = 'nets' | 'cubic';

/** The two sequences recovered from a clip, what was seen of it, and what that cost. */
export interface RecoveredClip {
  /** What the file says of itself. */
  readonly source: ClipInfo;
  /** N: one frame in N was watched. */
  readonly interval: number;
  readonly estimator: { readonly name: string; readonly flops: number };
  readonly recovery: Recovery;
  /** In pixels; with the same T, times and watched flags as `poses3d`. */
  readonly poses2d: PoseSequence;
  /** Null where the estimator gives no 3D. */
  readonly poses3d: PoseSequence | null;
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
  /**
   * One that comes with the engine, by its name, or any other. Another one stays the caller's: it runs
   * on the caller's thread, and the engine never closes it. The nets do the rest where it gives
   * `BLAZEPOSE_33`'s joints in 2D and 3D; otherwise a cubic spline does ({@link Recovery}).
   */
  readonly estimator: EstimatorName | PoseEstimator;
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
   * @throws DeciWatchError with one sentence for people; `estimator-failed` where an estimator of the
   *   caller's threw (its error is the `cause`) or gave what is no pose. `AbortError` (DOMException)
   *   when aborted.
   */
  recover(clip: Blob, name: string, options: RecoverOptions): Promise<RecoveredClip>;
  /**
   * Follows a camera whose frames the caller hands over. One session at a time: a new one ends the one
   * before, whose `onError` is told (`camera-busy`).
   * @throws DeciWatchError `bad-option`; also for an estimator of the caller's, since live playback
   *   looks in the worker
   */
  live(settings: LiveSettings): LiveSession;
  /** Ends the worker and frees all that it holds. Jobs under way reject with an `AbortError`. */
  close(): void;
}
