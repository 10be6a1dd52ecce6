import { netFlops } from '../cost/flops.ts';
import { CostMeter } from '../cost/meter.ts';
import { DeciWatchError } from '../errors.ts';
import type { PoseEstimator } from '../estimators/estimator.ts';
import { recoverCubic } from '../recovery/cubic.ts';
import type { Recoverer } from '../recovery/recoverer.ts';
import type { SeenSample, SpatialSample, WatchedClip } from '../recovery/watched-clip.ts';
import { watchedFrames } from '../sampling/watched.ts';
import type { Clip } from '../sources/clip.ts';
import { nextTask } from './next-task.ts';
import type { ProgressReporter } from './progress.ts';
import type { RecoveredClip } from './types.ts';

/** A job for `recoverClip`, once all that it needs is loaded. */
export interface RecoverJob {
  /** Stays the caller's to close, as do the other two. */
  readonly clip: Clip;
  readonly estimator: PoseEstimator;
  /** Null where the estimator's skeleton is not the nets'. */
  readonly recoverer: Recoverer | null;
  /** N. */
  readonly every: number;
  readonly progress: ProgressReporter;
  readonly signal: AbortSignal;
}

/**
 * Watches one frame in N, then recovers all of them.
 *
 * It stops within one estimator call or one window when aborted.
 * @throws DeciWatchError; the signal's reason when aborted
 */
export async function recoverClip(job: RecoverJob): Promise<RecoveredClip> {
  const { clip, estimator, every } = job;
  const { frameCount } = clip.info;
  const meter = new CostMeter(estimator.flops);
  const start = performance.now();

  const { watched, seen } = await watch(job, meter);
  if (seen.length === 0) {
    throw new DeciWatchError(
      'nobody-in-view',
      `Nobody was seen in any of the ${watched.length} watched frames of ${clip.info.name}: ` +
        'choose a clip with one person in full view, or a more accurate estimator.',
    );
  }
  const recovered = await recover(job, { times: clip.times, watched, seen, every }, meter);
  return {
    source: clip.info,
    interval: every,
    estimator: { name: estimator.name, flops: estimator.flops },
    ...recovered,
    cost: meter.report(frameCount, performance.now() - start),
  };
}

/** The frames between: by the nets where they can take the samples, otherwise by a spline through them. */
async function recover(
  { clip, estimator, recoverer, progress, signal }: RecoverJob,
  watched: WatchedClip,
  meter: CostMeter,
): Promise<Pick<RecoveredClip, 'recovery' | 'poses2d' | 'poses3d'>> {
  const { frameCount } = clip.info;
  const seen = watched.seen.filter(isSpatial);
  if (seen.length > 0 && seen.length < watched.seen.length) throw mixed(estimator.name);
  if (!recoverer || seen.length === 0) {
    progress.report('recovering', 0, frameCount, frameCount);
    const start = performance.now();
    const poses = recoverCubic(watched, estimator.skeleton);
    // A few operations for each value, which nobody would see beside the estimator's: no FLOPs are counted.
    meter.addRecover(0, performance.now() - start);
    return { recovery: 'cubic', ...poses };
  }
  const poses = await recoverer.recover(
    { ...watched, seen },
    async ({ entry, samples, frames, denoiseMs, recoverMs }, done, total) => {
      meter.addDenoise(netFlops(entry.denoise.flops, samples, frames), denoiseMs);
      meter.addRecover(netFlops(entry.recover.flops, samples, frames), recoverMs);
      progress.report('recovering', done / total, frameCount, frameCount);
      await nextTask();
      signal.throwIfAborted();
    },
  );
  return { recovery: 'nets', ...poses };
}

function isSpatial(sample: SeenSample): sample is SpatialSample {
  return sample.estimate.keypoints3d !== null;
}

function mixed(name: string): DeciWatchError {
  return new DeciWatchError(
    'estimator-failed',
    `The estimator ${name} gave 3D in some of the frames only: let it give keypoints3d always or never.`,
  );
}

/** The estimator's part: which frames it looked at, and in which of them it saw somebody. */
async function watch(
  { clip, estimator, every, progress, signal }: RecoverJob,
  meter: CostMeter,
): Promise<{ watched: number[]; seen: SeenSample[] }> {
  const { frameCount } = clip.info;
  const watched: number[] = [];
  const seen: SeenSample[] = [];
  let asked = performance.now();
  progress.report('watching', 0, 0, frameCount);
  for await (const { index, time, image } of clip.frames(watchedFrames(frameCount, every))) {
    const got = performance.now();
    meter.addDecode(got - asked);
    const estimate = await estimator.estimate(image, time * 1000);
    meter.addEstimatorCall(performance.now() - got);
    watched.push(index);
    if (estimate) seen.push({ frame: index, estimate });
    progress.report('watching', (index + 1) / frameCount, index + 1, frameCount);
    await nextTask();
    signal.throwIfAborted();
    asked = performance.now();
  }
  return { watched, seen };
}
