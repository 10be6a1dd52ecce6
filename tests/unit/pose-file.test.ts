import { readFileSync } from 'node:fs';
import { Ajv2020 } from 'ajv/dist/2020.js';
import type { InferOutput } from 'valibot';
import { describe, expect, expectTypeOf, it } from 'vitest';
import type { RecoveredClip } from '../../web/engine/types.ts';
import { DeciWatchError } from '../../web/errors.ts';
import {
  type PoseFile,
  parsePoseFile,
  poseFileName,
  posesFromFile,
  stringifyPoseFile,
  toPoseFile,
} from '../../web/formats/pose-file.ts';
import type { PoseFileSchema } from '../../web/formats/pose-file-schema.ts';
import type { PoseSequence } from '../../web/pose/sequence.ts';
import { pick, seededRandom } from './random.ts';
import { recoveredClip } from './recovered-clip.ts';

const docs = new URL('../../docs/', import.meta.url);
const schema = JSON.parse(readFileSync(new URL('pose-file.schema.json', docs), 'utf8'));
const fitsJsonSchema = new Ajv2020().compile(schema);

const sound = stringifyPoseFile(toPoseFile(recoveredClip(12, [5])));

/** What a reader gets from another program: plain JSON, sound until `spoil` has been at it. */
function spoiled(spoil: (file: PoseFile) => void): unknown {
  const file: PoseFile = JSON.parse(sound);
  spoil(file);
  return file;
}

function refusal(json: unknown): string {
  try {
    parsePoseFile(json);
  } catch (error) {
    if (error instanceof DeciWatchError && error.code === 'pose-file-invalid') return error.message;
    throw error;
  }
  return 'accepted';
}

/** Poses that are there in 3D too. */
function spatial<T extends { readonly poses3d: PoseSequence | null }>(poses: T) {
  expect(poses.poses3d).not.toBeNull();
  return { ...poses, poses3d: poses.poses3d! };
}

it('has a type that says all that the schema checks', () => {
  // The other direction is held where the schema is written.
  expectTypeOf<PoseFile>().toExtend<InferOutput<typeof PoseFileSchema>>();
});

describe('a written file', () => {
  it('is named after its clip', () => {
    expect(poseFileName('walk.mp4')).toBe('walk.poses.json');
    expect(poseFileName('my.best.take.mov')).toBe('my.best.take.poses.json');
    expect(poseFileName('clip')).toBe('clip.poses.json');
  });

  const clip = recoveredClip(23, [0, 7, 8]);
  const file = toPoseFile(clip);
  const text = stringifyPoseFile(file);

  it('comes back the same, and fits the JSON schema', () => {
    const json: unknown = JSON.parse(text);
    expect(fitsJsonSchema(json), JSON.stringify(fitsJsonSchema.errors)).toBe(true);
    expect(parsePoseFile(json)).toEqual(file);
  });

  it('holds the poses to the decimals that the documentation names', () => {
    const { poses2d, poses3d } = spatial(posesFromFile(parsePoseFile(JSON.parse(text))));
    const apart = (a: ArrayLike<number>, b: ArrayLike<number>) =>
      Math.max(...Array.from(a, (value, i) => (Number.isNaN(value) ? 0 : Math.abs(value - b[i]!))));
    expect(apart(poses2d.values, clip.poses2d.values)).toBeLessThan(0.00504);
    expect(apart(poses3d.values, spatial(clip).poses3d.values)).toBeLessThan(0.0000504);
    expect(apart(poses2d.times, clip.poses2d.times)).toBeLessThan(0.0000005);
    expect(apart(poses2d.scores, clip.poses2d.scores)).toBeLessThan(0.000504);
    expect(poses2d.watched).toEqual(clip.poses2d.watched);
    expect(poses3d.skeleton).toEqual(spatial(clip).poses3d.skeleton);
    expect([poses2d.dims, poses3d.dims]).toEqual([2, 3]);
    const unseen = (values: Float32Array, size: number) =>
      Array.from(clip.poses2d.times.keys()).filter((t) =>
        values.subarray(t * size, (t + 1) * size).every(Number.isNaN),
      );
    expect(unseen(poses2d.values, 66)).toEqual([0, 7, 8]);
    expect(unseen(poses3d.values, 99)).toEqual([0, 7, 8]);
  });

  it('has one frame to a line, with null where nobody was seen', () => {
    const lines = text.split('\n');
    expect(lines.filter((line) => line.startsWith('{"index"'))).toHaveLength(23);
    expect(lines.find((line) => line.startsWith('{"index":7,'))).toBe(
      '{"index":7,"time":0.233333,"watched":false,"keypoints2d":null,"keypoints3d":null,"scores":null},',
    );
    expect(text).not.toMatch(/-0[,\]]|\d\.\d{7}.*"index"/);
  });
});

describe('a file without 3D', () => {
  const clip: RecoveredClip = {
    ...recoveredClip(12, [0, 5]),
    recovery: 'cubic',
    poses3d: null,
  };
  const flat = () => JSON.parse(stringifyPoseFile(toPoseFile(clip)));

  it('fits both schemas, says what recovered it, and comes back without 3D', () => {
    expect(fitsJsonSchema(flat()), JSON.stringify(fitsJsonSchema.errors)).toBe(true);
    const file = parsePoseFile(flat());
    expect(file).toEqual(toPoseFile(clip));
    expect(file.recovery).toBe('cubic');
    const { poses2d, poses3d } = posesFromFile(file);
    expect(poses3d).toBeNull();
    expect(poses2d.values[66]).toBeCloseTo(clip.poses2d.values[66]!, 1);
    expect(poses2d.values[0]).toBeNaN();
  });

  it('has none in any frame', () => {
    const some = flat();
    some.frames[7].keypoints3d = some.frames[7].keypoints2d.map(() => [0, 0, 0]);
    expect(refusal(some)).toContain(
      'At frames[7].keypoints3d, the file should have null, as in the frames before',
    );
    const none = spoiled((f) => Object.assign(f.frames[7]!, { keypoints3d: null }));
    expect(refusal(none)).toContain('At frames[7].keypoints3d, the file should have a list');
  });

  it('may have no ratio of FLOPs', () => {
    const unknown = { ...flat(), cost: { ...clip.cost, flopsRatio: null } };
    expect(fitsJsonSchema(unknown)).toBe(true);
    expect(parsePoseFile(unknown).cost.flopsRatio).toBeNull();
  });
});

it('is read also where it is older than the choice of a recovery', () => {
  const old = spoiled((f) => Reflect.deleteProperty(f, 'recovery'));
  expect(fitsJsonSchema(old)).toBe(true);
  expect(parsePoseFile(old).recovery).toBeUndefined();
});

it("accepts the documentation's example", () => {
  const page = readFileSync(new URL('pose-file.md', docs), 'utf8');
  const example = JSON.parse(/```json\n([\s\S]*?)```/.exec(page)![1]!);
  expect(fitsJsonSchema(example)).toBe(true);
  expect(parsePoseFile(example)).toEqual(example);
});

describe('a broken file', () => {
  type Spoil = (file: PoseFile) => void;
  const shapeless: [string, Spoil][] = [
    ['format', (f) => Object.assign(f, { format: 'deciwatch-poses/2' })],
    ['source.width', (f) => Object.assign(f.source, { width: 0 })],
    ['source.duration', (f) => Object.assign(f.source, { duration: -1 })],
    ['skeleton.joints', (f) => Object.assign(f.skeleton, { joints: [] })],
    ['skeleton.bones[2]', (f) => Object.assign(f.skeleton.bones, { 2: [1, 2, 3] })],
    ['interval', (f) => Object.assign(f, { interval: 2.5 })],
    ['recovery', (f) => Object.assign(f, { recovery: 'magic' })],
    ['estimator', (f) => Reflect.deleteProperty(f, 'estimator')],
    ['cost.msPerFrame.decode', (f) => Reflect.deleteProperty(f.cost.msPerFrame, 'decode')],
    ['frames', (f) => Object.assign(f, { frames: [] })],
    ['frames[3].time', (f) => Object.assign(f.frames[3]!, { time: '0:03' })],
    ['frames[3].time', (f) => Object.assign(f.frames[3]!, { time: Infinity })],
    ['frames[11].watched', (f) => Object.assign(f.frames[11]!, { watched: 1 })],
    [
      'frames[2].keypoints2d[4][1]',
      (f) => Object.assign(f.frames[2]!.keypoints2d![4]!, { 1: null }),
    ],
    ['frames[2].keypoints2d[4]', (f) => Object.assign(f.frames[2]!.keypoints2d!, { 4: [1, 2, 3] })],
    [
      'frames[2].keypoints3d[4]',
      (f) => Object.assign(f.frames[2]!.keypoints3d!, { 4: [1, 2, 3, 4] }),
    ],
    ['frames[2].scores[0]', (f) => Object.assign(f.frames[2]!.scores!, { 0: 1.5 })],
    ['frames[2].scores', (f) => Object.assign(f.frames[2]!, { scores: null })],
    ['frames[5].keypoints3d', (f) => Object.assign(f.frames[5]!, { keypoints3d: [] })],
  ];
  it.each(shapeless)('is refused by both schemas at %s', (place, spoil) => {
    const json = spoiled(spoil);
    expect(fitsJsonSchema(json)).toBe(false);
    expect(refusal(json)).toContain(`At ${place}, the file should have`);
  });

  const inconsistent: [string, Spoil][] = [
    ['source.frames', (f) => Object.assign(f.source, { frames: 13 })],
    ['cost.frames', (f) => Object.assign(f.cost, { frames: 11 })],
    ['skeleton.bones[0]', (f) => Object.assign(f.skeleton.bones, { 0: [0, 33] })],
    ['skeleton.bones[1]', (f) => Object.assign(f.skeleton.bones, { 1: [4, 4] })],
    ['frames[6].index', (f) => Object.assign(f.frames[6]!, { index: 5 })],
    ['frames[6].time', (f) => Object.assign(f.frames[6]!, { time: f.frames[5]!.time })],
    ['frames[6].keypoints2d', (f) => f.frames[6]!.keypoints2d!.pop()],
    ['frames[6].scores', (f) => f.frames[6]!.scores!.push(0.5)],
  ];
  it.each(inconsistent)('is refused by the reader alone at %s', (place, spoil) => {
    const json = spoiled(spoil);
    expect(fitsJsonSchema(json)).toBe(true);
    expect(refusal(json)).toContain(`At ${place}, the file should have`);
  });

  it('is refused in one sentence that says what was found', () => {
    expect(refusal(spoiled((f) => Object.assign(f.frames[3]!, { time: 'x'.repeat(99) })))).toBe(
      `At frames[3].time, the file should have a number, but has "${'x'.repeat(40)}…": it is not a ` +
        'sound DeciWatch pose file; export it again, or correct it there.',
    );
    expect(refusal(spoiled((f) => Reflect.deleteProperty(f, 'interval')))).toMatch(
      /^At interval, the file should have a value, but has nothing:/,
    );
    for (const json of [null, 3, 'x', undefined]) {
      expect(refusal(json)).toMatch(/^The file should have /);
      expect(fitsJsonSchema(json)).toBe(false);
    }
  });

  it('is never let through by one schema alone, whatever was changed at random', () => {
    const random = seededRandom(3);
    const junk = [null, -1, 0.5, Infinity, '', 'left_hip', true, [], {}, [1, 2], [[1, 2]]];
    let refused = 0;
    for (let round = 0; round < 400; round++) {
      const json = spoiled((file) => {
        let place: object = file;
        for (;;) {
          const key = pick(random, Object.keys(place));
          const inner: unknown = Reflect.get(place, key);
          if (typeof inner === 'object' && inner !== null && random() < 0.8) {
            if (Object.keys(inner).length > 0) {
              place = inner;
              continue;
            }
          }
          if (random() < 0.2 && !Array.isArray(place)) Reflect.deleteProperty(place, key);
          else Reflect.set(place, key, pick(random, junk));
          return;
        }
      });
      const isRefused = refusal(json) !== 'accepted';
      if (isRefused) refused++;
      // What the JSON schema refuses, the reader must refuse; it may refuse more.
      if (!fitsJsonSchema(json)) expect(isRefused, JSON.stringify(json).slice(0, 400)).toBe(true);
      else if (isRefused) expect(refusal(json)).toMatch(/^At (source|cost|skeleton|frames)/);
    }
    expect(refused).toBeGreaterThan(200);
  });
});
