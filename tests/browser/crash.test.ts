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
