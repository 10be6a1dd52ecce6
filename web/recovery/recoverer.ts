import { type FileSet, fetchListed } from '../download.ts';
import { DeciWatchError } from '../errors.ts';
import type { SpatialEstimate } from '../estimators/estimator.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import type { PoseSequence } from '../pose/sequence.ts';
import { Stitcher } from '../sampling/stitcher.ts';
import { cutWindows, type SampleWindow } from '../sampling/windows.ts';
import { fetchModelManifest, type PairEntry } from './manifest.ts';
import { fetchPair, NetPair } from './net-pair.ts';
import { centreOnRoot } from './root.ts';
import { interpolateScores } from './scores.ts';
import { type WatchedClip, watchedFlags } from './watched-clip.ts';

/** One window through one pair of nets. */
export interface PairRun {
  readonly entry: PairEntry;
  /** S. */
  readonly samples: number;
  /** T of the window. */
  readonly frames: number;
  readonly denoiseMs: number;
  readonly recoverMs: number;
}

const KEYPOINTS = BLAZEPOSE_33.joints.length;

/** For the first run of a net, whose result nobody looks at. */
const NOBODY: SpatialEstimate = {
  keypoints2d: new Float32Array(KEYPOINTS * 2),
  keypoints3d: new Float32Array(KEYPOINTS * 3),
  scores: new Float32Array(KEYPOINTS),
};

/** A pose for every frame, from the poses of the watched ones, in 2D and in 3D. */
export class Recoverer {
  #forecasts: Promise<void> | null = null;

  private constructor(
    private readonly files: FileSet,
    readonly pair2d: NetPair,
    readonly pair3d: NetPair,
  ) {}

  /**
   * Fetches the manifest and the four nets, and runs each once: the first run is slower than the others.
   * @throws DeciWatchError `model-missing` or `model-mismatch`
   */
  static async load(files: FileSet, signal?: AbortSignal): Promise<Recoverer> {
    const { pairs } = await fetchModelManifest(files, signal);
    // All files before the first net: what fails on the way leaves nothing to free.
    const [files2d, files3d] = await Promise.all([
      fetchPair(files, pairs['2d'], signal),
      fetchPair(files, pairs['3d'], signal),
    ]);
    const pair2d = await NetPair.create(pairs['2d'], files2d);
    const pair3d = await NetPair.create(pairs['3d'], files3d);
    const times = Float64Array.of(0, 1 / 3);
    const samples = [NOBODY, NOBODY];
    for (const pair of [pair2d, pair3d]) {
      await pair.run({ samples, sampleTimes: times, frameTimes: times });
    }
    return new Recoverer(files, pair2d, pair3d);
  }

  /**
   * Fetches the two nets that look ahead, and runs each once; where that has been done, or is being done, not again.
   * @throws DeciWatchError `model-missing` or `model-mismatch`; also where the manifest lists none
   */
  loadForecasts(): Promise<void> {
    this.#forecasts ??= this.#addForecasts().catch((error) => {
      this.#forecasts = null;
      throw error;
    });
    return this.#forecasts;
  }

  async #addForecasts(): Promise<void> {
    const pairs = [this.pair2d, this.pair3d];
    const files = await Promise.all(
      pairs.map(({ entry }) => {
        if (entry.forecast) return fetchListed(this.files, entry.forecast);
        throw new DeciWatchError(
          'model-missing',
          'These nets cannot look ahead, since their manifest lists no forecast: choose the smooth mode.',
        );
      }),
    );
    for (const [i, pair] of pairs.entries()) {
      // One of a try that failed at the other.
      if (pair.hasForecast) continue;
      await pair.addForecast(files[i]!);
      const times = Float64Array.of(0, 1 / 3);
      await pair.forecastAt([NOBODY, NOBODY], times, Float64Array.of(1 / 3, 1 / 2));
    }
  }

  /**
   * @param onRun called after each window and pair; may wait, so that others get their turn, and may
   *   throw, which ends the work
   */
  async recover(
    clip: WatchedClip<SpatialEstimate>,
    onRun: (run: PairRun, done: number, total: number) => void | Promise<void>,
  ): Promise<{ poses2d: PoseSequence; poses3d: PoseSequence }> {
    const seenFrames = clip.seen.map(({ frame }) => frame);
    const windows = cutWindows(seenFrames, clip.times, clip.every);
    const total = 2 * windows.length;
    let done = 0;
    const report = (run: PairRun) => onRun(run, ++done, total);

    const values2d = await recoverAll(this.pair2d, clip, windows, report);
    const values3d = await recoverAll(this.pair3d, clip, windows, report);
    // The nets move the hips by millimetres; 3D poses are relative to the mid-hip, exactly.
    centreOnRoot(values3d, BLAZEPOSE_33);

    const shared = {
      skeleton: BLAZEPOSE_33,
      times: clip.times,
      scores: interpolateScores(clip, windows),
      watched: watchedFlags(clip),
    };
    return {
      poses2d: { ...shared, dims: 2, values: values2d },
      poses3d: { ...shared, dims: 3, values: values3d },
    };
  }

  async dispose(): Promise<void> {
    await this.pair2d.dispose();
    await this.pair3d.dispose();
  }
}

/** All frames of a clip in one representation: T·K·D values, NaN where no window reaches. */
async function recoverAll(
  pair: NetPair,
  { times, seen }: WatchedClip<SpatialEstimate>,
  windows: readonly SampleWindow[],
  report: (run: PairRun) => void | Promise<void>,
): Promise<Float32Array> {
  const stitcher = new Stitcher(times.length, KEYPOINTS * pair.dims);
  for (const window of windows) {
    const samples = window.samples.map((position) => seen[position]!);
    const frameTimes = times.subarray(window.firstFrame, window.lastFrame + 1);
    const { poses, denoiseMs, recoverMs } = await pair.run({
      samples: samples.map(({ estimate }) => estimate),
      sampleTimes: Float64Array.from(samples, ({ frame }) => times[frame]!),
      frameTimes,
    });
    stitcher.add(window, poses);
    await report({
      entry: pair.entry,
      samples: samples.length,
      frames: frameTimes.length,
      denoiseMs,
      recoverMs,
    });
  }
  return stitcher.finish();
}
