import type { Side, Skeleton } from '../pose/skeleton.ts';

/** A limb or line of the drawn body. An end is the mean of one or more joints. */
export interface BodySegment {
  readonly from: readonly number[];
  readonly to: readonly number[];
  readonly side: Side;
  /** Metres. */
  readonly radius: number;
}

/** How a skeleton is drawn: its bones with a thickness each, a neck, a spine and a head. */
export interface BodyPlan {
  readonly segments: readonly BodySegment[];
  /** K radii of the joints' spheres, in metres. */
  readonly jointRadii: readonly number[];
  /** Joints whose mean is the head's centre; empty where the skeleton has no ears. */
  readonly head: readonly number[];
}

const FACE = /nose|eye|ear|mouth/;
const HAND = /pinky|thumb|index/;
const FOOT = /heel|foot/;

const RADII = { limb: 0.028, trunk: 0.02, foot: 0.017, hand: 0.011, face: 0.006 } as const;
const JOINT_RADII = { limb: 0.038, trunk: 0.038, foot: 0.022, hand: 0.014, face: 0.011 } as const;

type Part = keyof typeof RADII;

function partOf(joint: string): Part {
  if (FACE.test(joint)) return 'face';
  if (FOOT.test(joint)) return 'foot';
  if (HAND.test(joint)) return 'hand';
  return /hip|shoulder/.test(joint) ? 'trunk' : 'limb';
}

/** The finer of two parts: a bone from the wrist to the thumb belongs to the hand. */
function bonePart(a: Part, b: Part): Part {
  if (a === 'trunk' && b === 'trunk') return 'trunk';
  const finest = RADII[a] < RADII[b] ? a : b;
  return finest === 'trunk' ? 'limb' : finest;
}

const plans = new WeakMap<Skeleton, BodyPlan>();

/** How a skeleton is drawn, worked out once from its joints' names. */
export function bodyPlan(skeleton: Skeleton): BodyPlan {
  const known = plans.get(skeleton);
  if (known) return known;
  const plan = workOut(skeleton);
  plans.set(skeleton, plan);
  return plan;
}

function workOut(skeleton: Skeleton): BodyPlan {
  const { joints, bones, sides } = skeleton;
  const parts = joints.map(partOf);
  const segments: BodySegment[] = bones.map(([a, b]) => ({
    from: [a],
    to: [b],
    side: sides[a] === sides[b] ? sides[a]! : 'middle',
    radius: RADII[bonePart(parts[a]!, parts[b]!)],
  }));

  const pair = (name: string) =>
    [`left_${name}`, `right_${name}`].map((joint) => joints.indexOf(joint)).filter((k) => k >= 0);
  const [shoulders, hips, head] = [pair('shoulder'), pair('hip'), pair('ear')];
  const link = (from: number[], to: number[]) => {
    if (from.length === 2 && to.length === 2) {
      segments.push({ from, to, side: 'middle', radius: RADII.trunk });
    }
  };
  link(hips, shoulders);
  link(shoulders, head);

  return {
    segments,
    jointRadii: parts.map((part) => JOINT_RADII[part]),
    head: head.length === 2 ? head : [],
  };
}
