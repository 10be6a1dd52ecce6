/**
 * Live playback as the demo page does it, with the browser's fake camera playing a clip of a person.
 *
 *     npm run bench -- live [CLIP] [--seconds 60] [--estimator full] [--every 10] [--json FILE]
 *
 * Smooth and now at N, then smooth at N = 1 and at N again for the processor's time. Times of one run
 * are comparable with one another.
 */
import { parseArgs } from 'node:util';
import type { LiveMode } from '../engine/live/types.ts';
import { chromiumCpuSeconds } from './cpu-time.ts';
import { LivePage } from './live-page.ts';
import { parseEstimator, parseEvery, UsageError } from './options.ts';
import { writeWhole } from './outputs.ts';

/** Models are warm and delays have settled by then. */
const WARM_UP_S = 8;

/** What is allowed beside an interval and an estimator call, in milliseconds. */
const SLACK_MS = 50;

interface LiveRow {
  readonly name: string;
  readonly estimator: string;
  readonly mode: LiveMode;
  readonly every: number;
  readonly seconds: number;
  /** Camera frames, those that the page never saw, estimator calls, frames whose skeleton was drawn. */
  readonly frames: number;
  readonly missed: number;
  readonly calls: number;
  readonly shown: number;
  readonly shownShare: number;
  readonly callShare: number;
  /** From capture to drawing; `added` is without the camera's own. */
  readonly delayMs: { readonly median: number; readonly p95: number };
  readonly addedDelayMs: { readonly median: number; readonly p95: number };
  readonly allowedDelayMs: number;
  readonly msPerEstimatorCall: number;
  readonly flopsRatio: number;
  readonly longTasks: number;
  readonly longestTaskMs: number;
  readonly cpuPerSecond: number;
}

async function measure(
  live: LivePage,
  choice: { every: number; estimator: string; mode: LiveMode },
  seconds: number,
): Promise<LiveRow> {
  await live.follow(choice);
  await live.wait(WARM_UP_S);
  const before = await live.snapshot();
  const cpuBefore = await chromiumCpuSeconds(live.browser);
  const start = performance.now();
  await live.wait(seconds);
  const after = await live.snapshot();
  const cpu = (await chromiumCpuSeconds(live.browser)) - cpuBefore;
  const passed = (performance.now() - start) / 1000;
  await live.stop();
  const count = (key: 'frames' | 'missed' | 'calls' | 'shown') =>
    after.totals[key] - before.totals[key];
  const { report } = after;
  const added = (ms: number) => ms - report.cameraMs;
  const interval = choice.mode === 'smooth' ? (1000 * choice.every) / report.frameRate : 0;
  process.stderr.write(`measured live ${choice.mode} N=${choice.every}\n`);
  return {
    name: `live ${choice.mode} ${choice.estimator} N=${choice.every}`,
    ...choice,
    seconds: passed,
    frames: count('frames'),
    missed: count('missed'),
    calls: count('calls'),
    shown: count('shown'),
    shownShare: count('shown') / count('frames'),
    callShare: count('calls') / count('frames'),
    delayMs: report.delayMs,
    addedDelayMs: { median: added(report.delayMs.median), p95: added(report.delayMs.p95) },
    allowedDelayMs: interval + report.msPerEstimatorCall + SLACK_MS,
    msPerEstimatorCall: report.msPerEstimatorCall,
    flopsRatio: report.flopsRatio,
    longTasks: after.longTasks.length,
    longestTaskMs: Math.max(0, ...after.longTasks),
    cpuPerSecond: cpu / passed,
  };
}

function print(rows: readonly LiveRow[]): void {
  const head = ['mode', 'N', 'camera frames', 'shown', 'watched', 'delay ms (median, p95)'];
  head.push('added (median, p95)', 'allowed', 'call ms', 'FLOPs/N=1', 'tasks > 50 ms', 'CPU s/s');
  const body = rows.map((row) => [
    row.mode,
    String(row.every),
    `${row.frames} (${row.missed} missed)`,
    `${(100 * row.shownShare).toFixed(1)} %`,
    `${(100 * row.callShare).toFixed(1)} %`,
    `${row.delayMs.median.toFixed(0)}, ${row.delayMs.p95.toFixed(0)}`,
    `${row.addedDelayMs.median.toFixed(0)}, ${row.addedDelayMs.p95.toFixed(0)}`,
    row.allowedDelayMs.toFixed(0),
    row.msPerEstimatorCall.toFixed(0),
    row.flopsRatio.toFixed(3),
    `${row.longTasks} (${row.longestTaskMs.toFixed(0)} ms)`,
    row.cpuPerSecond.toFixed(2),
  ]);
  const lines = [head, ...body];
  const widths = head.map((_, i) => Math.max(...lines.map((line) => line[i]!.length)));
  const text = lines.map((line) => line.map((cell, i) => cell.padStart(widths[i]!)).join('  '));
  process.stdout.write(`${text.join('\n')}\n`);
}

/** Runs the command; `args` are those after `live`. */
export async function benchLive(args: readonly string[]): Promise<void> {
  const { values, positionals } = parseArgs({
    args: [...args],
    allowPositionals: true,
    options: {
      seconds: { type: 'string', default: '60' },
      estimator: { type: 'string', default: 'full' },
      every: { type: 'string', default: '10' },
      json: { type: 'string' },
    },
  });
  const seconds = Number(values.seconds);
  if (!(seconds >= 2)) {
    throw new UsageError(`--seconds wants a number of 2 or more, not "${values.seconds}".`);
  }
  const estimator = parseEstimator(values.estimator);
  const every = parseEvery(values.every);
  const live = await LivePage.start(positionals[0]);
  try {
    const rows: LiveRow[] = [];
    rows.push(await measure(live, { every, estimator, mode: 'smooth' }, seconds));
    rows.push(await measure(live, { every, estimator, mode: 'now' }, seconds));
    const all = await measure(live, { every: 1, estimator, mode: 'smooth' }, seconds);
    print([...rows, all]);
    const cpu = cpuRatios(rows[0]!, all);
    process.stdout.write(
      `CPU, N = ${every} against N = 1: ${cpu.asRun.toFixed(3)} as run; ` +
        `${cpu.perWatchedSecond.toFixed(3)} for each second of video that was watched as N says ` +
        `(at N = 1 the estimator kept up with ${(100 * all.callShare).toFixed(0)} % of the frames)\n`,
    );
    if (values.json) {
      await writeWhole(values.json, `${JSON.stringify({ rows: [...rows, all], cpu }, null, 2)}\n`);
    }
  } finally {
    await live.close();
  }
}

/**
 * The processor's time at N over that at N = 1. Where the estimator does not keep up with every frame,
 * a second of wall time is less than a second of video watched at every frame: the second ratio counts
 * what a whole one would have taken.
 */
function cpuRatios(some: LiveRow, all: LiveRow) {
  const whole = (row: LiveRow) => row.cpuPerSecond / Math.min(1, row.callShare * row.every);
  return {
    asRun: some.cpuPerSecond / all.cpuPerSecond,
    perWatchedSecond: whole(some) / whole(all),
  };
}
