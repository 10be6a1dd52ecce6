import type { PoseEstimate } from '../estimators/estimator.ts';

/** A watched frame in which somebody was seen. */
export interface SeenSample {
  readonly frame: number;
  readonly estimate: PoseEstimate;
}

/** Everything that is known of a clip once its frames have been watched. */
export interface WatchedClip {
  /** T seconds, of all frames. */
  readonly times: Float64Array;
  /** The frames that the estimator looked at, whether or not it saw anybody. */
  readonly watched: ArrayLike<number>;
  /** In the order of their frames. */
  readonly seen: readonly SeenSample[];
  /** N. */
  readonly every: number;
}
