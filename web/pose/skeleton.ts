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

/** The side that a joint's name tells: `left_hip`, `mouth_right`; joints without one are in the middle. */
export function sideOf(joint: string): Side {
  if (joint.includes('left')) return 'left';
  return joint.includes('right') ? 'right' : 'middle';
}
