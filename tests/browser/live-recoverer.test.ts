import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest';
import { engineFiles } from '../../web/engine/files.ts';
import type { SpatialEstimate } from '../../web/estimators/estimator.ts';
import { type LiveChunk, LiveRecoverer } from '../../web/recovery/live-recoverer.ts';
import { Recoverer } from '../../web/recovery/recoverer.ts';
import inputs from '../fixtures/inputs.json';

const NONE = new Float64Array();
const INTERVAL = 1 / 3;

let recoverer: Recoverer;
beforeAll(async () => {
  recoverer = await Recoverer.load(engineFiles().models);
  await recoverer.loadForecasts();
  // It is asked for at every look; the files come once.
  const fetched = vi.spyOn(globalThis, 'fetch');
  await recoverer.loadForecasts();
  expect(fetched).not.toHaveBeenCalled();
});
afterAll(() => recoverer.dispose());

/** A made-up walker as an estimator sees them, from the fixtures; over and over. */
function estimate(i: number): SpatialEstimate {
  const one = inputs.cases[0]!;
  const count = one.sampleTimes.length;
  const part = (values: readonly number[]) => {
    const size = values.length / count;
    return Float32Array.from(values.slice((i % count) * size, ((i % count) + 1) * size));
  };
  return {
    keypoints2d: part(one.keypoints2d),
    keypoints3d: part(one.keypoints3d),
    scores: part(one.scores),
  };
}

function frames(from: number, to: number): Float64Array {
  const count = Math.round((to - from) * 30);
  return Float64Array.from({ length: count }, (_, i) => from + (i + 1) / 30);
}

/** Adds sample after sample, an interval apart; nobody is seen at the places of `unseen`. */
async function play(live: LiveRecoverer, count: number, unseen: number[] = [], ahead = NONE) {
  const chunks: (LiveChunk | null)[] = [];
  for (let i = 0; i < count; i++) {
    const time = i * INTERVAL;
    const step = await live.add({
      time,
      estimate: unseen.includes(i) ? null : estimate(i),
      frameTimes: frames(time - INTERVAL, time),
      ahead: ahead.map((later) => time + later),
    });
    chunks.push(step.chunk);
  }
  return chunks;
}

describe('LiveRecoverer', () => {
  test('gives the newest interval as the window of the samples so far has it', async () => {
    const chunks = await play(new LiveRecoverer(recoverer), 5);
    expect(chunks[0]).toBeNull();
    const last = chunks[4]!;
    expect(last.times[0]).toBeCloseTo(3 * INTERVAL);
    expect(last.times.at(-1)).toBeCloseTo(4 * INTERVAL);
    const whole = await recoverer.pair2d.run({
      samples: [0, 1, 2, 3, 4].map(estimate),
      sampleTimes: Float64Array.from([0, 1, 2, 3, 4], (i) => i * INTERVAL),
      frameTimes: last.times,
    });
    expect(last.values2d).toEqual(whole.poses);
    expect(last.scores.slice(-33)).toEqual(estimate(4).scores);
    // Relative to the mid-hip, exactly.
    const hips = [23, 24].map((k) => last.values3d[k * 3]!);
    expect(hips[0]! + hips[1]!).toBeCloseTo(0, 5);
  });

  test('bridges a sample in which nobody was seen, and begins anew after more', async () => {
    const bridged = await play(new LiveRecoverer(recoverer), 5, [2]);
    expect(bridged[2]).toBeNull();
    expect(bridged[3]!.times[0]).toBeCloseTo(INTERVAL);
    expect(bridged[3]!.times.at(-1)).toBeCloseTo(3 * INTERVAL);
    const apart = await play(new LiveRecoverer(recoverer), 8, [2, 3, 4]);
    expect(apart[5]).toBeNull();
    expect(apart[6]!.times[0]).toBeCloseTo(5 * INTERVAL);
  });

  test('looks ahead from the last sample, close to it at first', async () => {
    const ahead = Float64Array.of(0, 0.1, 0.3);
    const chunks = await play(new LiveRecoverer(recoverer), 6, [], ahead);
    const last = chunks[5]!;
    expect([...last.times]).toEqual([...ahead].map((later) => 5 * INTERVAL + later));
    const { keypoints3d } = estimate(5);
    const off = (t: number) =>
      keypoints3d.reduce((sum, value, i) => sum + Math.abs(value - last.values3d[t * 99 + i]!), 0) /
      99;
    expect(off(0)).toBeLessThan(0.15);
    expect([...last.values2d, ...last.values3d].every(Number.isFinite)).toBe(true);
    expect(last.scores.length).toBe(3 * 33);
  });

  test('keeps no more samples than a window has', async () => {
    const live = new LiveRecoverer(recoverer);
    await play(live, 30);
    const step = await live.add({
      time: 10,
      estimate: estimate(0),
      frameTimes: frames(29 * INTERVAL, 10),
      ahead: NONE,
    });
    expect(step.runs.map(({ samples }) => samples)).toEqual([11, 11]);
  });
});
