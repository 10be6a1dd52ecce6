import { describe, expect, test, vi } from 'vitest';
import { CameraClock } from '../../web/engine/live/camera-clock.ts';
import { LiveStateWatch } from '../../web/engine/live/state.ts';
import { WorkerLife } from '../../web/engine/worker-life.ts';

describe('WorkerLife', () => {
  test('gives the answers of a worker that lives', async () => {
    const life = new WorkerLife();
    await expect(life.whileAlive(Promise.resolve(3))).resolves.toBe(3);
    await expect(life.whileAlive(Promise.reject(new Error('no')))).rejects.toThrow('no');
  });

  test('ends every wait when it dies, and those that come after', async () => {
    const life = new WorkerLife();
    const waiting = life.whileAlive(new Promise(() => {}));
    const told: string[] = [];
    life.onDeath((error) => told.push(error.message));
    life.onDeath(() => told.push('taken back'))();
    life.end(new Error('gone'));
    life.end(new Error('again'));
    await expect(waiting).rejects.toThrow('gone');
    await expect(life.whileAlive(Promise.resolve(1))).rejects.toThrow('gone');
    life.onDeath((error) => told.push(`late: ${error.message}`));
    expect(told).toEqual(['gone', 'late: gone']);
  });
});

test('a worker’s death is told to all, whatever one of them throws', async () => {
  const report = vi.fn();
  vi.stubGlobal('reportError', report);
  const life = new WorkerLife();
  life.onDeath(() => {
    throw new Error('a listener of the page’s');
  });
  const waiting = life.whileAlive(new Promise(() => {}));
  life.end(new Error('gone'));
  await expect(waiting).rejects.toThrow('gone');
  expect(report).toHaveBeenCalledOnce();
  vi.unstubAllGlobals();
});

describe('LiveStateWatch', () => {
  test('says what is going on', () => {
    const watch = new LiveStateWatch();
    expect(watch.at(0)).toBe('waiting');
    watch.frame(0);
    expect(watch.at(0.1)).toBe('looking');
    watch.answered(0.1, true);
    expect(watch.at(0.2)).toBe('following');
    watch.frame(0.5);
    watch.answered(0.5, false);
    expect(watch.at(0.6)).toBe('lost');
    watch.frame(4);
    expect(watch.at(4)).toBe('looking');
    expect(watch.at(5.5)).toBe('waiting');
  });
});

describe('CameraClock', () => {
  test('counts the frames that were missed, and passes over what is no later', () => {
    const clock = new CameraClock();
    expect(clock.rate).toBe(0);
    expect(clock.add({ time: 10, told: 10.02, missed: 3 })).toBe(Number.POSITIVE_INFINITY);
    expect(clock.index).toBe(0);
    expect(clock.add({ time: 10, told: 10.05, missed: 0 })).toBeNull();
    expect(clock.add({ time: 10.1, told: 10.12, missed: 2 })).toBeCloseTo(0.1);
    expect(clock.index).toBe(3);
    expect(clock.rate).toBeCloseTo(30);
    expect(clock.frameAt(10.05)).toBe(10);
    expect(clock.frameAt(9)).toBeNull();
    expect([...clock.takeFrames()]).toEqual([10, 10.1]);
    expect([...clock.takeFrames()]).toEqual([]);
    clock.restart();
    clock.add({ time: 10.2, told: 10.22, missed: 5 });
    expect(clock.index).toBe(0);
  });
});
