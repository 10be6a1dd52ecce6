import type { CostReport } from '../../cost/report.ts';
import { formatPercent, formatTimes } from './format.ts';

/** The counter's headline: a figure and the sentence that it begins. */
export interface CostHeadline {
  readonly figure: string;
  readonly sentence: string;
}

/** Says what the clip cost against watching every frame, also where it cost more. */
export function costHeadline({ flopsRatio }: Pick<CostReport, 'flopsRatio'>): CostHeadline {
  const figure = formatPercent(flopsRatio);
  if (flopsRatio >= 1) {
    return {
      figure,
      sentence:
        'of the FLOPs of watching every frame: nothing is skipped, and smoothing comes on top',
    };
  }
  return {
    figure,
    sentence: `of the FLOPs of watching every frame: ${formatTimes(1 / flopsRatio)} less work`,
  };
}

/** One part of the milliseconds per frame. */
export interface MsPart {
  readonly name: string;
  readonly kind: 'decode' | 'estimator' | 'denoise' | 'recover';
  readonly ms: number;
}

/** Milliseconds per frame as measured, and as every frame watched would take. */
export interface MsComparison {
  readonly measured: readonly MsPart[];
  readonly everyFrame: readonly MsPart[];
  readonly measuredTotal: number;
  readonly everyFrameTotal: number;
}

export function compareMs({ msPerFrame, msPerEstimatorCall }: CostReport): MsComparison {
  const decode: MsPart = { name: 'Decoding', kind: 'decode', ms: msPerFrame.decode };
  return {
    measured: [
      decode,
      { name: 'Estimator', kind: 'estimator', ms: msPerFrame.estimator },
      { name: 'DenoiseNet', kind: 'denoise', ms: msPerFrame.denoise },
      { name: 'RecoverNet', kind: 'recover', ms: msPerFrame.recover },
    ],
    everyFrame: [decode, { name: 'Estimator', kind: 'estimator', ms: msPerEstimatorCall }],
    measuredTotal: msPerFrame.total,
    everyFrameTotal: msPerFrame.decode + msPerEstimatorCall,
  };
}
