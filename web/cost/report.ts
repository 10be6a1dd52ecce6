/** FLOPs (2 × multiply-accumulates) or milliseconds of the three parts of equation 5. */
export interface CostParts {
  /** The pose estimator. */
  readonly estimator: number;
  /** DenoiseNet. */
  readonly denoise: number;
  /** RecoverNet. */
  readonly recover: number;
  /** Of these. */
  readonly total: number;
}

/** What a clip cost, against watching every frame of it with the same estimator. */
export interface CostReport {
  /** T. */
  readonly frames: number;
  /** Frames that were watched. */
  readonly estimatorCalls: number;
  /** Equation 5 of the paper: mean FLOPs for one frame of the clip. */
  readonly flopsPerFrame: CostParts;
  /** FLOPs for one frame when the estimator watches every frame: f(E); 0 where they are not known. */
  readonly everyFrameFlopsPerFrame: number;
  /** flopsPerFrame.total / everyFrameFlopsPerFrame; null where the estimator's FLOPs are not known. */
  readonly flopsRatio: number | null;
  /** Measured milliseconds for one frame of the clip; the total is of all four, decoding included. */
  readonly msPerFrame: CostParts & { readonly decode: number };
  /** The mean estimator call, in milliseconds: what watching one more frame would cost. */
  readonly msPerEstimatorCall: number;
  /** Milliseconds from the first frame asked for to the last pose, without loading. */
  readonly wallMs: number;
}
