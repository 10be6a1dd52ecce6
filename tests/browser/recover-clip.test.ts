import { afterAll, afterEach, beforeAll, beforeEach, expect, test } from 'vitest';
import { engineFiles } from '../../web/engine/files.ts';
import { ProgressReporter } from '../../web/engine/progress.ts';
import { recoverClip } from '../../web/engine/recover-clip.ts';
import type { PoseEstimator } from '../../web/estimators/estimator.ts';
import { BLAZEPOSE_33 } from '../../web/pose/blazepose33.ts';
import { poseAt } from '../../web/pose/sequence.ts';
import { Recoverer } from '../../web/recovery/recoverer.ts';
import type { Clip } from '../../web/sources/clip.ts';
import { openFile } from '../../web/sources/file.ts';
import { fixture } from './fixtures.ts';
import { OpenFrames } from './open-frames.ts';

/** Sees the same person everywhere, and lets a test step in after each call. */
class FakeEstimator implements PoseEstimator {
  readonly name = 'fake';
  readonly skeleton = BLAZEPOSE_33;
  readonly flops = 1e9;
  calls = 0;

  constructor(private readonly onCall: (calls: number) => void = () => {}) {}

  async estimate() {
    this.onCall(++this.calls);
    return {
      keypoints2d: Float32Array.from({ length: 33 * 2 }, (_, i) => 50 + (i % 40)),
      keypoints3d: Float32Array.from({ length: 33 * 3 }, (_, i) => Math.sin(i) / 2),
      scores: new Float32Array(33).fill(0.5),
    };
  }

  close() {}
}

let recoverer: Recoverer;
let openFrames: OpenFrames;
beforeAll(async () => {
  recoverer = await Recoverer.load(engineFiles().models);
});
afterAll(() => recoverer.dispose());
beforeEach(() => {
  openFrames = new OpenFrames();
});
afterEach(() => openFrames.restore());

function run(clip: Clip, every: number, estimator: PoseEstimator, abort = new AbortController()) {
  const progress = new ProgressReporter(() => {});
  return recoverClip({ clip, estimator, recoverer, every, progress, signal: abort.signal });
}

test('an abort stops within one estimator call and leaves no frame open', async () => {
  const abort = new AbortController();
  // From outside, as a message would: after the third call, before the fourth.
  const estimator = new FakeEstimator((calls) => {
    if (calls === 3) setTimeout(() => abort.abort());
  });
  const clip = await openFile(await fixture('vfr.mp4'), 'vfr.mp4');
  await expect(run(clip, 1, estimator, abort)).rejects.toMatchObject({ name: 'AbortError' });
  clip.close();
  expect(estimator.calls).toBeLessThanOrEqual(4);
  await expect.poll(() => openFrames.count).toBe(0);
  expect(openFrames.seen).toBeGreaterThanOrEqual(3);
});

test('an abort stops the nets between two windows', async () => {
  const abort = new AbortController();
  const clip = await openFile(await fixture('vfr.mp4'), 'vfr.mp4');
  const stages: string[] = [];
  const job = recoverClip({
    clip,
    estimator: new FakeEstimator(),
    recoverer,
    every: 1,
    progress: new ProgressReporter(({ stage }) => {
      if (stage === 'recovering' && !stages.includes(stage)) setTimeout(() => abort.abort());
      stages.push(stage);
    }),
    signal: abort.signal,
  });
  await expect(job).rejects.toMatchObject({ name: 'AbortError' });
  expect(stages).toContain('recovering');
  clip.close();
});

test('uneven frame times are kept, and a whole job leaves no frame open', async () => {
  const clip = await openFile(await fixture('vfr.mp4'), 'vfr.mp4');
  const { poses2d, poses3d } = await run(clip, 10, new FakeEstimator());
  clip.close();
  expect(poses3d!.times).toEqual(clip.times);
  expect(poses2d.values.every(Number.isFinite)).toBe(true);
  expect(poses2d.scores.every((score) => score === 0.5)).toBe(true);
  expect(openFrames.count).toBe(0);
});

test('two frames are enough', async () => {
  const clip = await openFile(await fixture('two-frames.mp4'), 'two-frames.mp4');
  const { poses3d, cost } = await run(clip, 10, new FakeEstimator());
  clip.close();
  expect(cost.estimatorCalls).toBe(2);
  expect(Array.from(poses3d!.watched)).toEqual([1, 1]);
  expect(poses3d!.values.every(Number.isFinite)).toBe(true);
});

test('so is one', async () => {
  const two = await openFile(await fixture('two-frames.mp4'), 'two-frames.mp4');
  const one: Clip = {
    info: { ...two.info, frameCount: 1 },
    times: two.times.slice(0, 1),
    frames: (indices) => two.frames(indices),
    close: () => two.close(),
  };
  const { poses2d, cost } = await run(one, 10, new FakeEstimator());
  one.close();
  expect(cost.estimatorCalls).toBe(1);
  expect(poseAt(poses2d, 0).every(Number.isFinite)).toBe(true);
  expect(poses2d.times.length).toBe(1);
});
