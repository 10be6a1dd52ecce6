import { afterEach, expect, test, vi } from 'vitest';
import { createEngine } from '../../web/engine/client.ts';
import { fixture } from './fixtures.ts';

const { startWorker } = vi.hoisted(() => ({ startWorker: vi.fn() }));
vi.mock('../../web/engine/start-worker.ts', () => ({ startWorker }));

const OPTIONS = { every: 10, estimator: 'lite' } as const;

function workerOf(code: string): Worker {
  const url = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  return new Worker(url, { type: 'module' });
}

/** A worker that answers calls of some methods with a crash, and others never. */
function crashing(...methods: string[]): Worker {
  return workerOf(`
    const methods = ${JSON.stringify(methods)};
    onmessage = ({ data: { id, path } }) => {
      if (!methods.includes(path.join())) return;
      postMessage({ id, type: 'RAW', value: { kind: 'crashed', message: 'out of memory' } });
    };`);
}

const LIVE = { ...OPTIONS, mode: 'smooth', load: 'adapt' } as const;

afterEach(() => startWorker.mockReset());

test('a worker that cannot be loaded ends the job with a sentence', async () => {
  startWorker.mockImplementation(() => new Worker('/nowhere/worker.js', { type: 'module' }));
  const engine = createEngine();
  const job = engine.recover(await fixture('gap.mp4'), 'gap.mp4', OPTIONS);
  await expect(job).rejects.toMatchObject({ name: 'DeciWatchError', code: 'engine-crashed' });
  await expect(job).rejects.toThrow(/reload the page/);
});

test('a worker that breaks ends its job, and the next job gets a new one', async () => {
  startWorker.mockImplementation(() => workerOf(`onmessage = () => { throw new Error('boom'); }`));
  const engine = createEngine();
  for (let job = 1; job <= 2; job++) {
    await expect(
      engine.recover(await fixture('gap.mp4'), 'gap.mp4', OPTIONS),
    ).rejects.toMatchObject({ code: 'engine-crashed', message: expect.stringContaining('boom') });
    expect(startWorker).toHaveBeenCalledTimes(job);
  }
});

test('where the page forbids workers, that is told', async () => {
  startWorker.mockImplementation(() => {
    throw new DOMException('refused by the policy', 'SecurityError');
  });
  const job = createEngine().recover(await fixture('gap.mp4'), 'gap.mp4', OPTIONS);
  await expect(job).rejects.toMatchObject({ code: 'engine-crashed' });
  await expect(job).rejects.toThrow(/refused by the policy/);
});

test('a worker that breaks under the camera ends its session, and the next one gets a new one', async () => {
  startWorker.mockImplementation(() => crashing('prepareLive'));
  const engine = createEngine();
  const told: string[] = [];
  await new Promise<void>((done) => {
    const follow = () => {
      engine.live(LIVE).onError = ({ code, message }) => {
        told.push(`${code}: ${message}`);
        // At once, as a page does that tries again by itself.
        if (told.length < 3) follow();
        else done();
      };
    };
    follow();
  });
  expect(told).toEqual(Array(3).fill(expect.stringMatching(/^engine-crashed: .*out of memory/)));
  expect(startWorker).toHaveBeenCalledTimes(3);
});

test('a worker that breaks under a clip takes the camera’s session with it, which is told', async () => {
  startWorker.mockImplementation(() => crashing('recover'));
  const engine = createEngine();
  const session = engine.live(LIVE);
  const told = new Promise((resolve) => {
    session.onError = ({ code }) => resolve(code);
  });
  const job = engine.recover(await fixture('gap.mp4'), 'gap.mp4', OPTIONS);
  await expect(job).rejects.toMatchObject({ code: 'engine-crashed' });
  expect(await told).toBe('engine-crashed');
});
