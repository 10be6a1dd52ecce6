import { describe, expect, test } from 'vitest';
import { FrameClock } from '../../web/player/parts/frame-clock.ts';

/** A phone's clip: uneven frames that do not begin at 0. */
const times = Float64Array.of(0.1, 0.133, 0.2, 0.233);

describe('FrameClock', () => {
  test('seeking leads to the middle of the frame, and back to the same frame', () => {
    const clock = new FrameClock(times);
    expect(clock.seekTarget(1)).toBeCloseTo(0.1665, 6);
    for (let frame = 0; frame < times.length; frame++) {
      expect(clock.frameAt(clock.seekTarget(frame))).toBe(frame);
    }
  });

  test('a media time rounded down to just before its frame still means that frame', () => {
    expect(new FrameClock(times).frameAt(0.1999999)).toBe(2);
  });

  test('an element that counts from its first frame is followed by the offset', () => {
    const clock = new FrameClock(times, 0);
    expect(clock.frameAt(0)).toBe(0);
    expect(clock.frameAt(0.1)).toBe(2);
    expect(clock.seekTarget(1)).toBeCloseTo(0.0665, 6);
  });

  test('out of range means the nearest frame, and one frame alone can be sought', () => {
    expect(new FrameClock(times).seekTarget(99)).toBeCloseTo(0.2495, 6);
    expect(new FrameClock(times).seekTarget(-5)).toBeCloseTo(0.1165, 6);
    expect(new FrameClock(Float64Array.of(0)).seekTarget(0)).toBe(0);
  });
});
