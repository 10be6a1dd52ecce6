import { describe, expect, test } from 'vitest';
import { BLAZEPOSE_33 } from '../../web/pose/blazepose33.ts';
import type { PoseSequence } from '../../web/pose/sequence.ts';
import { bodyPlan } from '../../web/stage/body-plan.ts';
import { estimateStanding } from '../../web/stage/ground-level.ts';
import { framesSinceWatched } from '../../web/stage/stage.ts';

describe('bodyPlan', () => {
  const { segments, jointRadii, head } = bodyPlan(BLAZEPOSE_33);
  const joint = (name: string) => BLAZEPOSE_33.joints.indexOf(name);

  test('draws every bone, a spine and a neck', () => {
    expect(segments).toHaveLength(BLAZEPOSE_33.bones.length + 2);
    expect(segments.filter(({ from }) => from.length === 2)).toHaveLength(2);
    expect(head).toEqual([joint('left_ear'), joint('right_ear')]);
  });

  test('limbs keep their side and are thicker than hands, and hands than the face', () => {
    const bone = (from: string, to: string) =>
      segments.find((s) => s.from[0] === joint(from) && s.to[0] === joint(to))!;
    const arm = bone('left_elbow', 'left_wrist');
    const thumb = bone('left_wrist', 'left_thumb');
    expect(arm.side).toBe('left');
    expect(bone('left_shoulder', 'right_shoulder').side).toBe('middle');
    expect(arm.radius).toBeGreaterThan(thumb.radius);
    expect(thumb.radius).toBeGreaterThan(bone('left_eye', 'left_eye_outer').radius);
    expect(jointRadii[joint('left_knee')]).toBeGreaterThan(jointRadii[joint('nose')]!);
  });
});

describe('estimateStanding', () => {
  /** One joint at the feet and one at the head; `lows` are the feet's heights, NaN where nobody was seen. */
  const sequence = (lows: number[]): PoseSequence => ({
    skeleton: {
      name: 'two',
      joints: ['foot', 'head'],
      bones: [],
      sides: ['middle', 'middle'],
      root: [],
    },
    dims: 3,
    times: Float64Array.from(lows, (_, frame) => frame / 30),
    values: Float32Array.from(
      lows.flatMap((low) =>
        Number.isNaN(low) ? Array(6).fill(low) : [0.3, low, -0.2, 0.1, low + 1.6, 0],
      ),
    ),
    scores: new Float32Array(lows.length * 2).fill(1),
    watched: new Uint8Array(lows.length),
  });

  test('the lowest joint stands on the ground', () => {
    const { hipHeights, feet, stature } = estimateStanding(sequence(Array(9).fill(-0.9)));
    for (const height of hipHeights) expect(height).toBeCloseTo(0.922, 5);
    expect(feet[0]).toBeCloseTo(0.3, 5);
    expect(feet[1]).toBeCloseTo(-0.2, 5);
    expect(stature).toBeCloseTo(1.6, 5);
  });

  test('one frame’s jitter is spread out, and a gap is not averaged over', () => {
    const lows = [-0.9, -0.9, -0.9, -0.83, -0.9, -0.9, -0.9, Number.NaN, -0.5];
    const { hipHeights } = estimateStanding(sequence(lows));
    expect(hipHeights[3]).toBeCloseTo(0.912, 5);
    expect(hipHeights[7]).toBe(0);
    expect(hipHeights[8]).toBeCloseTo(0.522, 5);
    expect(hipHeights[6]).toBeCloseTo(0.922, 5);
  });

  test('a clip with nobody in it still has a size to frame', () => {
    expect(estimateStanding(sequence([Number.NaN])).stature).toBeGreaterThan(1);
  });
});

test('framesSinceWatched counts from the last look', () => {
  const watched = Uint8Array.of(0, 1, 0, 0, 1);
  expect([0, 1, 3, 4].map((frame) => framesSinceWatched(watched, frame))).toEqual([
    Number.POSITIVE_INFINITY,
    0,
    2,
    0,
  ]);
});
