/**
 * Headless playback: a pose file for every clip, by the page's own engine.
 *
 *     npm run recover -- CLIP… [--every N] [--estimator lite|full|heavy] [--out FILE|DIR]
 *
 * Ends with 0 when every clip was recovered, 1 when some could not be, 2 when the command line
 * cannot be followed.
 */
import { access, constants } from 'node:fs/promises';
import { basename, relative } from 'node:path';
import { parseArgs } from 'node:util';
import { DEFAULT_ESTIMATOR, type EstimatorName } from '../estimators/names.ts';
import { parsePoseFile } from '../formats/pose-file.ts';
import { DEFAULT_INTERVAL, MAX_INTERVAL, MIN_INTERVAL } from '../sampling/watched.ts';
import { HeadlessEngine } from './headless-engine.ts';
import { parseEstimator, parseEvery, UsageError } from './options.ts';
import { outputPaths, writeWhole } from './outputs.ts';
import { ProgressLine } from './progress-line.ts';

const USAGE = `usage: npm run recover -- CLIP… [--every N] [--estimator lite|full|heavy] [--out FILE|DIR]

  --every N       the estimator watches one frame in N, ${MIN_INTERVAL} to ${MAX_INTERVAL} (default ${DEFAULT_INTERVAL})
  --estimator E   lite, full or heavy (default ${DEFAULT_ESTIMATOR})
  --out PATH      a .json file (one clip) or a folder (default: the current folder)`;

interface Command {
  readonly clips: readonly string[];
  readonly every: number;
  readonly estimator: EstimatorName;
  readonly outputs: readonly string[];
}

async function parseCommand(argv: string[]): Promise<Command | 'help'> {
  let parsed: ReturnType<typeof parse>;
  try {
    parsed = parse(argv);
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
  const { values, positionals } = parsed;
  if (values.help) return 'help';
  if (positionals.length === 0) throw new UsageError(`Name at least one clip.\n${USAGE}`);
  return {
    clips: positionals,
    every: parseEvery(values.every),
    estimator: parseEstimator(values.estimator),
    outputs: await outputPaths(positionals, values.out),
  };
}

function parse(args: string[]) {
  return parseArgs({
    args,
    allowPositionals: true,
    options: {
      every: { type: 'string', default: String(DEFAULT_INTERVAL) },
      estimator: { type: 'string', default: DEFAULT_ESTIMATOR },
      out: { type: 'string' },
      help: { type: 'boolean', short: 'h', default: false },
    },
  });
}

async function recoverOne(
  engine: HeadlessEngine,
  clip: string,
  output: string,
  command: Command,
): Promise<void> {
  await access(clip, constants.R_OK).catch(() => {
    throw new Error('there is no such file, or it may not be read.');
  });
  const line = new ProgressLine(basename(clip));
  try {
    const text = await engine.recover(clip, {
      every: command.every,
      estimator: command.estimator,
      onProgress: (progress) => line.update(progress),
    });
    await writeWhole(output, text);
    line.end();
    process.stdout.write(`${summary(clip, output, text)}\n`);
  } finally {
    line.end();
  }
}

function summary(clip: string, output: string, text: string): string {
  const { cost } = parsePoseFile(JSON.parse(text));
  // The estimators to choose from here all say their FLOPs.
  const percent = ((cost.flopsRatio ?? 1) * 100).toFixed(1);
  return (
    `${basename(clip)}: ${cost.frames} frames, ${cost.estimatorCalls} watched, ` +
    `${percent} % of the FLOPs of watching every frame, ${(cost.wallMs / 1000).toFixed(1)} s` +
    ` → ${relative('.', output)}`
  );
}

async function main(): Promise<number> {
  const command = await parseCommand(process.argv.slice(2));
  if (command === 'help') {
    process.stdout.write(`${USAGE}\n`);
    return 0;
  }
  const engine = await HeadlessEngine.start();
  let failures = 0;
  try {
    for (const [index, clip] of command.clips.entries()) {
      try {
        await recoverOne(engine, clip, command.outputs[index]!, command);
      } catch (error) {
        failures += 1;
        process.stderr.write(`${clip}: ${error instanceof Error ? error.message : error}\n`);
      }
    }
  } finally {
    await engine.close();
  }
  return failures === 0 ? 0 : 1;
}

main().then(
  (code) => {
    process.exitCode = code;
  },
  (error: unknown) => {
    process.stderr.write(`${error instanceof Error ? error.message : error}\n`);
    process.exitCode = error instanceof UsageError ? 2 : 1;
  },
);
