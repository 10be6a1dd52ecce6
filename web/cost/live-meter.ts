import type { CostParts } from './report.ts';

/** Seconds that the running figures look back. */
const WINDOW_S = 10;

/** One estimator call, and the nets after it. */
interface Watched {
  readonly at: number;
  readonly estimatorMs: number;
  readonly denoiseMs: number;
  readonly recoverMs: number;
  readonly denoiseFlops: number;
  readonly recoverFlops: number;
}

/** What live playback costs and how late it is, over the last ten seconds. */
export interface LiveReport {
  /** Camera frames, those that were missed included. */
  readonly frames: number;
  /** How many of them the estimator looked at. */
  readonly estimatorCalls: number;
  /** Camera frames whose skeleton was drawn. */
  readonly shown: number;
  /** Camera frames that the page never got to see. */
  readonly missed: number;
  /** Frames per second of the camera. */
  readonly frameRate: number;
  /** FLOPs for one camera frame; recover includes what looks ahead. */
  readonly flopsPerFrame: CostParts;
  /** FLOPs for one frame if the estimator watched every frame. */
  readonly everyFrameFlopsPerFrame: number;
  /** `flopsPerFrame.total / everyFrameFlopsPerFrame`. */
  readonly flopsRatio: number;
  /** Milliseconds of the worker for one camera frame. */
  readonly msPerFrame: CostParts;
  /** The mean estimator call, in milliseconds. */
  readonly msPerEstimatorCall: number;
  /** Milliseconds from a frame's capture until its skeleton was drawn: median and 95th percentile. */
  readonly delayMs: { readonly median: number; readonly p95: number };
  /** Milliseconds from a frame's capture until the page was given it, median: the camera's own delay. */
  readonly cameraMs: number;
}

/** Counts live playback as it happens. Times are in seconds. */
export class LiveMeter {
  #frames: { at: number; count: number; missed: number; cameraMs: number }[] = [];
  #watched: Watched[] = [];
  #shown: { at: number; delayMs: number }[] = [];
  #totals = { frames: 0, missed: 0, calls: 0, shown: 0 };

  /** @param estimatorFlops f(E): FLOPs of one estimator call */
  constructor(readonly estimatorFlops: number) {}

  /** @param missed camera frames before this one that were never seen */
  addFrame(at: number, missed: number, cameraMs: number): void {
    this.#frames.push({ at, count: 1 + missed, missed, cameraMs });
    this.#totals.frames += 1 + missed;
    this.#totals.missed += missed;
    this.#forget(at);
  }

  addWatched(watched: Watched): void {
    this.#watched.push(watched);
    this.#totals.calls++;
  }

  /** The skeleton of a camera frame was drawn for the first time. */
  addShown(at: number, delayMs: number): void {
    this.#shown.push({ at, delayMs });
    this.#totals.shown++;
  }

  /** Since the start. */
  get totals(): Readonly<{ frames: number; missed: number; calls: number; shown: number }> {
    return this.#totals;
  }

  /** Over the last ten seconds. */
  report(): LiveReport {
    const frames = sum(this.#frames.map(({ count }) => count));
    const per = 1 / Math.max(1, frames);
    const parts = (estimator: number, denoise: number, recover: number): CostParts => ({
      estimator: estimator * per,
      denoise: denoise * per,
      recover: recover * per,
      total: (estimator + denoise + recover) * per,
    });
    const calls = this.#watched;
    const flopsPerFrame = parts(
      calls.length * this.estimatorFlops,
      sum(calls.map((call) => call.denoiseFlops)),
      sum(calls.map((call) => call.recoverFlops)),
    );
    const estimatorMs = sum(calls.map((call) => call.estimatorMs));
    const delays = this.#shown.map(({ delayMs }) => delayMs).sort((a, b) => a - b);
    const span = (this.#frames.at(-1)?.at ?? 0) - (this.#frames[0]?.at ?? 0);
    const cameras = this.#frames.map(({ cameraMs }) => cameraMs).sort((a, b) => a - b);
    return {
      frames,
      estimatorCalls: calls.length,
      shown: this.#shown.length,
      missed: sum(this.#frames.map(({ missed }) => missed)),
      frameRate: span > 0 ? (frames - 1) / span : 0,
      flopsPerFrame,
      everyFrameFlopsPerFrame: this.estimatorFlops,
      flopsRatio: flopsPerFrame.total / this.estimatorFlops,
      msPerFrame: parts(
        estimatorMs,
        sum(calls.map((call) => call.denoiseMs)),
        sum(calls.map((call) => call.recoverMs)),
      ),
      msPerEstimatorCall: estimatorMs / Math.max(1, calls.length),
      delayMs: { median: quantile(delays, 0.5), p95: quantile(delays, 0.95) },
      cameraMs: quantile(cameras, 0.5),
    };
  }

  #forget(now: number): void {
    const recent = ({ at }: { at: number }) => at > now - WINDOW_S;
    this.#frames = this.#frames.filter(recent);
    this.#watched = this.#watched.filter(recent);
    this.#shown = this.#shown.filter(recent);
  }
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}

/** Of ascending values; 0 where there are none. */
function quantile(values: readonly number[], share: number): number {
  return values[Math.min(values.length - 1, Math.floor(share * values.length))] ?? 0;
}
