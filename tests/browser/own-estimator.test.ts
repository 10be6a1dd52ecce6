import * as ort from 'onnxruntime-web/wasm';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { fetchListed } from '../../web/download.ts';
import { createEngine } from '../../web/engine/client.ts';
import { engineFiles } from '../../web/engine/files.ts';
import type { LiveSettings } from '../../web/engine/live/types.ts';
import type { Engine, RecoveredClip, RecoverOptions } from '../../web/engine/types.ts';
import { DeciWatchError } from '../../web/errors.ts';
import type { PoseEstimate, PoseEstimator } from '../../web/estimators/estimator.ts';
import { fetchEstimatorManifest } from '../../web/estimators/manifest.ts';
import { MediaPipeEstimator } from '../../web/estimators/mediapipe.ts';
import { OnnxPoseEstimator } from '../../web/estimators/onnx-estimator.ts';
import { RecordedEstimator, type RecordedPoses } from '../../web/estimators/recorded.ts';
import { parsePoseFile, posesFromFile, toPoseFile } from '../../web/formats/pose-file.ts';
import { BLAZEPOSE_33 } from '../../web/pose/blazepose33.ts';
import { COCO_17 } from '../../web/pose/coco17.ts';
import { mpjpe } from '../../web/pose/metrics.ts';
import { hasPose } from '../../web/pose/sequence.ts';
import { skeletonFrom } from '../../web/pose/skeleton.ts';
import { watchedFrames } from '../../web/sampling/watched.ts';
import { openFile } from '../../web/sources/file.ts';
import { colourSession, fixture, walk } from './fixtures.ts';

let engine: Engine;
beforeAll(() => {
  engine = createEngine();
});
afterAll(() => engine.close());

async function recoverGap(
  estimator: RecoverOptions['estimator'],
  more: Partial<RecoverOptions> = {},
): Promise<RecoveredClip> {
  return engine.recover(await fixture('gap.mp4'), 'gap.mp4', { every: 10, estimator, ...more });
}

/** Looks as it is told to, and keeps what it was shown. */
class ToldEstimator implements PoseEstimator {
  readonly name = 'told';
  readonly flops = 2e9;
  readonly shown: { image: ImageBitmap; width: number; timeMs: number }[] = [];
  closed = false;

  constructor(
    private readonly answer: (call: number) => unknown,
    readonly skeleton = COCO_17,
  ) {}

  async estimate(image: ImageBitmap, timeMs: number): Promise<PoseEstimate | null> {
    this.shown.push({ image, width: image.width, timeMs });
    return (await this.answer(this.shown.length)) as PoseEstimate | null;
  }

  close(): void {
    this.closed = true;
  }
}

/** K keypoints on a line that moves with each call. */
function moving(joints: number, dims: 2 | 3): (call: number) => PoseEstimate {
  return (call) => ({
    keypoints2d: Float32Array.from({ length: joints * 2 }, (_, i) => 10 * call + i),
    keypoints3d:
      dims === 3 ? Float32Array.from({ length: joints * 3 }, (_, i) => Math.sin(i) / 2) : null,
    scores: new Float32Array(joints).fill(0.5),
  });
}

/** What MediaPipe sees of a clip's watched frames, raw. */
async function rawEstimates(file: Blob, every: number): Promise<RecordedPoses> {
  const { estimators: set, mediapipe: files } = engineFiles();
  const { lite } = (await fetchEstimatorManifest(set)).estimators;
  const bundle = await fetchListed(set, lite);
  const estimator = await MediaPipeEstimator.create({ name: 'lite', flops: 1, bundle, files });
  const clip = await openFile(file, 'clip');
  const { times } = clip;
  const joints = BLAZEPOSE_33.joints.length;
  const empty = (dims: number) => new Float32Array(times.length * joints * dims).fill(Number.NaN);
  const shared = {
    skeleton: BLAZEPOSE_33,
    times,
    scores: new Float32Array(times.length * joints),
    watched: new Uint8Array(times.length),
  };
  const poses2d = { ...shared, dims: 2 as const, values: empty(2) };
  const poses3d = { ...shared, dims: 3 as const, values: empty(3) };
  for await (const { index, image } of clip.frames(watchedFrames(times.length, every))) {
    const pose = await estimator.estimate(image);
    if (!pose) continue;
    poses2d.values.set(pose.keypoints2d, index * joints * 2);
    poses3d.values.set(pose.keypoints3d, index * joints * 3);
    shared.scores.set(pose.scores, index * joints);
  }
  clip.close();
  estimator.close();
  return { poses2d, poses3d };
}

describe('poses that were recorded', () => {
  let lite: RecoveredClip;
  beforeAll(async () => {
    lite = await engine.recover(await walk(), 'walk.mp4', { every: 10, estimator: 'lite' });
  });
  const apart = (a: RecoveredClip, dims: 2 | 3) => {
    const [one, other] = dims === 2 ? [a.poses2d, lite.poses2d] : [a.poses3d!, lite.poses3d!];
    return mpjpe(one.values, other.values, { joints: 33, dims });
  };

  test('give what the estimator itself gives: the same samples, the same nets', async () => {
    const recorded = new RecordedEstimator(await rawEstimates(await walk(), 10), { flops: 3e9 });
    const clip = await engine.recover(await walk(), 'walk.mp4', { every: 10, estimator: recorded });
    expect(clip.recovery).toBe('nets');
    expect(clip.poses2d.watched).toEqual(lite.poses2d.watched);
    expect(clip.poses3d!.values.every(Number.isFinite)).toBe(true);
    expect(apart(clip, 2)).toBeLessThan(1e-3);
    expect(apart(clip, 3)).toBeLessThan(1e-5);
    expect(clip.estimator).toEqual({ name: 'recorded', flops: 3e9 });
    expect(clip.cost.everyFrameFlopsPerFrame).toBe(3e9);
    expect(clip.cost.estimatorCalls).toBe(lite.cost.estimatorCalls);
    expect(clip.cost.flopsRatio).toBeGreaterThan(0.1);
  });

  // The nets take off what MediaPipe adds, which is no longer there.
  test('already recovered, they stay near', async () => {
    const recorded = new RecordedEstimator(lite);
    const again = await engine.recover(await walk(), 'walk.mp4', {
      every: 10,
      estimator: recorded,
    });
    expect(apart(again, 2)).toBeLessThan(5);
    expect(apart(again, 3)).toBeLessThan(0.06);
    expect(again.cost.flopsRatio).toBeNull();
  });
});

test('an ONNX model in 2D: a spline, no 3D, and a pose file that says so', async () => {
  const session = await colourSession('heatmap');
  const estimator = new OnnxPoseEstimator({
    name: 'colours',
    session,
    Tensor: ort.Tensor,
    input: { width: 48, height: 64 },
    decode: 'heatmap',
    skeleton: skeletonFrom('spots', ['red', 'green', 'blue'], [[0, 1]]),
    leastScore: 0,
  });
  const clip = await recoverGap(estimator);
  expect(clip.recovery).toBe('cubic');
  expect(clip.poses3d).toBeNull();
  expect(clip.poses2d.skeleton.joints).toEqual(['red', 'green', 'blue']);
  expect(clip.poses2d.values.every(Number.isFinite)).toBe(true);
  expect(clip.cost.flopsRatio).toBeNull();
  // What it sees in a watched frame is what the clip says of that frame.
  const source = await openFile(await fixture('gap.mp4'), 'gap.mp4');
  for await (const { index, image, time } of source.frames([20])) {
    const seen = (await estimator.estimate(image, time * 1000))!;
    const row = Array.from(clip.poses2d.values.subarray(index * 6, index * 6 + 6));
    seen.keypoints2d.forEach((value, i) => {
      expect(row[i]).toBeCloseTo(value, 1);
    });
  }
  source.close();
  const file = parsePoseFile(JSON.parse(JSON.stringify(toPoseFile(clip))));
  expect(file).toMatchObject({ recovery: 'cubic', estimator: { name: 'colours', flops: 0 } });
  expect(file.frames.every(({ keypoints3d }) => keypoints3d === null)).toBe(true);
  expect(posesFromFile(file).poses3d).toBeNull();
});

test("another skeleton in 3D keeps its 3D, by a spline; the nets' own in 2D alone has none", async () => {
  const coco = await recoverGap(new ToldEstimator(moving(17, 3)));
  expect(coco.recovery).toBe('cubic');
  expect(coco.poses3d!.values.every(Number.isFinite)).toBe(true);
  expect(coco.poses3d!.skeleton).toEqual(COCO_17);
  const flat = await recoverGap(new ToldEstimator(moving(33, 2), BLAZEPOSE_33));
  expect(flat).toMatchObject({ recovery: 'cubic', poses3d: null });
});

test('each watched frame is shown once, in order, at its time, and is closed afterwards', async () => {
  const estimator = new ToldEstimator(moving(17, 2));
  const { source, poses2d } = await recoverGap(estimator);
  const frames = Array.from(watchedFrames(source.frameCount, 10));
  expect(estimator.shown.map(({ timeMs }) => timeMs)).toEqual(
    frames.map((frame) => poses2d.times[frame]! * 1000),
  );
  expect(estimator.shown.every(({ width }) => width === source.width)).toBe(true);
  expect(estimator.shown.every(({ image }) => image.width === 0)).toBe(true);
  expect(estimator.closed).toBe(false);
});

test('where it sees nobody for long, there is no pose', async () => {
  const pose = moving(17, 2);
  // Calls 4 to 8 are frames 30 to 70.
  const estimator = new ToldEstimator((call) => (call >= 4 && call <= 8 ? null : pose(call)));
  const { poses2d } = await recoverGap(estimator);
  for (const [frame, isThere] of [
    [20, true],
    [21, false],
    [50, false],
    [79, false],
    [80, true],
  ] as const) {
    expect(hasPose(poses2d, frame)).toBe(isThere);
  }
});

describe('an estimator that fails', () => {
  const boom = new Error('The model is on holiday.');
  test.each<[string, (call: number) => unknown, string]>([
    ['throws', () => Promise.reject(boom), 'The model is on holiday'],
    ['throws a word', () => Promise.reject('no'), '(no)'],
    ['answers nothing', () => undefined, 'the answer should be a pose or null'],
    [
      'answers too few',
      moving(16, 2),
      'keypoints2d should be a Float32Array of 34 numbers, but has 32',
    ],
    [
      'answers NaN',
      () => ({ ...moving(17, 2)(1), scores: new Float32Array(17).fill(NaN) }),
      'scores[0] is NaN',
    ],
  ])('because it %s ends the job with one sentence', async (_, answer, words) => {
    const pose = moving(17, 2);
    const estimator = new ToldEstimator((call) => (call === 3 ? answer(call) : pose(call)));
    const error = await recoverGap(estimator).catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(DeciWatchError);
    const { code, message } = error as DeciWatchError;
    expect(code).toBe('estimator-failed');
    expect(message).toMatch(/^The estimator told failed on the frame at 0\.67 s \(.*\): .*\.$/);
    expect(message).toContain(words);
    expect(estimator.shown.length).toBe(3);
  });

  test('says what it threw, and the next job works', async () => {
    const failing = new ToldEstimator(() => Promise.reject(boom));
    await expect(recoverGap(failing)).rejects.toMatchObject({ cause: boom });
    expect((await recoverGap(new ToldEstimator(moving(17, 2)))).source.frameCount).toBe(105);
  });

  test('because it has 3D now and then is told so', async () => {
    const estimator = new ToldEstimator((call) => moving(33, call % 2 ? 2 : 3)(call), BLAZEPOSE_33);
    await expect(recoverGap(estimator)).rejects.toMatchObject({ code: 'estimator-failed' });
  });
});

test('an abort ends the job also while the estimator keeps its answer', async () => {
  const abort = new AbortController();
  const stuck = new ToldEstimator((call) => {
    if (call < 3) return moving(17, 2)(call);
    abort.abort();
    return new Promise(() => {});
  });
  await expect(recoverGap(stuck, { signal: abort.signal })).rejects.toMatchObject({
    name: 'AbortError',
  });
  expect(stuck.shown.length).toBe(3);
  expect((await recoverGap(new ToldEstimator(moving(17, 2)))).recovery).toBe('cubic');
});

test('an estimator is asked one thing at a time, also after an abort', async () => {
  const abort = new AbortController();
  let busy = 0;
  let most = 0;
  const slow = new ToldEstimator(async (call) => {
    most = Math.max(most, ++busy);
    if (call === 2) {
      abort.abort();
      await new Promise((resolve) => setTimeout(resolve, 300));
    }
    busy--;
    return moving(17, 2)(call);
  });
  const first = recoverGap(slow, { signal: abort.signal });
  await expect(first).rejects.toMatchObject({ name: 'AbortError' });
  await recoverGap(slow);
  expect(most).toBe(1);
});

test('what is no estimator is refused, and live playback takes names alone', async () => {
  const sound = new ToldEstimator(moving(17, 2));
  for (const spoiled of [
    null,
    { name: 'x' },
    { ...sound, estimate: sound.estimate, flops: Number.NaN },
    { ...sound, estimate: sound.estimate, skeleton: { ...COCO_17, bones: [[0, 17]] } },
  ]) {
    const estimator = spoiled as unknown as PoseEstimator;
    await expect(recoverGap(estimator)).rejects.toMatchObject({ code: 'bad-option' });
  }
  const settings = { every: 10, estimator: sound, mode: 'smooth', load: 'adapt' };
  expect(() => engine.live(settings as unknown as LiveSettings)).toThrow(
    /Live playback takes no estimator of your own/,
  );
});
