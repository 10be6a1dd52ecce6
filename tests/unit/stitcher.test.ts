import { describe, expect, it } from 'vitest';
import { splitSegments } from '../../web/sampling/segments.ts';
import { Stitcher } from '../../web/sampling/stitcher.ts';
import { watchedFrames } from '../../web/sampling/watched.ts';
import { cutWindows } from '../../web/sampling/windows.ts';
import { readFixture } from './fixture.ts';
import { seededRandom } from './random.ts';

const SIZE = 3;

function timesOf(frameCount: number): Float64Array {
  return Float64Array.from({ length: frameCount }, (_, i) => i / 30);
}

it('gives back exactly the poses on which all windows agree, at any length and N', () => {
  const random = seededRandom(1);
  for (let frameCount = 1; frameCount <= 300; frameCount += 7) {
    const poses = Float32Array.from({ length: frameCount * SIZE }, () => random() * 1000 - 500);
    for (let every = 1; every <= 20; every++) {
      const stitcher = new Stitcher(frameCount, SIZE);
      for (const window of cutWindows(
        watchedFrames(frameCount, every),
        timesOf(frameCount),
        every,
      )) {
        const { firstFrame, lastFrame } = window;
        stitcher.add(window, poses.subarray(firstFrame * SIZE, (lastFrame + 1) * SIZE));
      }
      const isSame = stitcher.finish().every((value, i) => value === poses[i]);
      expect(isSame, `T = ${frameCount}, N = ${every}`).toBe(true);
    }
  }
});

it('passes from one window to the next without a jump, even where they disagree', () => {
  const windows = cutWindows(watchedFrames(231, 10), timesOf(231), 10);
  const stitcher = new Stitcher(231, 1);
  windows.forEach((window, i) => {
    const frames = window.lastFrame - window.firstFrame + 1;
    stitcher.add(window, new Float32Array(frames).fill(i % 2));
  });
  const stitched = stitcher.finish();
  // Windows that disagree by 1 share at least 50 frames, so that steps stay near 1/25.
  for (let t = 1; t < stitched.length; t++) {
    expect(Math.abs(stitched[t]! - stitched[t - 1]!), `at frame ${t}`).toBeLessThan(0.045);
  }
  expect(stitched[0]).toBe(0);
  expect(stitched[230]).toBe(1);
});

it('leaves NaN in frames that no window covers', () => {
  const stitcher = new Stitcher(4, 2);
  stitcher.add({ samples: [0], firstFrame: 1, lastFrame: 1 }, Float32Array.of(5, 6));
  expect([...stitcher.finish()]).toEqual([NaN, NaN, 5, 6, NaN, NaN, NaN, NaN]);
});

it('refuses poses that do not fit their window', () => {
  const stitcher = new Stitcher(4, 2);
  const window = { samples: [0, 1], firstFrame: 1, lastFrame: 3 };
  expect(() => stitcher.add(window, new Float32Array(5))).toThrow(RangeError);
  expect(() => stitcher.add({ ...window, lastFrame: 4 }, new Float32Array(8))).toThrow(RangeError);
});

/** A clip as `export/deciwatch/sampling/` cuts and stitches it. */
interface Case {
  readonly every: number;
  readonly times: number[];
  readonly watched: number[];
  readonly seen: number[];
  readonly segments: [start: number, end: number][];
  /** First sample, samples, first frame, last frame. */
  readonly windows: [number, number, number, number][];
  /** T·2 values; null in frames that no window covers. */
  readonly stitched: (number | null)[];
}

describe('as in Python, with which the nets are evaluated', () => {
  const { cases } = readFixture<{ cases: Case[] }>('stitching.json');

  it.each(cases)('$watched.length samples, N = $every', (expected) => {
    const { every, seen } = expected;
    const times = Float64Array.from(expected.times);
    expect([...watchedFrames(times.length, every)]).toEqual(expected.watched);
    expect(splitSegments(seen, times, every)).toEqual(expected.segments);
    const windows = cutWindows(seen, times, every);
    expect(windows.map((w) => [w.samples[0], w.samples.length, w.firstFrame, w.lastFrame])).toEqual(
      expected.windows,
    );

    const stitcher = new Stitcher(times.length, 2);
    windows.forEach((window, w) => {
      const frames = window.lastFrame - window.firstFrame + 1;
      const poses = Array.from({ length: frames }, (_, t) => [w, window.firstFrame + t + w / 2]);
      stitcher.add(window, Float32Array.from(poses.flat()));
    });
    stitcher.finish().forEach((value, i) => {
      const wanted = expected.stitched[i];
      if (wanted === null) expect(value).toBeNaN();
      else expect(value, `value ${i}`).toBeCloseTo(wanted!, 3);
    });
  });
});
