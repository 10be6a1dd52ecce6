/** The side of the body that a joint or bone belongs to, seen from the person. */
export type Side = 'left' | 'right' | 'middle';

/** The joints of a pose, in the order in which their values are stored, and the bones between them. */
export interface Skeleton {
  readonly name: string;
  /** K joint names, in `snake_case`. */
  readonly joints: readonly string[];
  /** Pairs of joint indices. */
  readonly bones: readonly (readonly [number, number])[];
  /** K sides. */
  readonly sides: readonly Side[];
  /** Joints whose mean is the root (the mid-hip), to which 3D values are relative. */
  readonly root: readonly number[];
}

/**
 * A skeleton from its joints' names and its bones: sides by `left` and `right` in the names, the root by
 * the joints `left_hip` and `right_hip`, where there are any.
 * @param bones pairs of joint indices
 */
export function skeletonFrom(
  name: string,
  joints: readonly string[],
  bones: Skeleton['bones'],
): Skeleton {
  const hips = ['left_hip', 'right_hip'].map((hip) => joints.indexOf(hip));
  return {
    name,
    joints: [...joints],
    bones,
    sides: joints.map(sideOf),
    root: hips.filter((hip) => hip >= 0),
  };
}

/** Whether two skeletons have the same joints in the same order, whatever they are called. */
export function haveSameJoints(a: Skeleton, b: Skeleton): boolean {
  return a.joints.length === b.joints.length && a.joints.every((joint, k) => joint === b.joints[k]);
}

/** The side that a joint's name tells: `left_hip`, `mouth_right`; joints without one are in the middle. */
export function sideOf(joint: string): Side {
  if (joint.includes('left')) return 'left';
  return joint.includes('right') ? 'right' : 'middle';
}
