import type { RecoveredClip } from '../engine/types.ts';
import { hasPose, type PoseSequence, poseAt } from '../pose/sequence.ts';
import { POSE_FILE_FORMAT } from './pose-file-schema.ts';
import type { PoseFile, PoseFileFrame } from './pose-file-types.ts';

/** Decimals kept: 2D to 0.01 px, 3D to 0.1 mm, times to 1 µs. */
const DECIMALS_2D = 2;
const DECIMALS_3D = 4;
const DECIMALS_TIME = 6;
const DECIMALS_SCORE = 3;

/** A recovered clip as a pose file: values rounded to 0.01 px, 0.1 mm and 1 µs. */
export function toPoseFile(clip: RecoveredClip): PoseFile {
  const { source, estimator, cost } = clip;
  const { name, joints, bones } = clip.poses2d.skeleton;
  const frames = Array.from(clip.poses2d.times, (_, index) => frameOf(clip, index));
  return {
    format: POSE_FILE_FORMAT,
    source: {
      name: source.name,
      width: source.width,
      height: source.height,
      fps: source.frameRate,
      frames: frames.length,
      duration: source.duration,
    },
    skeleton: { name, joints: [...joints], bones: bones.map(([from, to]) => [from, to]) },
    interval: clip.interval,
    estimator: { name: estimator.name, flops: estimator.flops },
    recovery: clip.recovery,
    cost,
    frames,
  };
}

/** The file's text: JSON with one frame to a line, so that two files can be compared line by line. */
export function stringifyPoseFile(file: PoseFile): string {
  const { frames, ...head } = file;
  const fields = Object.entries(head).map(([key, value]) => `"${key}":${JSON.stringify(value)}`);
  const lines = frames.map((frame) => JSON.stringify(frame));
  return `{\n${fields.join(',\n')},\n"frames":[\n${lines.join(',\n')}\n]}\n`;
}

function frameOf({ poses2d, poses3d }: RecoveredClip, index: number): PoseFileFrame {
  const time = round(poses2d.times[index]!, DECIMALS_TIME);
  const watched = poses2d.watched[index] === 1;
  if (!hasPose(poses2d, index) || (poses3d && !hasPose(poses3d, index))) {
    return { index, time, watched, keypoints2d: null, keypoints3d: null, scores: null };
  }
  const joints = poses2d.skeleton.joints.length;
  const scores = poses2d.scores.subarray(index * joints, (index + 1) * joints);
  return {
    index,
    time,
    watched,
    keypoints2d: pointsOf(poses2d, index, DECIMALS_2D).map(([x, y]) => [x!, y!]),
    keypoints3d: poses3d && pointsOf(poses3d, index, DECIMALS_3D).map(([x, y, z]) => [x!, y!, z!]),
    scores: Array.from(scores, (score) => round(score, DECIMALS_SCORE)),
  };
}

/** K lists of D rounded numbers. */
function pointsOf(sequence: PoseSequence, frame: number, decimals: number): number[][] {
  const values = Array.from(poseAt(sequence, frame), (value) => round(value, decimals));
  return sequence.skeleton.joints.map((_, k) =>
    values.slice(k * sequence.dims, (k + 1) * sequence.dims),
  );
}

function round(value: number, decimals: number): number {
  const scale = 10 ** decimals;
  // Adding 0 turns the -0 that rounding small negative numbers gives into 0.
  return Math.round(value * scale) / scale + 0;
}
