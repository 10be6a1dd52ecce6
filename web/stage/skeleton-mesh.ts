import {
  Color,
  CylinderGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import type { Skeleton } from '../pose/skeleton.ts';
import { type BodyPlan, bodyPlan } from './body-plan.ts';
import { instancesChanged } from './instances.ts';
import type { Palette } from './palette.ts';

/** Scores at and below the first are drawn fully faded, at and above the second fully solid. */
const FADE_SCORES = [0.15, 0.6] as const;
const HEAD_RADIUS_M = 0.086;
const UP = new Vector3(0, 1, 0);

/** One frame of a person, as the mesh takes it. */
export interface BodyPose {
  /** K·3 metres. */
  readonly values: Float32Array;
  /** K scores, 0 to 1. */
  readonly scores: Float32Array;
  /** Marks the joints as seen by the estimator itself. */
  readonly watched: boolean;
  /** 0 (gone) to 1 (there, unless said otherwise): less while somebody comes into view or has left it. */
  readonly presence?: number;
}

/** A body of cylinders (bones) and spheres (joints): two instanced meshes and a head. */
export class SkeletonMesh {
  readonly object = new Group();
  readonly #plan: BodyPlan;
  readonly #skeleton: Skeleton;
  readonly #material = new MeshLambertMaterial();
  readonly #headMaterial = new MeshLambertMaterial();
  readonly #cylinder: CylinderGeometry;
  readonly #sphere: SphereGeometry;
  readonly #bones: InstancedMesh;
  readonly #joints: InstancedMesh;
  readonly #head: Mesh;
  #palette: Palette;

  /** @param coarse with a third of the triangles, for those who draw in software */
  constructor(skeleton: Skeleton, palette: Palette, coarse = false) {
    this.#cylinder = new CylinderGeometry(1, 1, 1, coarse ? 7 : 14, 1, true);
    this.#sphere = coarse ? new SphereGeometry(1, 10, 7) : new SphereGeometry(1, 20, 14);
    this.#skeleton = skeleton;
    this.#palette = palette;
    this.#plan = bodyPlan(skeleton);
    this.#bones = new InstancedMesh(this.#cylinder, this.#material, this.#plan.segments.length);
    this.#joints = new InstancedMesh(this.#sphere, this.#material, skeleton.joints.length);
    this.#head = new Mesh(this.#sphere, this.#headMaterial);
    for (const mesh of [this.#bones, this.#joints, this.#head]) mesh.frustumCulled = false;
    this.#head.visible = this.#plan.head.length > 0;
    this.object.add(this.#bones, this.#joints, this.#head);
    this.setPalette(palette);
  }

  /** Takes effect with the next {@link update}. */
  setPalette(palette: Palette): void {
    this.#palette = palette;
    this.#headMaterial.color.set(palette.sides.middle);
  }

  /** Moves the body to a pose. */
  update(pose: BodyPose): void {
    const { segments, jointRadii, head } = this.#plan;
    const presence = pose.presence ?? 1;
    segments.forEach((segment, index) => {
      const solid = Math.min(solidity(pose, segment.from), solidity(pose, segment.to));
      meanPoint(pose.values, segment.from, start);
      meanPoint(pose.values, segment.to, end);
      placeBetween(start, end, segment.radius * thickness(solid) * presence);
      this.#bones.setMatrixAt(index, matrix);
      this.#bones.setColorAt(
        index,
        this.#faded(this.#palette.sides[segment.side], solid, presence),
      );
    });
    jointRadii.forEach((radius, joint) => {
      const solid = solidity(pose, [joint]);
      meanPoint(pose.values, [joint], start);
      size.setScalar(radius * thickness(solid) * presence);
      this.#joints.setMatrixAt(joint, matrix.compose(start, NO_TURN, size));
      const colour = pose.watched
        ? this.#palette.watched
        : this.#palette.sides[this.#skeleton.sides[joint]!];
      this.#joints.setColorAt(joint, this.#faded(colour, solid, presence));
    });
    if (head.length > 0) {
      meanPoint(pose.values, head, this.#head.position);
      const radius = HEAD_RADIUS_M * Math.max(presence, 1e-3);
      this.#head.scale.set(radius * 0.86, radius * 1.12, radius * 0.86);
    }
    for (const mesh of [this.#bones, this.#joints]) {
      instancesChanged(mesh);
    }
  }

  /** Frees everything on the graphics card. */
  dispose(): void {
    this.object.removeFromParent();
    this.#bones.dispose();
    this.#joints.dispose();
    this.#cylinder.dispose();
    this.#sphere.dispose();
    this.#material.dispose();
    this.#headMaterial.dispose();
  }

  #faded(colour: string, solid: number, presence: number): Color {
    const share = presence * (0.3 + 0.7 * solid);
    return mixed.set(this.#palette.background).lerp(tint.set(colour), share);
  }
}

// Scratch values: a pose is drawn thirty times a second, and none of them outlives a call.
const matrix = new Matrix4();
const start = new Vector3();
const end = new Vector3();
const along = new Vector3();
const size = new Vector3();
const turn = new Quaternion();
const NO_TURN = new Quaternion();
const mixed = new Color();
const tint = new Color();

/** How surely a segment's end was seen, from 0 (a guess) to 1. */
function solidity(pose: BodyPose, joints: readonly number[]): number {
  const [low, high] = FADE_SCORES;
  const score = Math.min(...joints.map((joint) => pose.scores[joint]!));
  return Math.min(1, Math.max(0, (score - low) / (high - low)));
}

function thickness(solid: number): number {
  return 0.6 + 0.4 * solid;
}

function meanPoint(values: Float32Array, joints: readonly number[], target: Vector3): void {
  target.set(0, 0, 0);
  for (const joint of joints) {
    target.x += values[joint * 3]! / joints.length;
    target.y += values[joint * 3 + 1]! / joints.length;
    target.z += values[joint * 3 + 2]! / joints.length;
  }
}

/** Leaves in `matrix` the transform of the unit cylinder from `from` to `to`. */
function placeBetween(from: Vector3, to: Vector3, radius: number): void {
  along.subVectors(to, from);
  const length = Math.max(along.length(), 1e-6);
  turn.setFromUnitVectors(UP, along.divideScalar(length));
  size.set(radius, length, radius);
  matrix.compose(from.add(to).multiplyScalar(0.5), turn, size);
}
