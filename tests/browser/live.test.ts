import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { createEngine } from '../../web/engine/client.ts';
import type { LivePose, LiveSession, LiveSettings } from '../../web/engine/live/types.ts';
import type { Engine } from '../../web/engine/types.ts';
import { hasPose } from '../../web/pose/sequence.ts';
import { openCamera } from '../../web/sources/camera.ts';
import { CanvasCamera } from './canvas-camera.ts';
import { fixture } from './fixtures.ts';
import { OpenFrames } from './open-frames.ts';

const SETTINGS: LiveSettings = { every: 8, estimator: 'lite', mode: 'smooth', load: 'skip' };
const MINUTE = 60_000;

/** A fifth of the picture. On a busy machine what was foreseen can be wrong by as much, and is put right quickly. */
const LEAP_PX = 128;

let camera: CanvasCamera;
let engine: Engine;
let session: LiveSession;

beforeEach(async () => {
  camera = await CanvasCamera.start();
  engine = createEngine();
});
afterEach(() => {
  engine.close();
  camera.close();
});

function start(settings: Partial<LiveSettings> = {}): void {
  session = engine.live({ ...SETTINGS, ...settings });
  camera.feed(session);
}

async function until(state: string): Promise<void> {
  await expect.poll(() => view() && session.status.state, { timeout: MINUTE }).toBe(state);
}

function view() {
  return session.view(performance.now() / 1000);
}

interface Picture {
  readonly at: number;
  readonly pose: LivePose | null;
}

/** What is drawn at each picture of the screen, for some seconds. */
async function watch(seconds: number): Promise<Picture[]> {
  const pictures: Picture[] = [];
  const end = performance.now() + 1000 * seconds;
  while (performance.now() < end) {
    await new Promise(requestAnimationFrame);
    pictures.push({ at: performance.now() / 1000, pose: view().pose });
  }
  return pictures;
}

const values = ({ values2d, values3d, scores }: LivePose) => [...values2d, ...values3d, ...scores];

/**
 * The farthest that any keypoint moves from one picture to the next, in pixels, beyond what a passage
 * from one stretch to the next may do in that time on a machine that draws few pictures.
 */
function farthestLeap(pictures: readonly Picture[]): number {
  let farthest = 0;
  for (const [i, { at, pose }] of pictures.entries()) {
    const before = pictures[i - 1];
    if (!before?.pose || !pose) continue;
    const allowed = 1500 * Math.max(0, at - before.at - 1 / 60);
    pose.values2d.forEach((value, k) => {
      farthest = Math.max(farthest, Math.abs(value - before.pose!.values2d[k]!) - allowed);
    });
  }
  return farthest;
}

/** The share of the pictures in which somebody is, all but faded in. */
function presentShare(pictures: readonly Picture[]): number {
  return pictures.filter(({ pose }) => pose && pose.presence > 0.6).length / pictures.length;
}

describe.each(['smooth', 'now'] as const)('live playback, %s', (mode) => {
  test('follows somebody through every picture of the screen, and leaves no frame open', async () => {
    const open = new OpenFrames();
    try {
      start({ mode });
      await until('following');
      await watch(1.5);
      const before = { ...session.totals };
      const pictures = await watch(2);
      const frames = session.totals.frames - before.frames;
      const calls = session.totals.calls - before.calls;
      expect(frames).toBeGreaterThan(20);
      expect(calls).toBeGreaterThan(0);
      expect(calls / frames).toBeLessThan(0.2);
      expect(presentShare(pictures)).toBeGreaterThan(0.9);
      const poses = pictures.map(({ pose }) => pose).filter((pose) => pose !== null);
      expect(poses.every((pose) => values(pose).every(Number.isFinite))).toBe(true);
      // The skeleton moves, and never leaps: the picture is 640 pixels wide.
      expect(new Set(poses.map((pose) => pose.values2d[0])).size).toBeGreaterThan(10);
      expect(farthestLeap(pictures)).toBeLessThan(LEAP_PX);
      const { delayMs, flopsRatio } = session.report;
      expect(flopsRatio).toBeLessThan(0.25);
      if (mode === 'now') expect(delayMs.median).toBeLessThan(200);
      else expect(delayMs.median).toBeGreaterThan((1000 * SETTINGS.every) / 30);
    } finally {
      session.close();
      open.restore();
    }
    expect(open.seen).toBeGreaterThan(0);
    await expect.poll(() => open.count).toBe(0);
  });

  test('somebody who leaves fades away, and comes back without a leap', async () => {
    start({ mode });
    await until('following');
    await watch(1);
    camera.empty = true;
    const leaving = await watch(2.5);
    expect(['lost', 'looking']).toContain(session.status.state);
    expect(leaving.at(-1)!.pose).toBeNull();
    const presences = leaving.flatMap(({ pose }) => (pose ? [pose.presence] : []));
    expect(presences.some((presence) => presence > 0 && presence < 1)).toBe(true);
    await until('looking');
    camera.empty = false;
    const coming = await watch(2.5);
    expect(session.status.state).toBe('following');
    const first = coming.find(({ pose }) => pose)!.pose!;
    expect(first.presence).toBeLessThan(0.7);
    expect(coming.at(-1)!.pose!.presence).toBeGreaterThan(0.6);
    for (const { pose } of [...leaving, ...coming]) {
      if (!pose) continue;
      expect(values(pose).every(Number.isFinite)).toBe(true);
      // Nobody flies through the picture's corner, where zero poses would be.
      expect(pose.values2d[0]! + pose.values2d[1]!).toBeGreaterThan(20);
    }
    expect(farthestLeap(coming)).toBeLessThan(LEAP_PX);
  });
});

test('a camera that falls silent is said to, and goes on afresh', async () => {
  start();
  await until('following');
  camera.silent = true;
  const pictures = await watch(2);
  expect(session.status.state).toBe('waiting');
  expect(pictures.at(-1)!.pose).toBeNull();
  camera.silent = false;
  await until('following');
  await expect.poll(() => view().pose?.presence, { timeout: MINUTE }).toBe(1);
});

test.each([12, 60])('follows a camera of %i frames a second', async (rate) => {
  camera.close();
  camera = await CanvasCamera.start(rate);
  start({ every: rate === 12 ? 4 : 20 });
  await until('following');
  await watch(1);
  const before = { ...session.totals };
  const pictures = await watch(2);
  // A busy machine passes frames over; what it sees of them is counted as of the camera's rate.
  expect(Math.abs(session.status.frameRate - rate)).toBeLessThan(rate * 0.5);
  expect(session.totals.frames - before.frames).toBeGreaterThan(rate / 2);
  expect(presentShare(pictures)).toBeGreaterThan(0.9);
});

test('settings change while it runs', async () => {
  start();
  await until('following');
  session.change({ ...SETTINGS, every: 4, mode: 'now', load: 'adapt' });
  await until('following');
  await expect.poll(() => view().pose?.presence, { timeout: MINUTE }).toBe(1);
  expect(session.status.every).toBeGreaterThanOrEqual(4);
  expect(() => session.change({ ...SETTINGS, every: 0 })).toThrow(/from 1 to 20/);
});

test('a recording is recovered like a file', async () => {
  start();
  await until('following');
  session.startRecording();
  await watch(2);
  const clip = (await session.stopRecording('me.webm'))!;
  const { poses2d, poses3d, source } = clip;
  expect(source.frameCount).toBe(poses2d.times.length);
  expect(source.frameCount).toBeGreaterThan(20);
  expect(poses2d.times[0]).toBe(0);
  expect([...poses2d.times].every((time, i, all) => i === 0 || time > all[i - 1]!)).toBe(true);
  expect(poses2d.watched[0]).toBe(1);
  for (let frame = 0; frame < source.frameCount; frame++) {
    expect(hasPose(poses2d, frame) && hasPose(poses3d!, frame)).toBe(true);
  }
  expect(clip.cost.estimatorCalls).toBe(poses2d.watched.reduce((sum, flag) => sum + flag, 0));
});

test('a recording of nobody is nothing', async () => {
  camera.empty = true;
  start();
  await until('looking');
  session.startRecording();
  await watch(1);
  expect(await session.stopRecording('nobody.webm')).toBeNull();
});

test('a second session ends the first', async () => {
  start();
  const first = session;
  await until('following');
  start({ mode: 'now' });
  await until('following');
  const { frames } = first.totals;
  await watch(0.3);
  expect(first.totals.frames).toBe(frames);
});

test('a clip is recovered meanwhile, by another estimator', { timeout: 3 * MINUTE }, async () => {
  start();
  session.onError = (error) => told.push(error.code);
  const told: string[] = [];
  await until('following');
  const gap = await fixture('gap.mp4');
  const before = session.totals.calls;
  // The first loads its estimator while the camera is looked at, the second has it.
  for (let i = 0; i < 2; i++) {
    const clip = await engine.recover(gap, 'gap.mp4', { every: 20, estimator: 'full' });
    expect(clip.estimator.name).toBe('full');
    expect(hasPose(clip.poses2d, 0)).toBe(true);
  }
  await until('following');
  expect(session.totals.calls).toBeGreaterThan(before);
  expect(told).toEqual([]);
});

test('an estimator that does not exist is refused, and the session goes on', async () => {
  start();
  await until('following');
  const wrong = { ...SETTINGS, estimator: 'huge' } as unknown as LiveSettings;
  expect(() => session.change(wrong)).toThrow(/huge/);
  expect(session.settings).toEqual(SETTINGS);
  await until('following');
});

describe('the camera', () => {
  const real = navigator.mediaDevices.getUserMedia;
  afterEach(() => {
    navigator.mediaDevices.getUserMedia = real;
  });

  test.each([
    ['NotAllowedError', 'camera-refused'],
    ['NotFoundError', 'camera-missing'],
    ['NotReadableError', 'camera-busy'],
  ])('%s is told as %s', async (name, code) => {
    navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException('no', name));
    await expect(openCamera()).rejects.toMatchObject({ code });
  });

  test('one that is unplugged is told of once, and closed', async () => {
    const stream = document.createElement('canvas').captureStream(30);
    navigator.mediaDevices.getUserMedia = async () => stream;
    const opened = await openCamera();
    const told: string[] = [];
    opened.onLost = (error) => told.push(error.code);
    const [track] = stream.getVideoTracks();
    track!.dispatchEvent(new Event('ended'));
    track!.dispatchEvent(new Event('ended'));
    expect(told).toEqual(['camera-lost']);
    expect(track!.readyState).toBe('ended');
  });
});
