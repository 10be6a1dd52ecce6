import {
  Color,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import { hasPose, type PoseSequence, poseAt } from '../pose/sequence.ts';
import type { Skeleton } from '../pose/skeleton.ts';
import { instancesChanged } from './instances.ts';
import type { Palette } from './palette.ts';

/** Frames of the past that are shown. */
const LENGTH = 24;
const TRAILED = /^(left|right)_(wrist|ankle)$/;

/**
 * The recent paths of wrists and ankles: a large dot where the estimator looked, small ones where the
 * pose was recovered.
 */
export class Trails {
  readonly object: InstancedMesh;
  readonly #joints: readonly number[];
  readonly #skeleton: Skeleton;
  readonly #geometry = new SphereGeometry(1, 10, 8);
  readonly #material = new MeshBasicMaterial();
  #palette: Palette;

  constructor(skeleton: Skeleton, palette: Palette) {
    this.#skeleton = skeleton;
    this.#palette = palette;
    this.#joints = skeleton.joints.flatMap((name, joint) => (TRAILED.test(name) ? [joint] : []));
    this.object = new InstancedMesh(this.#geometry, this.#material, this.#joints.length * LENGTH);
    this.object.frustumCulled = false;
  }

  /** Takes effect with the next {@link update}. */
  setPalette(palette: Palette): void {
    this.#palette = palette;
  }

  /**
   * @param sequence 3D
   * @param hipHeights T heights above the ground, in metres
   * @param frame the newest frame shown
   */
  update(sequence: PoseSequence, hipHeights: Float32Array, frame: number): void {
    let dots = 0;
    for (let past = frame; past >= Math.max(0, frame - LENGTH + 1); past--) {
      // A trail across a gap would join two places that nobody moved between.
      if (!hasPose(sequence, past)) break;
      const pose = poseAt(sequence, past);
      const age = (frame - past) / LENGTH;
      const watched = sequence.watched[past] === 1;
      size.setScalar((watched ? 0.016 : 0.0075) * (1 - 0.5 * age));
      for (const joint of this.#joints) {
        place.set(pose[joint * 3]!, pose[joint * 3 + 1]! + hipHeights[past]!, pose[joint * 3 + 2]!);
        this.object.setMatrixAt(dots, matrix.compose(place, NO_TURN, size));
        tint.set(this.#palette.sides[this.#skeleton.sides[joint]!]);
        this.object.setColorAt(
          dots,
          mixed.set(this.#palette.background).lerp(tint, 1 - 0.75 * age),
        );
        dots++;
      }
    }
    this.object.count = dots;
    instancesChanged(this.object);
  }

  dispose(): void {
    this.object.removeFromParent();
    this.object.dispose();
    this.#geometry.dispose();
    this.#material.dispose();
  }
}

const matrix = new Matrix4();
const place = new Vector3();
const size = new Vector3();
const NO_TURN = new Quaternion();
const mixed = new Color();
const tint = new Color();
