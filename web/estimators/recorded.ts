import { frameAtTime, hasPose, type PoseSequence, poseAt } from '../pose/sequence.ts';
import type { Skeleton } from '../pose/skeleton.ts';
import type { EstimatorImage, PoseEstimate, PoseEstimator } from './estimator.ts';

/** Poses that were found before: a `RecoveredClip`, or what `posesFromFile` gives. */
export interface RecordedPoses {
  readonly poses2d: PoseSequence;
  /** Of the same frames; null where there are none. */
  readonly poses3d: PoseSequence | null;
}

/** What to call a recording, and what a look at it is to count. */
export interface RecordedOptions {
  /** `recorded` unless given. */
  readonly name?: string;
  /** FLOPs of one call of what once found the poses; 0, not known, unless given. */
  readonly flops?: number;
}

/** What a recording of a single frame is taken to have between frames, in seconds. */
const USUAL_PERIOD_S = 1 / 30;

/**
 * Answers with recorded poses instead of looking: so recovery can be repeated with another N, and be
 * fed with poses from elsewhere (another program's, motion capture), without a model. Times are the
 * recording's own, so that it belongs to one video.
 */
export class RecordedEstimator implements PoseEstimator {
  readonly name: string;
  readonly flops: number;
  readonly skeleton: Skeleton;
  readonly #poses: RecordedPoses;
  /** Seconds. */
  readonly #reach: number;

  constructor(poses: RecordedPoses, { name = 'recorded', flops = 0 }: RecordedOptions = {}) {
    this.name = name;
    this.flops = flops;
    this.skeleton = poses.poses2d.skeleton;
    this.#poses = poses;
    this.#reach = periodOf(poses.poses2d.times) / 2;
  }

  /**
   * The pose of the recorded frame nearest in time.
   * @param _image is not looked at
   * @returns null where nobody was seen in that frame, or it is more than half a frame away
   */
  async estimate(_image: EstimatorImage | null, timeMs: number): Promise<PoseEstimate | null> {
    const { poses2d, poses3d } = this.#poses;
    const frame = nearestFrame(poses2d.times, timeMs / 1000, this.#reach);
    if (frame === null || !hasPose(poses2d, frame)) return null;
    const joints = this.skeleton.joints.length;
    return {
      keypoints2d: poseAt(poses2d, frame).slice(),
      keypoints3d: poses3d && poseAt(poses3d, frame).slice(),
      scores: poses2d.scores.slice(frame * joints, (frame + 1) * joints),
    };
  }

  close(): void {}
}

/** The median time from one frame to the next, in seconds: a pause in the recording changes nothing. */
function periodOf(times: Float64Array): number {
  const periods = times.subarray(1).map((time, i) => time - times[i]!);
  return periods.sort()[periods.length >> 1] ?? USUAL_PERIOD_S;
}

function nearestFrame(times: Float64Array, time: number, reach: number): number | null {
  if (times.length === 0) return null;
  const before = frameAtTime(times, time);
  const after = Math.min(before + 1, times.length - 1);
  const isBefore = Math.abs(time - times[before]!) <= Math.abs(times[after]! - time);
  const nearest = isBefore ? before : after;
  return Math.abs(time - times[nearest]!) <= reach ? nearest : null;
}
