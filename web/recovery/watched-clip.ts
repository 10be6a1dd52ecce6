import type { PoseEstimate, SpatialEstimate } from '../estimators/estimator.ts';

/** A watched frame in which somebody was seen. */
export interface SeenSample<TEstimate extends PoseEstimate = PoseEstimate> {
  readonly frame: number;
  readonly estimate: TEstimate;
}

/** One that was seen in 3D too. */
export type SpatialSample = SeenSample<SpatialEstimate>;

/** Everything that is known of a clip once its frames have been watched. */
export interface WatchedClip<TEstimate extends PoseEstimate = PoseEstimate> {
  /** T seconds, of all frames. */
  readonly times: Float64Array;
  /** The frames that the estimator looked at, whether or not it saw anybody. */
  readonly watched: ArrayLike<number>;
  /** In the order of their frames. */
  readonly seen: readonly SeenSample<TEstimate>[];
  /** N. */
  readonly every: number;
}

/** T flags: 1 where the estimator looked. */
export function watchedFlags({
  times,
  watched,
}: Pick<WatchedClip, 'times' | 'watched'>): Uint8Array {
  const flags = new Uint8Array(times.length);
  for (const frame of Array.from(watched)) flags[frame] = 1;
  return flags;
}
