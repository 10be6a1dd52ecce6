import type { SpatialEstimate } from '../estimators/estimator.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import { bridges } from '../sampling/segments.ts';
import { WINDOW_INTERVALS } from '../sampling/windows.ts';
import type { PairEntry } from './manifest.ts';
import type { Recoverer } from './recoverer.ts';
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
  /**
   * The newest interval, or, where times ahead were asked for, what comes after the sample. Null after
   * the first sample and after a gap.
   */
  readonly chunk: LiveChunk | null;
  readonly runs: readonly LiveRun[];
}

/** One window through one pair of nets, or through its ForecastNet. */
export interface LiveRun {
  readonly entry: PairEntry;
  readonly forecast: boolean;
  /** S. */
  readonly samples: number;
  /** T. */
  readonly frames: number;
  /** DenoiseNet's; ForecastNet's own is in `ms`. */
  readonly denoiseMs: number;
  readonly ms: number;
}

/** A watched frame and what is wanted of it. */
export interface LiveSample {
  /** Seconds. */
  readonly time: number;
  /** Null: nobody was seen. */
  readonly estimate: SpatialEstimate | null;
  /** Times, in seconds and increasing, of the camera's frames up to this one. */
  readonly frameTimes: Float64Array;
  /** Times from this one on to look ahead to; where there are none, the interval before is recovered. */
  readonly ahead: Float64Array;
}

const NOTHING: LiveStep = { chunk: null, runs: [] };

/**
 * The streaming form of {@link Recoverer}: a window of the last Q + 1 samples slides by one sample, and
 * each new one gives the frames of the newest interval, or those to come. Uses the recoverer's nets, which stay its own.
 */
export class LiveRecoverer {
  #samples: { readonly time: number; readonly estimate: SpatialEstimate }[] = [];
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

    const window: SampleList = {
      estimates: this.#samples.map((sample) => sample.estimate),
      times: Float64Array.from(this.#samples, (sample) => sample.time),
    };
    if (ahead.length > 0) return this.#lookAhead(window, ahead);
    // The samples' own times too, so that the stretch begins and ends where its neighbours do.
    const inner = frameTimes.filter((frame) => frame > before.time && frame < time);
    const times = Float64Array.of(before.time, ...inner, time);
    return this.#recover(window, times, scoresBetween(before, { time, estimate }, times));
  }

  async #recover(
    { estimates, times: sampleTimes }: SampleList,
    times: Float64Array,
    scores: Float32Array,
  ): Promise<LiveStep> {
    const found: Float32Array[] = [];
    const runs: LiveRun[] = [];
    for (const pair of [this.recoverer.pair2d, this.recoverer.pair3d]) {
      const { entry } = pair;
      const window = await pair.clean(estimates, sampleTimes);
      const { poses, ms } = await pair.recoverAt(window, times);
      found.push(poses);
      const sizes = { samples: estimates.length, frames: times.length };
      runs.push({ entry, forecast: false, ...sizes, denoiseMs: window.ms, ms });
    }
    return { chunk: chunk(times, found, scores), runs };
  }

  async #lookAhead({ estimates, times }: SampleList, ahead: Float64Array): Promise<LiveStep> {
    const found: Float32Array[] = [];
    const runs: LiveRun[] = [];
    for (const pair of [this.recoverer.pair2d, this.recoverer.pair3d]) {
      const { entry } = pair;
      const { poses, ms } = await pair.forecastAt(estimates, times, ahead);
      found.push(poses);
      const sizes = { samples: estimates.length, frames: ahead.length };
      runs.push({ entry, forecast: true, ...sizes, denoiseMs: 0, ms });
    }
    const { scores } = estimates.at(-1)!;
    return { chunk: chunk(ahead, found, repeated(scores, ahead.length)), runs };
  }
}

/** The samples of a window side by side. */
interface SampleList {
  readonly estimates: readonly SpatialEstimate[];
  readonly times: Float64Array;
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
