import { netFlops } from '../../cost/flops.ts';
import { CostMeter } from '../../cost/meter.ts';
import type { EstimatorImage, SpatialEstimate } from '../../estimators/estimator.ts';
import { LiveRecoverer } from '../../recovery/live-recoverer.ts';
import type { BorrowedEstimator, Models } from '../models.ts';
import type { RecoveredClip } from '../types.ts';
import type { LiveNeeds, RecordedStretch, WatchAnswer, WatchRequest } from './messages.ts';
import { isSomebody } from './presence.ts';

const NEVER = new AbortController().signal;

/** The worker's half of live playback. Uses the worker's models, which stay its own. */
export class LiveWork {
  #live: LiveRecoverer | undefined;
  /** Kept between looks, too. */
  #estimator: BorrowedEstimator | undefined;
  /** Counts what has begun: only the last one's estimator is kept. */
  #begun = 0;

  constructor(private readonly models: Models) {}

  /** Loads and warms what is needed; returns the FLOPs of one estimator call. @throws DeciWatchError */
  async prepare({ estimator, forecast }: LiveNeeds): Promise<number> {
    const begun = ++this.#begun;
    const recoverer = await this.models.recoverer(NEVER);
    if (forecast) await recoverer.loadForecasts();
    const borrowed = await this.models.borrow(estimator, NEVER);
    const { flops } = borrowed.estimator;
    if (begun !== this.#begun) {
      borrowed.release();
      return flops;
    }
    this.#estimator?.release();
    this.#estimator = borrowed;
    this.#live = undefined;
    return flops;
  }

  /** Looks at one frame, and recovers what can be recovered from it. */
  async watch(image: EstimatorImage, request: WatchRequest): Promise<WatchAnswer> {
    const recoverer = await this.models.recoverer(NEVER);
    if (request.ahead.length > 0) await recoverer.loadForecasts();
    const { estimator, release } = await this.models.borrow(request.estimator, NEVER);
    if (request.afresh || !this.#live) this.#live = new LiveRecoverer(recoverer);
    const live = this.#live;
    let seen: SpatialEstimate | null;
    const start = performance.now();
    try {
      seen = await estimator.estimate(image);
    } finally {
      release();
    }
    const estimatorMs = performance.now() - start;
    const estimate = isSomebody(seen) ? seen : null;
    const { chunk, runs } = await live.add({ ...request, estimate });
    const answer = { denoiseMs: 0, recoverMs: 0, denoiseFlops: 0, recoverFlops: 0 };
    for (const { entry, forecast, samples, frames, denoiseMs, ms } of runs) {
      const net = forecast ? entry.forecast : entry.recover;
      answer.denoiseMs += denoiseMs;
      answer.recoverMs += ms;
      if (!forecast) answer.denoiseFlops += netFlops(entry.denoise.flops, samples, frames);
      if (net) answer.recoverFlops += netFlops(net.flops, samples, frames);
    }
    return { kind: 'watched', estimate, chunk, estimatorMs, ...answer };
  }

  /** Recovers a recorded stretch as a file would be. */
  async recoverStretch(stretch: RecordedStretch): Promise<RecoveredClip> {
    const { info, times, watched, seen, every, estimator } = stretch;
    const recoverer = await this.models.recoverer(NEVER);
    const start = performance.now();
    const meter = new CostMeter(estimator.flops);
    for (const _ of watched) meter.addEstimatorCall(stretch.estimatorMs / watched.length);
    const poses = await recoverer.recover(
      { times, watched, seen, every },
      ({ entry, samples, frames, denoiseMs, recoverMs }) => {
        meter.addDenoise(netFlops(entry.denoise.flops, samples, frames), denoiseMs);
        meter.addRecover(netFlops(entry.recover.flops, samples, frames), recoverMs);
      },
    );
    const wallMs = performance.now() - start + stretch.estimatorMs;
    return {
      source: info,
      interval: every,
      estimator,
      recovery: 'nets',
      ...poses,
      cost: meter.report(info.frameCount, wallMs),
    };
  }

  /** Forgets the samples, and gives the estimator back. */
  stop(): void {
    this.#begun++;
    this.#estimator?.release();
    this.#estimator = undefined;
    this.#live = undefined;
  }
}
