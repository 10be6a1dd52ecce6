import type { LiveView as Moment } from '../engine/live/types.ts';
import type { RecoveredClip } from '../engine/types.ts';
import { DeciWatchError } from '../errors.ts';
import { hasPose, poseAt } from '../pose/sequence.ts';
import type { PlayerErrorDetail, PoseDetail } from './types.ts';

/** One frame of a clip, as the `pose` event tells it. The values are copies. */
export function clipPose({ poses2d, poses3d }: RecoveredClip, frame: number): PoseDetail {
  const joints = poses2d.skeleton.joints.length;
  const seen = hasPose(poses2d, frame);
  return {
    time: poses2d.times[frame]!,
    frame,
    watched: poses2d.watched[frame] === 1,
    keypoints: seen ? poseAt(poses2d, frame).slice() : null,
    keypoints3d: seen && poses3d ? poseAt(poses3d, frame).slice() : null,
    scores: seen ? poses2d.scores.slice(frame * joints, (frame + 1) * joints) : null,
  };
}

/** One frame of a camera, as the `pose` event tells it. The values are copies. */
export function cameraPose(time: number, { watched, pose }: Moment): PoseDetail {
  return {
    time,
    frame: null,
    watched,
    keypoints: pose?.values2d.slice() ?? null,
    keypoints3d: pose?.values3d.slice() ?? null,
    scores: pose?.scores.slice() ?? null,
  };
}

/** What was thrown, as the `error` event tells it. */
export function errorDetail(error: unknown, fatal: boolean): PlayerErrorDetail {
  if (error instanceof DeciWatchError) {
    return { type: error.code, message: error.message, cause: error.cause ?? error, fatal };
  }
  const words = error instanceof Error ? error.message : String(error);
  return {
    type: 'engine-crashed',
    message: `Something failed that should not have (${words}): try again, or reload the page.`,
    cause: error,
    fatal,
  };
}
