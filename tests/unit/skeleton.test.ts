import { expect, it } from 'vitest';
import { BLAZEPOSE_33 } from '../../web/pose/blazepose33.ts';

const { joints, bones, sides, root } = BLAZEPOSE_33;

/** The same joint on the other side of the body. */
function mirrored(joint: string): string {
  return joint.replace(/left|right/, (side) => (side === 'left' ? 'right' : 'left'));
}

it('has 33 joints of different names, each with its side', () => {
  expect(joints).toHaveLength(33);
  expect(new Set(joints).size).toBe(33);
  expect(sides).toHaveLength(33);
  expect(sides.filter((side) => side === 'left')).toHaveLength(16);
  expect(sides[joints.indexOf('nose')]).toBe('middle');
  expect(sides[joints.indexOf('mouth_right')]).toBe('right');
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
