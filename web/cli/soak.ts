/**
 * Whether live playback's memory stays as it is.
 *
 *     npm run soak -- [--minutes 30] [--mode smooth|now] [--every 10] [--estimator full] [--json FILE]
 *
 * The demo page with the browser's fake camera; memory is measured every half minute after a forced
 * garbage collection, and compared with that after minute 2 (or a quarter of a shorter run). Fails
 * where it grows by more than 5 %, or a video frame is left open.
 */
import { parseArgs } from 'node:util';
import { LivePage } from './live-page.ts';
import { type Memory, MemoryProbe } from './memory.ts';
import { parseEstimator, parseEvery, UsageError } from './options.ts';
import { writeWhole } from './outputs.ts';

const MOST_GROWTH = 0.05;
const STEP_MIN = 0.5;

/** Frames that are on their way from the camera to the estimator when memory is measured. */
const FRAMES_IN_FLIGHT = 1;

async function main(): Promise<void> {
  const { values } = parseArgs({
    options: {
      minutes: { type: 'string', default: '30' },
      mode: { type: 'string', default: 'smooth' },
      every: { type: 'string', default: '10' },
      estimator: { type: 'string', default: 'full' },
      json: { type: 'string' },
    },
  });
  const minutes = Number(values.minutes);
  if (!(minutes >= 1)) {
    throw new UsageError(`--minutes wants a number of 1 or more, not "${values.minutes}".`);
  }
  const { mode } = values;
  if (mode !== 'smooth' && mode !== 'now') {
    throw new UsageError(`--mode wants smooth or now, not "${mode}".`);
  }
  const live = await LivePage.start();
  try {
    await live.follow({
      every: parseEvery(values.every),
      estimator: parseEstimator(values.estimator),
      mode,
      load: 'adapt',
    });
    const probe = await MemoryProbe.attach(live.page);
    const begin = Math.min(2, minutes / 4);
    const start = performance.now();
    const passed = () => (performance.now() - start) / 60_000;
    await live.wait(60 * begin);
    const before = await probe.measure();
    process.stdout.write(`${line(passed(), before)}\n`);
    let after = before;
    while (passed() < minutes) {
      await live.wait(60 * Math.max(0.01, Math.min(STEP_MIN, minutes - passed())));
      after = await probe.measure();
      process.stdout.write(`${line(passed(), after)}\n`);
    }
    const { totals } = await live.snapshot();
    const growth = { heap: after.heap / before.heap - 1, wasm: after.wasm / before.wasm - 1 };
    process.stdout.write(
      `from minute ${begin} to ${minutes}: JS heap ${percent(growth.heap)}, WASM ${percent(growth.wasm)}, ` +
        `${after.openFrames} open frames; ${totals.frames} camera frames, ${totals.calls} looks\n`,
    );
    if (values.json) {
      await writeWhole(
        values.json,
        `${JSON.stringify({ minutes, mode, before, after, growth, totals }, null, 2)}\n`,
      );
    }
    const grown = growth.heap > MOST_GROWTH || growth.wasm > MOST_GROWTH;
    if (grown || after.openFrames > FRAMES_IN_FLIGHT) process.exitCode = 1;
  } finally {
    await live.close();
  }
}

function line(minute: number, { heap, wasm, openFrames, workers }: Memory): string {
  const mb = (bytes: number) => (bytes / 1e6).toFixed(2);
  return (
    `minute ${minute.toFixed(1).padStart(4)}: JS heap ${mb(heap)} MB, WASM ${mb(wasm)} MB, ` +
    `${openFrames} open frames, ${workers} worker`
  );
}

function percent(share: number): string {
  return `${share >= 0 ? '+' : ''}${(100 * share).toFixed(1)} %`;
}

main().catch((error: unknown) => {
  process.stderr.write(`${error instanceof Error ? error.message : error}\n`);
  process.exitCode = error instanceof UsageError ? 2 : 1;
});
