import { describe, expect, test } from 'vitest';
import { PoseTeller } from '../../web/player/pose-teller.ts';
import { shapeOf } from '../../web/player/shape.ts';

describe('which frames are told of', () => {
  test('every one, also those that the screen left out, in a loop too', () => {
    const teller = new PoseTeller();
    expect(teller.shown(0, 5)).toEqual([0]);
    expect(teller.shown(1, 5)).toEqual([1]);
    expect(teller.shown(1, 5)).toEqual([]);
    expect(teller.shown(3, 5)).toEqual([2, 3]);
    expect(teller.shown(1, 5)).toEqual([4, 0, 1]);
  });

  test('the last ones when playback ends before they were shown, and all again when it begins anew', () => {
    const teller = new PoseTeller();
    teller.shown(0, 5);
    teller.shown(2, 5);
    expect(teller.ended(5)).toEqual([3, 4]);
    expect(teller.ended(5)).toEqual([]);
    expect(teller.shown(0, 5)).toEqual([0]);
  });

  test('after a jump the one jumped to alone, and none of the old place twice', () => {
    const teller = new PoseTeller();
    teller.shown(0, 100);
    teller.jump();
    // The old place still plays.
    expect(teller.shown(1, 100, false)).toEqual([1]);
    expect(teller.shown(60, 100)).toEqual([60]);
    expect(teller.shown(62, 100)).toEqual([61, 62]);
    teller.jump();
    expect(teller.shown(10, 100)).toEqual([10]);
  });

  test('of another clip, the same frame again', () => {
    const teller = new PoseTeller();
    teller.shown(0, 5);
    teller.reset();
    expect(teller.shown(0, 5)).toEqual([0]);
  });
});

test('the panes are shaped so that a picture fills its own', () => {
  expect(shapeOf('overlay', 16 / 9)).toBe('--shape: 1.7778');
  // Side by side at one height: widths add up. One above the other at one width: heights do.
  const both = shapeOf('both', 2);
  expect(both).toContain('--shape: 3;');
  expect(both).toContain('--columns: minmax(0, 2fr) minmax(0, 1fr)');
  expect(both).toContain(`--tall-shape: ${Number((1 / (1 / 2 + 1 / 1.25)).toFixed(4))}`);
});
