import type { CostReport } from '../cost/report.ts';
import type { Recovery } from '../engine/types.ts';

/**
 * A pose file, `deciwatch-poses/1`, as JSON holds it: a 2D and a 3D pose for every frame of a clip.
 * Fields that are not named here are ignored.
 */
export interface PoseFile {
  /** Always {@link POSE_FILE_FORMAT}. */
  format: 'deciwatch-poses/1';
  source: PoseFileSource;
  skeleton: PoseFileSkeleton;
  /** N: one frame in N was watched. */
  interval: number;
  /** Who watched, and the FLOPs of one of its calls. */
  estimator: { name: string; flops: number };
  /** Missing in files of before there was a choice: then `nets`. */
  recovery?: Recovery | undefined;
  cost: CostReport;
  /** T frames, in order. */
  frames: PoseFileFrame[];
}

/** The clip of a {@link PoseFile}. */
export interface PoseFileSource {
  /** The clip's file name. */
  name: string;
  /** Pixels, as displayed: rotation applied. */
  width: number;
  /** Pixels. */
  height: number;
  /** Mean frames per second; exact times are those of the frames. */
  fps: number;
  /** T, frames of the clip and of the file. */
  frames: number;
  /** Seconds, to the end of the last frame. */
  duration: number;
}

/** The joints of a {@link PoseFile}. */
export interface PoseFileSkeleton {
  /** `blazepose-33` with the estimators that come with the package. */
  name: string;
  /** K joint names, in the order of all lists of a frame. */
  joints: string[];
  /** Pairs of different joint indices. */
  bones: [number, number][];
}

/** One frame of a {@link PoseFile}. Where nobody was seen, all three lists are null. */
export interface PoseFileFrame {
  /** Its place in the clip, from 0. */
  index: number;
  /** Seconds: the video file's own timestamp, to 1 µs. */
  time: number;
  /** The estimator looked at this frame; otherwise its pose was recovered. */
  watched: boolean;
  /** K pairs x, y in pixels of the picture as displayed, to 0.01: origin top left, y down. */
  keypoints2d: [number, number][] | null;
  /**
   * K triples x, y, z in metres relative to the mid-hip, to 0.1 mm: x right, y up, z towards the camera. Null
   * in all frames where the estimator gives no 3D.
   */
  keypoints3d: [number, number, number][] | null;
  /** K scores, 0 to 1. */
  scores: number[] | null;
}
