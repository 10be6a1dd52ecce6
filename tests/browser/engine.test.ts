import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { createEngine } from '../../web/engine/client.ts';
import type {
  Engine,
  RecoveredClip,
  RecoverOptions,
  RecoverProgress,
} from '../../web/engine/types.ts';
import type { DeciWatchErrorCode } from '../../web/errors.ts';
import { hasPose, type PoseSequence, poseAt } from '../../web/pose/sequence.ts';
import { fixture, known, walk } from './fixtures.ts';

const LEFT_KNEE = 25;
const LEFT_ANKLE = 27;
const LEFT_HIP = 23;
const RIGHT_HIP = 24;

let engine: Engine;
beforeAll(() => {
  engine = createEngine();
});
afterAll(() => engine.close());

function options(more: Partial<RecoverOptions> = {}): RecoverOptions {
  return { every: 10, estimator: 'lite', ...more };
}

/** The engine's own estimators give 3D. */
type SpatialClip = RecoveredClip & { readonly poses3d: PoseSequence };

async function recover(name: string, more: Partial<RecoverOptions> = {}): Promise<SpatialClip> {
  const file = name === 'walk.mp4' ? await walk() : await fixture(name);
  const clip = await engine.recover(file, name, options(more));
  expect(clip.poses3d).not.toBeNull();
  return clip as SpatialClip;
}

function frames(flags: ArrayLike<number>): number[] {
  return Array.from(flags).flatMap((flag, frame) => (flag ? [frame] : []));
}

function joint(sequence: PoseSequence, frame: number, index: number): number[] {
  const { dims } = sequence;
  return Array.from(poseAt(sequence, frame).subarray(index * dims, (index + 1) * dims));
}

describe('the sample, N = 10', () => {
  const progress: RecoverProgress[] = [];
  let clip: SpatialClip;
  beforeAll(async () => {
    clip = await recover('walk.mp4', { onProgress: (step) => progress.push(step) });
  });

  test('is watched at frames 0, 10, … and the last, and nowhere else', () => {
    const last = clip.source.frameCount - 1;
    const expected = [...Array(last + 1).keys()].filter((k) => k % 10 === 0 || k === last);
    for (const { watched } of [clip.poses2d, clip.poses3d])
      expect(frames(watched)).toEqual(expected);
    expect(clip.cost.estimatorCalls).toBe(expected.length);
  });

  test('has a pose in every frame: 2D in the picture, 3D of a human size, at the mid-hip', () => {
    const { source, poses2d, poses3d } = clip;
    expect(poses2d.times.length).toBe(source.frameCount);
    expect(poses2d.values.length).toBe(source.frameCount * 33 * 2);
    expect(poses3d.values.length).toBe(source.frameCount * 33 * 3);
    for (const { values, scores } of [poses2d, poses3d]) {
      expect(values.every(Number.isFinite)).toBe(true);
      expect(scores.every((score) => score >= 0 && score <= 1)).toBe(true);
    }
    for (let frame = 0; frame < source.frameCount; frame++) {
      const [x, y] = joint(poses2d, frame, LEFT_HIP) as [number, number];
      expect(x > 0 && x < source.width && y > 0 && y < source.height).toBe(true);
      const [hip, other, knee, ankle] = [LEFT_HIP, RIGHT_HIP, LEFT_KNEE, LEFT_ANKLE].map((index) =>
        joint(poses3d, frame, index),
      ) as [number[], number[], number[], number[]];
      for (let d = 0; d < 3; d++) expect(hip[d]! + other[d]!).toBeCloseTo(0, 5);
      const shin = Math.hypot(...knee.map((value, d) => value - ankle[d]!));
      expect(shin).toBeGreaterThan(0.25);
      expect(shin).toBeLessThan(0.6);
      // y is up: the ankle hangs below the hip.
      expect(ankle[1]!).toBeLessThan(hip[1]!);
    }
  });

  test('costs little more than one N-th', () => {
    const { cost } = clip;
    expect(cost.frames).toBe(clip.source.frameCount);
    expect(cost.flopsRatio).toBeGreaterThan(1 / 10);
    expect(cost.flopsRatio).toBeLessThan(1 / 10 + 0.02);
    expect(cost.flopsPerFrame.denoise).toBeGreaterThan(0);
    expect(cost.flopsPerFrame.recover).toBeGreaterThan(0);
    expect(cost.msPerEstimatorCall).toBeGreaterThan(0);
    expect(cost.wallMs).toBeGreaterThan(cost.msPerFrame.estimator * cost.frames);
  });

  test('progress never falls and ends at 1', () => {
    expect(progress[0]!.fraction).toBe(0);
    expect(progress.at(-1)).toEqual({
      stage: 'recovering',
      fraction: 1,
      framesDone: clip.source.frameCount,
      framesTotal: clip.source.frameCount,
    });
    for (const [i, step] of progress.slice(1).entries()) {
      expect(step.fraction).toBeGreaterThanOrEqual(progress[i]!.fraction);
    }
    expect(new Set(progress.map(({ stage }) => stage))).toEqual(
      new Set(['loading', 'watching', 'recovering']),
    );
  });
});

test('where nobody is for long, there is no pose, never a zero pose', async () => {
  const { poses2d, poses3d } = await recover('gap.mp4', { every: 5 });
  const gap = { from: 36, to: 69 };
  for (const poses of [poses2d, poses3d]) {
    for (let frame = gap.from; frame < gap.to; frame++) {
      expect(poseAt(poses, frame).every(Number.isNaN)).toBe(true);
      expect(poses.scores.subarray(frame * 33, (frame + 1) * 33).every((s) => s === 0)).toBe(true);
    }
    expect(hasPose(poses, gap.from - 6)).toBe(true);
    expect(hasPose(poses, gap.to + 6)).toBe(true);
    // Looked at, though nobody was there.
    expect(poses.watched[50]).toBe(1);
  }
});

test.each([1, 20])('N = %i gives a pose for each frame before the gap', async (every) => {
  const { poses3d, cost } = await recover('gap.mp4', { every });
  const { length } = known('gap.mp4').times;
  expect(cost.estimatorCalls).toBe(Math.ceil((length - 1) / every) + 1);
  for (let frame = 0; frame <= 20; frame++) expect(hasPose(poses3d, frame)).toBe(true);
});

test.each<[string, DeciWatchErrorCode]>([
  ['empty-room.mp4', 'nobody-in-view'],
  ['two-frames.mp4', 'nobody-in-view'],
  ['corrupt.mp4', 'file-unreadable'],
  ['audio-only.mp4', 'no-video-track'],
  ['truncated.mp4', 'file-truncated'],
])('%s is refused as %s, in one sentence that names it', async (name, code) => {
  const refusal = recover(name);
  await expect(refusal).rejects.toMatchObject({ name: 'DeciWatchError', code });
  await expect(refusal).rejects.toThrow(new RegExp(`${name}.*\\.$`));
});

test.each([0, 21, 2.5, Number.NaN])('N = %d is refused', async (every) => {
  await expect(recover('gap.mp4', { every })).rejects.toMatchObject({ code: 'bad-option' });
});

test('an estimator that does not exist is refused', async () => {
  const estimator = 'huge' as RecoverOptions['estimator'];
  await expect(recover('gap.mp4', { estimator })).rejects.toMatchObject({ code: 'bad-option' });
});

test('an aborted job ends at once, and the next one works', async () => {
  const abort = new AbortController();
  const seen: number[] = [];
  const job = recover('walk.mp4', {
    every: 1,
    signal: abort.signal,
    onProgress: ({ stage, framesDone }) => {
      seen.push(framesDone);
      if (stage === 'watching' && framesDone > 2) abort.abort();
    },
  });
  await expect(job).rejects.toMatchObject({ name: 'AbortError' });
  const told = seen.length;
  const start = performance.now();
  const next = await recover('gap.mp4');
  // Nearly two minutes of work would lie before it, had the first job gone on.
  expect(performance.now() - start).toBeLessThan(8000);
  expect(next.source.name).toBe('gap.mp4');
  expect(seen.length).toBe(told);
});

test('a job that waits for another can be aborted, and the other goes on', async () => {
  const abort = new AbortController();
  const first = recover('gap.mp4');
  const second = recover('gap.mp4', { signal: abort.signal });
  abort.abort();
  await expect(second).rejects.toMatchObject({ name: 'AbortError' });
  expect((await first).source.frameCount).toBe(105);
});

test('another estimator takes over, with its own cost', async () => {
  const lite = await recover('gap.mp4', { every: 20 });
  const full = await recover('gap.mp4', { every: 20, estimator: 'full' });
  expect(lite.estimator.name).toBe('lite');
  expect(full.estimator.name).toBe('full');
  expect(full.estimator.flops).toBeGreaterThan(lite.estimator.flops);
  expect(hasPose(full.poses2d, 0)).toBe(true);
});

test('a missing manifest, and one that is something else, are told by their address', async () => {
  const cases: [string, DeciWatchErrorCode][] = [
    ['/nowhere', 'model-missing'],
    ['/tests/fixtures/foreign', 'model-mismatch'],
  ];
  for (const [models, code] of cases) {
    const other = createEngine({ models });
    const job = other.recover(await fixture('gap.mp4'), 'gap.mp4', options());
    await expect(job).rejects.toMatchObject({ code });
    await expect(job).rejects.toThrow(`${models}/models/manifest.json`);
    other.close();
  }
});

test('closing the engine ends the job under way', async () => {
  const other = createEngine();
  const job = other.recover(await fixture('gap.mp4'), 'gap.mp4', options());
  setTimeout(() => other.close(), 50);
  await expect(job).rejects.toMatchObject({ name: 'AbortError' });
});
