import { describe, expect, it } from 'vitest';
import { BLAZEPOSE_33 } from '../../web/pose/blazepose33.ts';
import { COCO_17 } from '../../web/pose/coco17.ts';
import { HALPE_26 } from '../../web/pose/halpe26.ts';
import { haveSameJoints, skeletonFrom } from '../../web/pose/skeleton.ts';

/** The same joint on the other side of the body. */
function mirrored(joint: string): string {
  return joint.replace(/left|right/, (side) => (side === 'left' ? 'right' : 'left'));
}

describe.each([
  { ...BLAZEPOSE_33, count: 33, left: 16 },
  { ...COCO_17, count: 17, left: 8 },
  { ...HALPE_26, count: 26, left: 11 },
])('$name', ({ joints, bones, sides, root, count, left }) => {
  it('has joints of different names, each with its side', () => {
    expect(joints).toHaveLength(count);
    expect(new Set(joints).size).toBe(count);
    expect(sides).toHaveLength(count);
    expect(sides.filter((side) => side === 'left')).toHaveLength(left);
    expect(sides.filter((side) => side === 'right')).toHaveLength(left);
    expect(sides[joints.indexOf('nose')]).toBe('middle');
  });

  it('is the same on the left as on the right', () => {
    const names = (bone: readonly number[]) => bone.map((k) => joints[k]!);
    const key = (bone: readonly string[]) => bone.toSorted().join('–');
    const all = new Set(bones.map((bone) => key(names(bone))));
    expect(all.size).toBe(bones.length);
    for (const joint of joints) expect(joints).toContain(mirrored(joint));
    for (const bone of bones) expect(all).toContain(key(names(bone).map(mirrored)));
  });

  it('has bones between different joints that there are, and hips as its root', () => {
    for (const [from, to] of bones) {
      expect(from).not.toBe(to);
      expect(joints[from]).toBeDefined();
      expect(joints[to]).toBeDefined();
    }
    expect(root.map((k) => joints[k])).toEqual(['left_hip', 'right_hip']);
  });
});

it('of anybody is made from names and bones', () => {
  const joints = ['head', 'right_hip', 'left_hip', 'mouth_right'];
  const skeleton = skeletonFrom('odd', joints, [[0, 1]]);
  expect(skeleton).toEqual({
    name: 'odd',
    joints,
    bones: [[0, 1]],
    sides: ['middle', 'right', 'left', 'right'],
    root: [2, 1],
  });
  expect(skeletonFrom('arm', ['left_elbow'], []).root).toEqual([]);
  expect(haveSameJoints(skeleton, { ...skeleton, name: 'other', bones: [] })).toBe(true);
  expect(haveSameJoints(skeleton, COCO_17)).toBe(false);
  expect(haveSameJoints(COCO_17, HALPE_26)).toBe(false);
});
