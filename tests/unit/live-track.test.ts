import { describe, expect, test } from 'vitest';
import { SmoothDelay } from '../../web/engine/live/delay.ts';
import { FADE_SECONDS, HOLD_SECONDS, LiveTrack } from '../../web/engine/live/track.ts';
import { EASE_SECONDS, easedShare } from '../../web/pose/easing.ts';
import type { LiveChunk } from '../../web/recovery/live-recoverer.ts';
import easing from '../fixtures/easing.json';

/** Thirty poses a second of one joint whose x is a function of time. */
function stretch(from: number, to: number, x: (time: number) => number): LiveChunk {
  const count = Math.round((to - from) * 30) + 1;
  const times = Float64Array.from({ length: count }, (_, i) => from + i / 30);
  return {
    times,
    values2d: Float32Array.from([...times].flatMap((time) => [100 * x(time), 50])),
    values3d: Float32Array.from([...times].flatMap((time) => [x(time), 1, -1])),
    scores: new Float32Array(count).fill(0.9),
  };
}

const xAt = (track: LiveTrack, time: number) => track.at(time)!.values3d[0]!;

describe('easing', () => {
  test('is what Python measures the live modes with', () => {
    expect(EASE_SECONDS).toBe(easing.seconds);
    easing.ages.forEach((age, i) => {
      expect(easedShare(age)).toBeCloseTo(easing.shares[i]!, 5);
    });
  });
});

describe('LiveTrack', () => {
  test('is empty at first', () => {
    expect(new LiveTrack().at(1)).toBeNull();
  });

  test('joins its poses by straight lines', () => {
    const track = new LiveTrack();
    track.append(
      stretch(0, 1, (time) => 2 * time),
      0,
    );
    expect(xAt(track, 0.51)).toBeCloseTo(1.02);
    expect(track.at(0.51)!.values2d[0]).toBeCloseTo(102);
  });

  test('passes over to what is known better without a jump, and then shows just that', () => {
    const track = new LiveTrack();
    track.append(
      stretch(0, 2, () => 0),
      0,
    );
    const before = xAt(track, 1);
    track.append(
      stretch(0.9, 2, () => 1),
      1,
    );
    expect(xAt(track, 1)).toBeCloseTo(before, 5);
    let last = before;
    for (let time = 1; time < 1.5; time += 1 / 60) {
      expect(Math.abs(xAt(track, time) - last)).toBeLessThan(0.45);
      last = xAt(track, time);
    }
    expect(xAt(track, 1 + 8 * EASE_SECONDS)).toBeCloseTo(1, 2);
  });

  test('eases again from wherever an unfinished passage had come to', () => {
    const track = new LiveTrack();
    track.append(
      stretch(0, 2, () => 0),
      0,
    );
    track.append(
      stretch(0.5, 2, () => 1),
      1,
    );
    const middle = 1 + EASE_SECONDS;
    const before = xAt(track, middle);
    track.append(
      stretch(0.6, 2, () => -1),
      middle,
    );
    expect(xAt(track, middle)).toBeCloseTo(before, 5);
  });

  test('lets somebody who is not seen any more stay and fade, never frozen', () => {
    const track = new LiveTrack();
    track.append(
      stretch(0, 1, (time) => time),
      0,
    );
    expect(track.at(0.9)!.presence).toBe(1);
    expect(track.at(1 + HOLD_SECONDS)!.presence).toBeCloseTo(1);
    const fading = track.at(1 + HOLD_SECONDS + FADE_SECONDS / 2)!;
    expect(fading.presence).toBeCloseTo(0.5);
    expect(fading.values3d[0]).toBeCloseTo(1);
    expect(track.at(1 + HOLD_SECONDS + FADE_SECONDS + 0.01)).toBeNull();
  });

  test('shows somebody who comes back where they are, fading in, without a flight there', () => {
    const track = new LiveTrack();
    track.append(
      stretch(0, 1, () => 0),
      0,
    );
    track.append(
      stretch(3, 4, () => 9),
      2.9,
    );
    for (let time = 0.5; time < 4; time += 1 / 60) {
      const pose = track.at(time);
      // Never between the two places, never at an origin, never nothing but a number.
      if (pose && pose.presence > 0)
        expect([0, 9]).toContain(Math.round(pose.values3d[0]! * 1e4) / 1e4);
      if (pose) expect(pose.values3d[1]).toBeCloseTo(1);
    }
    expect(track.at(2.5)).toBeNull();
    expect(track.at(3 + FADE_SECONDS / 2)!.presence).toBeCloseTo(0.5, 1);
    expect(track.at(3.9)!.presence).toBe(1);
  });

  test('keeps no more than it needs', () => {
    const track = new LiveTrack();
    for (let s = 0; s < 600; s++)
      track.append(
        stretch(s / 3, (s + 1) / 3, () => 0),
        s / 3,
      );
    expect(track.size).toBeLessThan(100);
  });
});

describe('SmoothDelay', () => {
  test('starts with what is expected, and follows what comes without a jump', () => {
    const delay = new SmoothDelay();
    let shown = 0 - delay.at(0, 0.4);
    for (let frame = 1; frame < 600; frame++) {
      const now = frame / 60;
      // From the third second on, answers take a fifth of a second longer.
      if (frame % 20 === 0) delay.arrived(now - (now > 3 ? 0.6 : 0.4), now);
      const next = now - delay.at(now, 0.4);
      expect(next - shown).toBeGreaterThan(0.7 / 60);
      expect(next - shown).toBeLessThan(1.15 / 60);
      shown = next;
    }
    expect(599 / 60 - shown).toBeCloseTo(0.605, 2);
  });

  test('is not put off by one answer that was late', () => {
    const delay = new SmoothDelay();
    for (let i = 0; i < 8; i++) delay.arrived(i - 0.4, i);
    delay.arrived(8 - 1.2, 8);
    delay.at(8, 0.4);
    expect(delay.at(20, 0.4)).toBeCloseTo(0.405, 2);
  });
});
