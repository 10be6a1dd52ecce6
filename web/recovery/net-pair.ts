import { fetchListed } from '../download.ts';
import type { PoseEstimate } from '../estimators/estimator.ts';
import type { Dimensions } from '../pose/sequence.ts';
import type { PairEntry } from './manifest.ts';
import { fromNet } from './normalise.ts';
import { type Matrix, Net } from './runtime.ts';
import { buildSampled } from './sampled.ts';

/** The S samples of one window, and the T frames to recover from them. */
export interface WindowInput {
  /** S estimates; the pair takes of them what its entry names. */
  readonly samples: readonly PoseEstimate[];
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

/** The bytes of a pair's two ONNX files. */
export interface PairFiles {
  readonly denoise: Uint8Array;
  readonly recover: Uint8Array;
}

/**
 * Fetches a pair's files.
 * @throws DeciWatchError `model-missing` or `model-mismatch`
 */
export async function fetchPair(
  manifestUrl: URL,
  entry: PairEntry,
  signal?: AbortSignal,
): Promise<PairFiles> {
  const [denoise, recover] = await Promise.all([
    fetchListed(manifestUrl, entry.denoise, signal),
    fetchListed(manifestUrl, entry.recover, signal),
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
    const { sampled, frame } = buildSampled(this.entry, samples);
    const inUnits = (times: Float64Array): Matrix => ({
      data: Float32Array.from(times, (time) => (time - sampleTimes[0]!) / this.entry.timeUnit),
      dims: [1, times.length],
    });
    const sample_times = inUnits(sampleTimes);
    const start = performance.now();
    const { clean, features } = await this.denoise.run({ sampled, sample_times });
    const middle = performance.now();
    const { poses } = await this.recover.run({
      clean: clean!,
      features: features!,
      sample_times,
      frame_times: inUnits(frameTimes),
    });
    const end = performance.now();
    return {
      poses: fromNet(poses!.data, frame),
      denoiseMs: middle - start,
      recoverMs: end - middle,
    };
  }

  async dispose(): Promise<void> {
    await this.denoise.dispose();
    await this.recover.dispose();
  }
}
