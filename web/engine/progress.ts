import type { RecoverProgress, RecoverStage } from './types.ts';

/** At most this often is progress told, but for the last. */
const MIN_PERIOD_MS = 50;

/** Where each stage ends in the whole job. The estimator is nearly all of the work. */
const STAGE_ENDS: Readonly<Record<RecoverStage, readonly [from: number, to: number]>> = {
  loading: [0, 0.1],
  watching: [0.1, 0.9],
  recovering: [0.9, 1],
};

/** Turns the stages' own fractions into one that never falls and ends at 1. */
export class ProgressReporter {
  #fraction = 0;
  #lastMs = Number.NEGATIVE_INFINITY;
  #stage: RecoverStage | undefined;

  constructor(
    private readonly tell: (progress: RecoverProgress) => unknown,
    private readonly now: () => number = () => performance.now(),
  ) {}

  /** @param part 0 to 1 of this stage */
  report(stage: RecoverStage, part: number, framesDone: number, framesTotal: number): void {
    const [from, to] = STAGE_ENDS[stage];
    // The end is told by `finish`, when there is nothing left to do.
    const fraction = Math.min(from + part * (to - from), 0.999);
    this.#fraction = Math.max(this.#fraction, fraction);
    const now = this.now();
    if (stage === this.#stage && now - this.#lastMs < MIN_PERIOD_MS) return;
    this.#stage = stage;
    this.#lastMs = now;
    this.tell({ stage, fraction: this.#fraction, framesDone, framesTotal });
  }

  /** Tells that all is done; gives what the listener gave, to wait for. */
  finish(frames: number): unknown {
    return this.tell({
      stage: 'recovering',
      fraction: 1,
      framesDone: frames,
      framesTotal: frames,
    });
  }
}
