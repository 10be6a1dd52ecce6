import { describe, expect, test, vi } from 'vitest';
import { SharedLoad } from '../../web/engine/shared-load.ts';
import { untilAborted } from '../../web/engine/until-aborted.ts';

const NEVER = new AbortController().signal;

/** A load that ends when the test says so, or is given up. */
function controlled() {
  const runs: {
    end: (value: string) => void;
    fail: (error: Error) => void;
    signal: AbortSignal;
  }[] = [];
  const load = new SharedLoad(
    (signal) =>
      new Promise<string>((end, fail) => {
        runs.push({ end, fail, signal });
      }),
  );
  return { load, runs };
}

describe('SharedLoad', () => {
  test('loads once for all who want it, at a time or later', async () => {
    const { load, runs } = controlled();
    const both = Promise.all([load.get(NEVER), load.get(NEVER)]);
    runs[0]!.end('nets');
    expect(await both).toEqual(['nets', 'nets']);
    expect(await load.get(NEVER)).toBe('nets');
    expect(runs.length).toBe(1);
  });

  test('tries again after a failure', async () => {
    const { load, runs } = controlled();
    const first = load.get(NEVER);
    runs[0]!.fail(new Error('no answer'));
    await expect(first).rejects.toThrow('no answer');
    const second = load.get(NEVER);
    runs[1]!.end('nets');
    expect(await second).toBe('nets');
  });

  test('goes on for one when another one gives up, and is given up by the last', async () => {
    const { load, runs } = controlled();
    const [one, other] = [new AbortController(), new AbortController()];
    const jobs = [load.get(one.signal), load.get(other.signal)];
    one.abort(new Error('one'));
    await expect(jobs[0]).rejects.toThrow('one');
    expect(runs[0]!.signal.aborted).toBe(false);
    other.abort(new Error('other'));
    await expect(jobs[1]).rejects.toThrow('other');
    expect(runs[0]!.signal.aborted).toBe(true);
  });

  test('begins anew once the one that was given up has ended, or takes what it ended in', async () => {
    for (const late of [true, false]) {
      const { load, runs } = controlled();
      const abort = new AbortController();
      const job = load.get(abort.signal);
      abort.abort(new Error('given up'));
      await expect(job).rejects.toThrow('given up');
      const next = load.get(NEVER);
      await Promise.resolve();
      expect(runs.length).toBe(1);
      if (late) runs[0]!.end('too late to stop');
      else runs[0]!.fail(new Error('aborted'));
      await vi.waitUntil(() => late || runs.length === 2);
      runs[1]?.end('anew');
      expect(await next).toBe(late ? 'too late to stop' : 'anew');
    }
  });

  test('what was taken away is loaded anew', async () => {
    const { load, runs } = controlled();
    expect(load.take()).toBeUndefined();
    const first = load.get(NEVER);
    expect(load.take()).toBeUndefined();
    runs[0]!.end('lite');
    await first;
    expect(load.take()).toBe('lite');
    const second = load.get(NEVER);
    runs[1]!.end('lite again');
    expect(await second).toBe('lite again');
  });
});

describe('untilAborted', () => {
  test('ends with the job, or with the signal, and listens no longer than that', async () => {
    const { signal } = new AbortController();
    const added = vi.spyOn(signal, 'addEventListener');
    const removed = vi.spyOn(signal, 'removeEventListener');
    expect(await untilAborted(Promise.resolve(3), signal)).toBe(3);
    await expect(untilAborted(Promise.reject(new Error('no')), signal)).rejects.toThrow('no');
    await Promise.resolve();
    expect(removed.mock.calls).toEqual(added.mock.calls);
    const gone = AbortSignal.abort(new Error('gone'));
    await expect(untilAborted(new Promise(() => {}), gone)).rejects.toThrow('gone');
  });
});
