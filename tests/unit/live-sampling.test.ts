import { describe, expect, test } from 'vitest';
import { FramePeriod } from '../../web/sampling/frame-period.ts';
import { LiveSampler } from '../../web/sampling/live-sampler.ts';

const PERIOD = 1 / 30;

/** Plays frames to a sampler whose estimator takes `call` seconds; gives the frames that it watched. */
function play(
  sampler: LiveSampler,
  frames: number,
  call: number,
  from = 0,
  missing: number[] = [],
) {
  const watched: number[] = [];
  let doneAt = -1;
  for (let index = from; index < from + frames; index++) {
    const now = index * PERIOD;
    if (doneAt >= 0 && now >= doneAt) {
      sampler.answered(call, PERIOD);
      doneAt = -1;
    }
    if (missing.includes(index)) continue;
    if (!sampler.offer(index, doneAt >= 0, PERIOD)) continue;
    watched.push(index);
    doneAt = now + call;
  }
  return watched;
}

describe('LiveSampler', () => {
  test('watches one frame in N, the first one first', () => {
    expect(play(new LiveSampler(10, 'adapt'), 45, 0.1)).toEqual([0, 10, 20, 30, 40]);
  });

  test('takes the next frame for one that never came, and keeps to its multiples', () => {
    expect(play(new LiveSampler(10, 'adapt'), 45, 0.1, 0, [10, 11])).toEqual([0, 12, 20, 30, 40]);
  });

  test('skips samples that come while the estimator is busy, and queues none', () => {
    // 0.5 s is 15 frames: every second sample finds it busy.
    expect(play(new LiveSampler(10, 'skip'), 61, 0.5)).toEqual([0, 20, 40, 60]);
  });

  test('grows N where the estimator is too slow, to where it keeps up', () => {
    const sampler = new LiveSampler(2, 'adapt');
    play(sampler, 120, 0.25);
    // A call takes 7.5 frames, and is to take four fifths of the interval.
    expect(sampler.every).toBe(10);
    expect(sampler.chosen).toBe(2);
    const watched = play(sampler, 60, 0.25, 120);
    expect(watched.slice(1).map((frame, i) => frame - watched[i]!)).toEqual(
      watched.slice(1).map(() => 10),
    );
  });

  test('goes back to the chosen N by steps once the estimator is quick again, and not to and fro', () => {
    const sampler = new LiveSampler(2, 'adapt');
    play(sampler, 120, 0.25);
    play(sampler, 900, 0.02, 120);
    expect(sampler.every).toBe(2);
    const steady = new LiveSampler(2, 'adapt');
    play(steady, 300, 0.25);
    const seen = new Set<number>();
    for (let from = 300; from < 900; from += 30) {
      play(steady, 30, 0.25, from);
      seen.add(steady.every);
    }
    expect([...seen]).toEqual([10]);
  });

  test('refuses an N that the nets do not know', () => {
    expect(() => new LiveSampler(0, 'adapt')).toThrow(/from 1 to 20/);
    expect(() => new LiveSampler(10, 'adapt').choose(21, 'skip')).toThrow(/from 1 to 20/);
  });
});

describe('FramePeriod', () => {
  test('is a thirtieth of a second until more is known', () => {
    expect(new FramePeriod().seconds).toBeCloseTo(1 / 30);
  });

  test.each([10, 24, 30, 60])('finds %i frames a second, with late and missing ones', (rate) => {
    const period = new FramePeriod();
    let time = 5;
    for (let i = 0; i < 60; i++) {
      const missed = i % 13 === 5 ? 1 : 0;
      time += (1 + missed) / rate;
      period.add(time + (i % 7 === 3 ? 0.3 / rate : 0), 1 + missed);
    }
    expect(period.seconds).toBeCloseTo(1 / rate, 3);
  });

  test('follows a change of rate, and takes a hidden tab for no frame', () => {
    const period = new FramePeriod();
    let time = 0;
    const frames = (count: number, gap: number) => {
      for (let i = 0; i < count; i++) {
        time += gap;
        period.add(time);
      }
    };
    frames(40, 1 / 30);
    frames(1, 60);
    expect(period.seconds).toBeCloseTo(1 / 30);
    frames(40, 1 / 15);
    expect(period.seconds).toBeCloseTo(1 / 15);
  });
});
