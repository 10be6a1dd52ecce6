import { describe, expect, it } from 'vitest';
import { watchedFrames } from '../../web/sampling/watched.ts';
import { cutWindows, type SampleWindow } from '../../web/sampling/windows.ts';
import { seededRandom } from './random.ts';

/** Times of T frames at 30 frames a second. */
function timesOf(frameCount: number): Float64Array {
  return Float64Array.from({ length: frameCount }, (_, i) => i / 30);
}

/** The samples that are left when those at some positions are missing. */
function without(watched: Int32Array, ...missing: number[]): Int32Array {
  return watched.filter((_, i) => !missing.includes(i));
}

function spans(windows: readonly SampleWindow[]): [number, number][] {
  return windows.map(({ firstFrame, lastFrame }) => [firstFrame, lastFrame]);
}

describe('with somebody always in view', () => {
  it('covers every frame of every clip at every N with full overlapping windows', () => {
    for (let frameCount = 1; frameCount <= 300; frameCount++) {
      const times = timesOf(frameCount);
      for (let every = 1; every <= 20; every++) {
        const watched = watchedFrames(frameCount, every);
        const windows = cutWindows(watched, times, every);
        const full = Math.min(11, watched.length);
        const problems = windows.filter(({ samples, firstFrame, lastFrame }, i) => {
          const next = windows[i + 1];
          const isConsecutive = samples.every((sample, j) => sample === samples[0]! + j);
          const fits =
            watched[samples[0]!] === firstFrame && watched[samples.at(-1)!] === lastFrame;
          const stride = next ? next.samples[0]! - samples[0]! : 1;
          return samples.length !== full || !isConsecutive || !fits || stride < 1 || stride > 5;
        });
        expect(problems, `T = ${frameCount}, N = ${every}`).toEqual([]);
        expect(windows[0]!.firstFrame).toBe(0);
        expect(windows.at(-1)!.lastFrame).toBe(frameCount - 1);
      }
    }
  });

  it('moves by half a window, and the last window back', () => {
    const windows = cutWindows(watchedFrames(231, 10), timesOf(231), 10);
    expect(windows.map(({ samples }) => samples[0])).toEqual([0, 5, 10, 13]);
    expect(spans(windows)).toEqual([
      [0, 100],
      [50, 150],
      [100, 200],
      [130, 230],
    ]);
  });
});

describe('with somebody out of view', () => {
  const watched = watchedFrames(301, 10);
  const times = timesOf(301);

  it('bridges two missing samples and splits at three', () => {
    const bridged = without(watched, 4, 5, ...Array.from({ length: 20 }, (_, i) => i + 11));
    expect(spans(cutWindows(bridged, times, 10))).toEqual([[0, 100]]);
    const split = without(watched, 4, 5, 6, ...Array.from({ length: 20 }, (_, i) => i + 11));
    expect(spans(cutWindows(split, times, 10))).toEqual([
      [0, 30],
      [70, 100],
    ]);
  });

  it('bridges no gap longer than a second and a half where intervals are long', () => {
    expect(spans(cutWindows([0, 20, 60], times, 20))).toEqual([[0, 60]]);
    expect(spans(cutWindows([0, 20, 80], times, 20))).toEqual([
      [0, 20],
      [80, 80],
    ]);
  });

  it('goes by seconds where intervals are short', () => {
    // 21 frames are 0.7 s: with N = 1 that bridges 20 missing samples.
    expect(spans(cutWindows([0, 1, 22], times, 1))).toEqual([[0, 22]]);
    expect(spans(cutWindows([0, 1, 23], times, 1))).toEqual([
      [0, 1],
      [23, 23],
    ]);
    const slow = times.map((time) => time * 10);
    expect(spans(cutWindows([0, 1, 5], slow, 1))).toEqual([
      [0, 1],
      [5, 5],
    ]);
  });

  it('counts a short last interval as one', () => {
    const odd = watchedFrames(302, 10);
    expect(odd.at(-1)).toBe(301);
    expect(spans(cutWindows([270, 301], timesOf(302), 10))).toEqual([
      [270, 270],
      [301, 301],
    ]);
    expect(spans(cutWindows([280, 301], timesOf(302), 10))).toEqual([[280, 301]]);
  });

  it('leaves frames before the first and after the last sample alone', () => {
    expect(cutWindows([], times, 10)).toEqual([]);
    const [window, ...others] = cutWindows([120], times, 10);
    expect(window).toEqual({ samples: [0], firstFrame: 120, lastFrame: 120 });
    expect(others).toEqual([]);
  });

  it('never bridges a long gap, and uses each seen sample, whatever is missing', () => {
    const random = seededRandom(7);
    for (let round = 0; round < 300; round++) {
      const every = 1 + Math.floor(random() * 20);
      const seen = watchedFrames(301, every).filter(() => random() < 0.5);
      const windows = cutWindows(seen, times, every);
      const used = new Set(windows.flatMap(({ samples }) => samples));
      expect(used.size).toBe(seen.length);
      for (const { samples } of windows) {
        for (const i of samples.slice(1)) {
          const gap = seen[i]! - seen[i - 1]!;
          const bridgeable = gap <= every || gap <= 21 || (gap <= 3 * every && gap <= 45);
          expect(bridgeable, `${gap} frames at N = ${every}`).toBe(true);
        }
      }
    }
  });
});
