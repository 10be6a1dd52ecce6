import { type FileSet, fetchListed } from '../download.ts';
import type { SpatialEstimate } from '../estimators/estimator.ts';
import type { Dimensions } from '../pose/sequence.ts';
import type { PairEntry } from './manifest.ts';
import { fromNet, type NetFrame } from './normalise.ts';
import { type Matrix, Net } from './runtime.ts';
import { buildSampled } from './sampled.ts';

/** The S samples of one window, and the T frames to recover from them. */
export interface WindowInput {
  /** S estimates; the pair takes of them what its entry names. */
  readonly samples: readonly SpatialEstimate[];
  /** S seconds, increasing. */
  readonly sampleTimes: Float64Array;
  /** T seconds, increasing, from the first sample's to the last one's. */
  readonly frameTimes: Float64Array;
}

/** What one window gave, and how long each net took. */
export interface WindowOutput {
  /** T·K·D: pixels, or metres relative to the mid-hip. */
  readonly poses: Float32Array;
  readonly denoiseMs: number;
  readonly recoverMs: number;
}

/** A window's samples after DenoiseNet, for the nets that go on from there. */
export interface CleanWindow {
  /** S. */
  readonly samples: number;
  /** Seconds of the first sample. */
  readonly begin: number;
  readonly inputs: Readonly<Record<'clean' | 'features' | 'sample_times', Matrix>>;
  readonly frame: NetFrame;
  readonly ms: number;
}

/** Poses of T times, and how long they took. */
export interface TimedPoses {
  /** T·K·D: pixels, or metres relative to the mid-hip. */
  readonly poses: Float32Array;
  readonly ms: number;
}

/** The bytes of a pair's ONNX files. */
export interface PairFiles {
  readonly denoise: Uint8Array;
  readonly recover: Uint8Array;
}

/**
 * Fetches a pair's files.
 * @throws DeciWatchError `model-missing` or `model-mismatch`
 */
export async function fetchPair(
  set: FileSet,
  entry: PairEntry,
  signal?: AbortSignal,
): Promise<PairFiles> {
  const [denoise, recover] = await Promise.all([
    fetchListed(set, entry.denoise, signal),
    fetchListed(set, entry.recover, signal),
  ]);
  return { denoise, recover };
}

/**
 * DenoiseNet and RecoverNet of one representation (equations 1 to 4 of the paper).
 *
 * DenoiseNet takes the S samples alone. Masking the other frames, as the authors' code does, gives
 * the same numbers for many times the work.
 */
export class NetPair {
  readonly dims: Dimensions;
  private forecast: Net | undefined;

  private constructor(
    readonly entry: PairEntry,
    private readonly denoise: Net,
    private readonly recover: Net,
  ) {
    this.dims = entry.dims;
  }

  static async create(entry: PairEntry, files: PairFiles): Promise<NetPair> {
    return new NetPair(entry, await Net.create(files.denoise), await Net.create(files.recover));
  }

  /** Recovers one window: cleans its samples, then finds all of its frames. */
  async run({ samples, sampleTimes, frameTimes }: WindowInput): Promise<WindowOutput> {
    const window = await this.clean(samples, sampleTimes);
    const { poses, ms } = await this.recoverAt(window, frameTimes);
    return { poses, denoiseMs: window.ms, recoverMs: ms };
  }

  /**
   * DenoiseNet on the S samples of a window.
   * @param sampleTimes S seconds, increasing
   */
  async clean(
    samples: readonly SpatialEstimate[],
    sampleTimes: Float64Array,
  ): Promise<CleanWindow> {
    const start = performance.now();
    const { sampled, frame } = buildSampled(this.entry, samples);
    const begin = sampleTimes[0]!;
    const sample_times = this.#inUnits(sampleTimes, begin);
    const { clean, features } = await this.denoise.run({ sampled, sample_times });
    const inputs = { clean: clean!, features: features!, sample_times };
    return {
      samples: samples.length,
      begin,
      inputs,
      frame,
      ms: performance.now() - start,
    };
  }

  /**
   * RecoverNet: poses at T times from a window's first sample to its last.
   * @param times T seconds, increasing
   */
  async recoverAt(window: CleanWindow, times: Float64Array): Promise<TimedPoses> {
    const start = performance.now();
    const frame_times = this.#inUnits(times, window.begin);
    const { poses } = await this.recover.run({ ...window.inputs, frame_times });
    return { poses: fromNet(poses!.data, window.frame), ms: performance.now() - start };
  }

  /**
   * ForecastNet: poses at T times from the last sample of a window on. It cleans the samples itself.
   * @param sampleTimes S seconds, increasing
   * @param times T seconds, increasing
   */
  async forecastAt(
    samples: readonly SpatialEstimate[],
    sampleTimes: Float64Array,
    times: Float64Array,
  ): Promise<TimedPoses> {
    if (!this.forecast) throw new Error('The forecast net has not been loaded.');
    const start = performance.now();
    const { sampled, frame } = buildSampled(this.entry, samples);
    const begin = sampleTimes[0]!;
    const { poses } = await this.forecast.run({
      sampled,
      sample_times: this.#inUnits(sampleTimes, begin),
      frame_times: this.#inUnits(times, begin),
    });
    return { poses: fromNet(poses!.data, frame), ms: performance.now() - start };
  }

  get hasForecast(): boolean {
    return this.forecast !== undefined;
  }

  /** Adds the net that {@link forecastAt} runs. */
  async addForecast(file: Uint8Array): Promise<void> {
    this.forecast ??= await Net.create(file);
  }

  #inUnits(times: Float64Array, begin: number): Matrix {
    const { timeUnit } = this.entry;
    return {
      data: Float32Array.from(times, (time) => (time - begin) / timeUnit),
      dims: [1, times.length],
    };
  }

  async dispose(): Promise<void> {
    await this.denoise.dispose();
    await this.recover.dispose();
    await this.forecast?.dispose();
  }
}
