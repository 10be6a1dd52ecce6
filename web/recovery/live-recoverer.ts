import type { PoseEstimate } from '../estimators/estimator.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import { bridges } from '../sampling/segments.ts';
import { WINDOW_INTERVALS } from '../sampling/windows.ts';
import type { CleanWindow, NetPair, TimedPoses } from './net-pair.ts';
import type { PairRun, Recoverer } from './recoverer.ts';
import { centreOnRoot } from './root.ts';
import { scoresBetween } from './scores.ts';

/** A stretch of poses in order of time. */
export interface LiveChunk {
  /** T seconds, increasing. */
  readonly times: Float64Array;
  /** T·K·2 pixels. */
  readonly values2d: Float32Array;
  /** T·K·3 metres relative to the mid-hip. */
  readonly values3d: Float32Array;
  /** T·K, 0 to 1. */
  readonly scores: Float32Array;
}

/** What one more sample gave. */
export interface LiveStep {
  /** The newest interval; null after the first sample and after a gap. */
  readonly recovered: LiveChunk | null;
  /** What comes after the sample, where that was asked for and can be told. */
  readonly forecast: LiveChunk | null;
  readonly runs: readonly PairRun[];
}

/** A watched frame and what is wanted of it. */
export interface LiveSample {
  /** Seconds. */
  readonly time: number;
  /** Null: nobody was seen. */
  readonly estimate: PoseEstimate | null;
  /** Times, in seconds and increasing, of the camera's frames up to this one. */
  readonly frameTimes: Float64Array;
  /** Times after this one to look ahead to; none where nobody asks. */
  readonly ahead: Float64Array;
}

const NOTHING: LiveStep = { recovered: null, forecast: null, runs: [] };

/**
 * The streaming form of {@link Recoverer}: a window of the last Q + 1 samples slides by one sample, and
 * each new one gives the frames of the newest interval. Uses the recoverer's nets, which stay its own.
 */
export class LiveRecoverer {
  #samples: { readonly time: number; readonly estimate: PoseEstimate }[] = [];
  #missing = 0;

  constructor(private readonly recoverer: Recoverer) {}

  async add({ time, estimate, frameTimes, ahead }: LiveSample): Promise<LiveStep> {
    if (!estimate) {
      this.#missing++;
      return NOTHING;
    }
    const last = this.#samples.at(-1);
    if (last && !bridges(this.#missing, time - last.time)) this.#samples = [];
    this.#missing = 0;
    this.#samples.push({ time, estimate });
    if (this.#samples.length > WINDOW_INTERVALS + 1) this.#samples.shift();
    const before = this.#samples.at(-2);
    if (!before) return NOTHING;

    // The samples' own times too, so that the stretch begins and ends where its neighbours do.
    const inner = frameTimes.filter((frame) => frame > before.time && frame < time);
    const times = Float64Array.of(before.time, ...inner, time);
    const runs: PairRun[] = [];
    const sampleTimes = Float64Array.from(this.#samples, (sample) => sample.time);
    const estimates = this.#samples.map((sample) => sample.estimate);
    const found = { recovered: [] as Float32Array[], forecast: [] as Float32Array[] };
    for (const pair of [this.recoverer.pair2d, this.recoverer.pair3d]) {
      const window = await pair.clean(estimates, sampleTimes);
      const recovered = await pair.recoverAt(window, times);
      found.recovered.push(recovered.poses);
      let forecast: TimedPoses | undefined;
      if (ahead.length > 0) {
        forecast = await pair.forecastAt(window, ahead);
        found.forecast.push(forecast.poses);
      }
      runs.push(runOf(pair, window, times, recovered, ahead, forecast));
    }
    return {
      recovered: chunk(times, found.recovered, scoresBetween(before, { time, estimate }, times)),
      forecast:
        ahead.length > 0
          ? chunk(ahead, found.forecast, repeated(estimate.scores, ahead.length))
          : null,
      runs,
    };
  }
}

function runOf(
  { entry }: NetPair,
  { samples, ms }: CleanWindow,
  times: Float64Array,
  recovered: TimedPoses,
  ahead: Float64Array,
  forecast: TimedPoses | undefined,
): PairRun {
  const run = { entry, samples, frames: times.length, denoiseMs: ms, recoverMs: recovered.ms };
  return forecast ? { ...run, ahead: ahead.length, forecastMs: forecast.ms } : run;
}

function chunk(
  times: Float64Array,
  [values2d, values3d]: readonly Float32Array[],
  scores: Float32Array,
): LiveChunk {
  centreOnRoot(values3d!, BLAZEPOSE_33);
  return { times, values2d: values2d!, values3d: values3d!, scores };
}

function repeated(values: Float32Array, count: number): Float32Array {
  const all = new Float32Array(values.length * count);
  for (let i = 0; i < count; i++) all.set(values, i * values.length);
  return all;
}
