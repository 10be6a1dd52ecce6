import type { EstimatorName } from '../../web/estimators/names.ts';

/** A quantity for red, green and blue, 0 to 1. */
export type Colour = readonly [number, number, number];

/** A box that stands between camera and person, in world metres. */
export interface Occluder {
  readonly centre: readonly [number, number, number];
  readonly size: readonly [number, number, number];
  readonly yaw: number;
  readonly colour: Colour;
}

/** What is round the person. World axes in metres, y up, the floor at 0. */
export interface Surroundings {
  /** Of the pattern behind and below. */
  readonly seed: number;
  readonly sky: Colour;
  readonly floor: Colour;
  /** Whether a floor is drawn; a picture without one has the backdrop everywhere. */
  readonly hasFloor: boolean;
  readonly ambient: number;
  readonly sun: number;
  readonly sunDirection: readonly [number, number, number];
  readonly sunColour: Colour;
  readonly occluders: readonly Occluder[];
}

/**
 * One clip of one avatar, written by `deciwatch pairs` (`pairs/jobs.py`). The numbers of its frames
 * lie in the file `data`: float32, for each frame the camera's 4 × 4 matrix (camera to world, column
 * by column), then one 4 × 4 matrix, node to parent, for each of `nodes`.
 */
export interface Job {
  readonly avatar: string;
  /** Each of them looks at every frame. */
  readonly estimators: readonly EstimatorName[];
  readonly data: string;
  readonly frames: number;
  readonly nodes: readonly string[];
  readonly width: number;
  readonly height: number;
  /** Vertical field of view in degrees. */
  readonly fieldOfView: number;
  readonly surroundings: Surroundings;
  /** Frames whose picture is wanted too, as JPEG. */
  readonly pictures: readonly number[];
}

/** Numbers of one frame's answer: 99 of 3D, 66 of 2D, 33 scores, milliseconds. NaN: nobody seen. */
export const ANSWER_SIZE = 33 * 6 + 1;

/** What a job gives. */
export interface Answer {
  /** For each estimator, base64 of frames × ANSWER_SIZE float32. */
  readonly estimates: readonly string[];
  /** Data URLs, in the order of `pictures`. */
  readonly pictures: readonly string[];
}
