import type { CostParts, CostReport } from './report.ts';

/**
 * Adds up what a clip costs while it is worked on.
 *
 * Equation 5 of the paper, 1/T · (T/N · f(E) + T · (f(D) + f(R))), supposes that N divides T and that
 * windows do not overlap. The meter counts each call as it is made, so that the extra watched last
 * frame, watched frames in which nobody was seen, and frames recovered by two windows are all in it.
 */
export class CostMeter {
  readonly #estimatorFlops: number;
  #estimatorCalls = 0;
  readonly #flops = { denoise: 0, recover: 0 };
  readonly #ms = { decode: 0, estimator: 0, denoise: 0, recover: 0 };

  /** @param estimatorFlops f(E): FLOPs of one estimator call; 0 where they are not known */
  constructor(estimatorFlops: number) {
    this.#estimatorFlops = estimatorFlops;
  }

  /** Milliseconds spent on getting frames out of the file. */
  addDecode(ms: number): void {
    this.#ms.decode += ms;
  }

  /** One watched frame, whether or not somebody was seen in it. */
  addEstimatorCall(ms: number): void {
    this.#estimatorCalls++;
    this.#ms.estimator += ms;
  }

  /** One call of DenoiseNet. */
  addDenoise(flops: number, ms: number): void {
    this.#flops.denoise += flops;
    this.#ms.denoise += ms;
  }

  /** One call of RecoverNet. */
  addRecover(flops: number, ms: number): void {
    this.#flops.recover += flops;
    this.#ms.recover += ms;
  }

  /**
   * What the calls so far cost per frame.
   *
   * @param frames T: frames of the clip, at least 1
   * @param wallMs milliseconds from the first frame asked for to the last pose
   */
  report(frames: number, wallMs: number): CostReport {
    const everyFrame = this.#estimatorFlops;
    const flopsPerFrame = partsPerFrame(frames, {
      estimator: this.#estimatorCalls * everyFrame,
      ...this.#flops,
    });
    const decode = this.#ms.decode / frames;
    const ms = partsPerFrame(frames, this.#ms);
    return {
      frames,
      estimatorCalls: this.#estimatorCalls,
      flopsPerFrame,
      everyFrameFlopsPerFrame: everyFrame,
      flopsRatio: everyFrame > 0 ? flopsPerFrame.total / everyFrame : null,
      msPerFrame: { ...ms, decode, total: ms.total + decode },
      msPerEstimatorCall: this.#ms.estimator / Math.max(1, this.#estimatorCalls),
      wallMs,
    };
  }
}

function partsPerFrame(frames: number, sums: Omit<CostParts, 'total'>): CostParts {
  const estimator = sums.estimator / frames;
  const denoise = sums.denoise / frames;
  const recover = sums.recover / frames;
  return { estimator, denoise, recover, total: estimator + denoise + recover };
}
