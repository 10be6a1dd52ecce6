import { describe, expect, test } from 'vitest';
import { shortcutFor } from '../../web/app/shortcuts.ts';
import { containedRect } from '../../web/player/parts/letterbox.ts';
import { frameX, labelStep } from '../../web/player/parts/timeline-painter.ts';

describe('containedRect', () => {
  test('a wide picture leaves bands above and below', () => {
    expect(containedRect({ width: 400, height: 300 }, { width: 1920, height: 1080 })).toEqual({
      x: 0,
      y: 37.5,
      width: 400,
      height: 225,
    });
  });

  test('a tall picture leaves bands at the sides', () => {
    expect(containedRect({ width: 400, height: 300 }, { width: 1080, height: 1920 })).toEqual({
      x: 115.625,
      y: 0,
      width: 168.75,
      height: 300,
    });
  });
});

describe('timeline', () => {
  test('the first and last frame lie under the ends of the slider thumb’s way', () => {
    const size = { width: 216, height: 50, inset: 8 };
    expect(frameX(0, 101, size)).toBe(8);
    expect(frameX(50, 101, size)).toBe(108);
    expect(frameX(100, 101, size)).toBe(208);
    expect(frameX(0, 1, size)).toBe(8);
  });

  test('labels keep their distance', () => {
    expect(labelStep(4.2, 1300)).toBe(0.5);
    expect(labelStep(4.2, 200)).toBe(2);
    expect(labelStep(600, 1300)).toBe(30);
  });
});

describe('shortcuts', () => {
  const press = (key: string) => ({ key, ctrlKey: false, metaKey: false, altKey: false });

  test('keys work from anywhere that has no use for them itself', () => {
    expect(shortcutFor(press(' '), 'other')).toBe('toggle');
    expect(shortcutFor(press('K'), 'press')).toBe('toggle');
    expect(shortcutFor(press(','), 'slider')).toBe('back');
  });

  test('a focused control keeps its own keys, and the browser its combinations', () => {
    expect(shortcutFor(press(' '), 'press')).toBeNull();
    expect(shortcutFor(press('Home'), 'slider')).toBeNull();
    expect(shortcutFor(press('k'), 'text')).toBeNull();
    expect(shortcutFor({ ...press('s'), ctrlKey: true }, 'other')).toBeNull();
  });
});
