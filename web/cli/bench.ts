/**
 * What a clip costs at N = 1 and N = 10, by stage, on this machine.
 *
 *     npm run bench [-- CLIP] [--estimator lite,full,heavy] [--every 1,10] [--json FILE]
 *
 * `npm run bench -- live` measures the camera instead: see bench-live.ts.
 *
 * For each estimator the clip is processed at every N in one browser, after one uncounted run that
 * loads and warms the models. Times of one run are comparable with one another; those of two
 * machines, or of one machine on two days, are not.
 */
import { parseArgs } from 'node:util';
import { ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';
import { parsePoseFile } from '../formats/pose-file.ts';
import { benchLive } from './bench-live.ts';
import { type BenchRow, formatTable } from './bench-table.ts';
import { chromiumCpuSeconds } from './cpu-time.ts';
import { HeadlessEngine } from './headless-engine.ts';
import { parseEstimator, parseEvery, UsageError } from './options.ts';
import { writeWhole } from './outputs.ts';

const SAMPLE = 'public/samples/walk.mp4';
const WARM_UP_EVERY = 20;

async function measure(
  engine: HeadlessEngine,
  clip: string,
  estimator: EstimatorName,
  every: number,
): Promise<BenchRow> {
  const cpuBefore = await chromiumCpuSeconds(engine.browser);
  const text = await engine.recover(clip, { every, estimator });
  const cpuSeconds = (await chromiumCpuSeconds(engine.browser)) - cpuBefore;
  const { cost } = parsePoseFile(JSON.parse(text));
  const { decode, estimator: estimate, denoise, recover } = cost.msPerFrame;
  return {
    name: `file ${estimator} N=${every}`,
    estimator,
    every,
    frames: cost.frames,
    estimatorCalls: cost.estimatorCalls,
    flopsPerFrame: cost.flopsPerFrame.total,
    wallMsPerFrame: cost.wallMs / cost.frames,
    cpuMsPerFrame: (cpuSeconds * 1000) / cost.frames,
    stages: { decode, estimator: estimate, denoise, recover },
  };
}

async function main(): Promise<void> {
  const args = process.argv.slice(2);
  if (args[0] === 'live') return benchLive(args.slice(1));
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      estimator: { type: 'string', default: ESTIMATOR_NAMES.join(',') },
      every: { type: 'string', default: '1,10' },
      json: { type: 'string' },
    },
  });
  const clip = positionals[0] ?? SAMPLE;
  const estimators = values.estimator.split(',').map(parseEstimator);
  const intervals = values.every.split(',').map(parseEvery);
  const rows: BenchRow[] = [];
  const engine = await HeadlessEngine.start();
  try {
    for (const estimator of estimators) {
      await engine.recover(clip, { every: WARM_UP_EVERY, estimator });
      for (const every of intervals) {
        rows.push(await measure(engine, clip, estimator, every));
        process.stderr.write(`measured ${rows.at(-1)?.name}\n`);
      }
    }
  } finally {
    await engine.close();
  }
  process.stdout.write(formatTable(rows));
  if (values.json) await writeWhole(values.json, `${JSON.stringify({ rows }, null, 2)}\n`);
}

main().catch((error: unknown) => {
  process.stderr.write(`${error instanceof Error ? error.message : error}\n`);
  process.exitCode = error instanceof UsageError ? 2 : 1;
});
