import type { CostReport } from '../cost/report.ts';
import type { EstimatorName } from '../estimators/names.ts';
import type { PoseSequence } from '../pose/sequence.ts';
import type { ClipInfo } from '../sources/clip.ts';
import type { LiveSession, LiveSettings } from './live/types.ts';

export type { ClipInfo };

/** The two sequences recovered from a clip, what was seen of it, and what that cost. */
export interface RecoveredClip {
  readonly source: ClipInfo;
  /** N: one frame in N was watched. */
  readonly interval: number;
  readonly estimator: { readonly name: string; readonly flops: number };
  /** Both have the same T, times and watched flags. */
  readonly poses2d: PoseSequence;
  readonly poses3d: PoseSequence;
  readonly cost: CostReport;
}

export type RecoverStage = 'loading' | 'watching' | 'recovering';

export interface RecoverProgress {
  readonly stage: RecoverStage;
  /** 0 to 1 over the whole job; never falls, ends at 1. */
  readonly fraction: number;
  /** Frames of the clip passed so far, and in all (0 while it is not yet known). */
  readonly framesDone: number;
  readonly framesTotal: number;
}

export interface RecoverOptions {
  /** N, 1 to 20: the estimator watches one frame in N. */
  readonly every: number;
  readonly estimator: EstimatorName;
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: RecoverProgress) => void;
}

/** The engine as a page sees it. One job at a time: a second one waits for the first. */
export interface Engine {
  /**
   * Recovers a pose for every frame of a clip.
   * @throws DeciWatchError with one sentence for people; `AbortError` (DOMException) when aborted.
   */
  recover(clip: Blob, name: string, options: RecoverOptions): Promise<RecoveredClip>;
  /**
   * Follows a camera whose frames the caller hands over. One session at a time: a new one ends the one
   * before, whose `onError` is told (`camera-busy`).
   * @throws DeciWatchError `bad-option`
   */
  live(settings: LiveSettings): LiveSession;
  /** Ends the worker and frees all that it holds. */
  close(): void;
}
