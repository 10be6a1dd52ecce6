import { describe, expect, test } from 'vitest';
import { LiveMeter } from '../../web/cost/live-meter.ts';
import { isSomebody } from '../../web/engine/live/presence.ts';
import { Recording } from '../../web/engine/live/recording.ts';
import type { SpatialEstimate } from '../../web/estimators/estimator.ts';
import { DrawGovernor } from '../../web/player/live/draw-governor.ts';
import { loadWords } from '../../web/player/live/live-words.ts';
import { cameraError, cameraLost, insecurePage } from '../../web/sources/camera-errors.ts';
import { LiveStanding } from '../../web/stage/live-standing.ts';

function estimate(scores: (k: number) => number): SpatialEstimate {
  return {
    keypoints2d: new Float32Array(66),
    keypoints3d: new Float32Array(99),
    scores: Float32Array.from({ length: 33 }, (_, k) => scores(k)),
  };
}

describe('camera errors', () => {
  test.each([
    ['NotAllowedError', 'camera-refused', /refused: allow it/],
    ['NotFoundError', 'camera-missing', /No camera was found: connect one/],
    ['OverconstrainedError', 'camera-missing', /choose another/],
    ['NotReadableError', 'camera-busy', /in use by another program/],
    ['AbortError', 'camera-busy', /close that program/],
    ['OddError', 'camera-missing', /OddError/],
  ])('%s is told as %s', (name, code, words) => {
    const error = cameraError(new DOMException('x', name));
    expect(error.code).toBe(code);
    expect(error.message).toMatch(words);
  });

  test('an insecure page and a camera that went away have words of their own', () => {
    expect(insecurePage().message).toMatch(/https/);
    expect(cameraLost().message).toMatch(/unplugged/);
  });
});

describe('isSomebody', () => {
  test('holds for a face alone, not for a guess', () => {
    expect(isSomebody(null)).toBe(false);
    expect(isSomebody(estimate((k) => (k < 11 ? 0.95 : 0.02)))).toBe(true);
    expect(isSomebody(estimate(() => 0.2))).toBe(false);
  });
});

describe('LiveMeter', () => {
  test('counts what was called and shown, for each camera frame of the last ten seconds', () => {
    const meter = new LiveMeter(1000);
    for (let i = 0; i < 100; i++) {
      const at = i / 10;
      meter.addFrame(at, i === 50 ? 1 : 0, 20);
      if (i % 10 === 0) {
        meter.addWatched({
          at,
          estimatorMs: 50,
          denoiseMs: 1,
          recoverMs: 2,
          denoiseFlops: 30,
          recoverFlops: 40,
        });
      }
      meter.addShown(at, 300 + i);
    }
    const report = meter.report();
    expect(report.frames).toBe(101);
    expect(report.missed).toBe(1);
    expect(report.estimatorCalls).toBe(10);
    expect(report.flopsPerFrame.total).toBeCloseTo((10 * 1070) / 101);
    expect(report.flopsRatio).toBeCloseTo(10.7 / 101);
    expect(report.msPerFrame.estimator).toBeCloseTo(500 / 101);
    expect(report.msPerEstimatorCall).toBe(50);
    expect(report.delayMs).toEqual({ median: 350, p95: 395 });
    expect(report.cameraMs).toBe(20);
    meter.addFrame(15, 0, 20);
    expect(meter.report().frames).toBe(50);
    expect(meter.totals).toEqual({ frames: 102, missed: 1, calls: 10, shown: 100 });
  });
});

const SIZE = { width: 640, height: 480 };

describe('Recording', () => {
  test('ends where the camera was turned, in the pixels that it began with', async () => {
    const recording = new Recording();
    const turned = { width: 480, height: 640 };
    for (let i = 0; i <= 24; i++) recording.addFrame(i / 30, i % 10 === 0, SIZE);
    for (let i = 25; i <= 40; i++) recording.addFrame(i / 30, i % 10 === 0, turned);
    for (const i of [0, 10, 20, 30]) {
      recording.addWatched(
        i / 30,
        estimate(() => 0.9),
        50,
      );
    }
    expect(recording.until).toBeCloseTo(24 / 30);
    await recording.end();
    const { info, watched } = recording.finish('r')!;
    expect(info).toMatchObject({ ...SIZE, frameCount: 21 });
    expect(watched).toEqual([0, 10, 20]);
  });

  test('runs from the first watched frame to the last one, times from 0', () => {
    const recording = new Recording();
    recording.addFrame(9.9, false, SIZE);
    expect(recording.since).toBeNull();
    const seen = estimate(() => 0.9);
    for (let i = 0; i <= 22; i++) recording.addFrame(10 + i / 30, i % 10 === 0, SIZE);
    expect(recording.since).toBe(10);
    recording.addWatched(10, seen, 50);
    recording.addWatched(10 + 10 / 30, null, 50);
    recording.addWatched(10 + 20 / 30, seen, 50);
    const found = recording.finish('r.webm')!;
    expect(found.info).toMatchObject({ name: 'r.webm', width: 640, frameCount: 21 });
    expect(found.info.frameRate).toBeCloseTo(30);
    expect([...found.times.slice(0, 2), found.times.length]).toEqual([
      0,
      expect.closeTo(1 / 30),
      21,
    ]);
    expect(found.watched).toEqual([0, 10, 20]);
    expect(found.seen.map(({ frame }) => frame)).toEqual([0, 20]);
    expect(found.estimatorMs).toBe(150);
  });

  test('ends with the look after the one who stops it, and waits for its answer', async () => {
    const recording = new Recording();
    const seen = estimate(() => 0.9);
    const frame = (i: number) => recording.addFrame(i / 30, i % 10 === 0, SIZE);
    const answer = (i: number) => recording.addWatched(i / 30, seen, 50);
    for (let i = 0; i <= 14; i++) frame(i);
    answer(0);
    let ended = false;
    const end = recording.end().then(() => {
      ended = true;
    });
    answer(10);
    for (let i = 15; i <= 25; i++) frame(i);
    expect(recording.until).toBeCloseTo(20 / 30);
    await Promise.resolve();
    expect(ended).toBe(false);
    answer(20);
    await end;
    expect(recording.finish('r')!.info.frameCount).toBe(21);
  });

  test('is nothing where nobody was seen, or it ended at once', () => {
    const recording = new Recording();
    recording.addFrame(1, true, SIZE);
    recording.addWatched(1, null, 5);
    expect(recording.finish('r')).toBeNull();
    const short = new Recording();
    short.addFrame(1, true, SIZE);
    short.addWatched(
      1,
      estimate(() => 1),
      5,
    );
    expect(short.finish('r')).toBeNull();
  });
});

describe('LiveStanding', () => {
  test('puts the lowest joint on the ground at once, and follows without haste', () => {
    const standing = new LiveStanding();
    const pose = (low: number) => Float32Array.of(0, 0.6, 0, 0.2, low, 0.1);
    standing.follow(pose(-0.9), 0);
    expect(standing.hipHeight).toBeCloseTo(0.922, 2);
    expect(standing.feet[0]).toBeCloseTo(0.2);
    standing.follow(pose(-0.5), 0.01);
    expect(standing.hipHeight).toBeGreaterThan(0.85);
    for (let i = 2; i < 100; i++) standing.follow(pose(-0.5), i / 30);
    expect(standing.hipHeight).toBeCloseTo(0.522, 2);
  });
});

describe('DrawGovernor', () => {
  test('draws the 3D view with every picture while they come in time', () => {
    const governor = new DrawGovernor();
    for (let i = 0; i < 200; i++) expect(governor.offer(i * 16.7)).toBe(true);
  });

  test('draws it less often where pictures are held up, and more often again after', () => {
    const governor = new DrawGovernor();
    let stamp = 0;
    const pictures = (count: number, gap: number) => {
      for (let i = 0; i < count; i++) {
        stamp += gap;
        governor.offer(stamp);
      }
    };
    pictures(10, 80);
    expect(governor.every).toBe(6);
    pictures(600, 16.7);
    expect(governor.every).toBe(1);
    governor.offer(stamp + 60_000);
    expect(governor.every).toBe(1);
  });
});

test('a page says so when it watches less often than was asked for', () => {
  const settings = { every: 3, estimator: 'heavy', mode: 'now', load: 'adapt' } as const;
  const status = { state: 'following', frameRate: 30, every: 8 } as const;
  expect(loadWords(status, settings)).toMatch(/too slow for one frame in 3.*one in 8/);
  expect(loadWords({ ...status, every: 3 }, settings)).toBe('');
  expect(loadWords(status, { ...settings, load: 'skip' })).toBe('');
});
