import type { CostReport } from '../../cost/report.ts';
import type { Recovery } from '../../engine/types.ts';
import { formatPercent, formatTimes } from './format.ts';

/** The counter's headline: a figure and the sentence that it begins. */
export interface CostHeadline {
  readonly figure: string;
  readonly sentence: string;
}

/**
 * Says what the clip cost against watching every frame, also where it cost more; where nobody knows an
 * estimator's FLOPs, how often it looked.
 */
export function costHeadline({
  flopsRatio,
  estimatorCalls,
  frames,
}: Pick<CostReport, 'flopsRatio' | 'estimatorCalls' | 'frames'>): CostHeadline {
  if (flopsRatio === null) {
    return {
      figure: formatPercent(estimatorCalls / frames),
      sentence: 'of the frames were looked at; how many FLOPs a look takes is not known',
    };
  }
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

/** @param recovery by a spline, there is no net whose milliseconds could be shown */
export function compareMs(
  { msPerFrame, msPerEstimatorCall }: CostReport,
  recovery: Recovery = 'nets',
): MsComparison {
  const decode: MsPart = { name: 'Decoding', kind: 'decode', ms: msPerFrame.decode };
  return {
    measured: [
      decode,
      { name: 'Estimator', kind: 'estimator', ms: msPerFrame.estimator },
      ...recoveryParts(msPerFrame, recovery),
    ],
    everyFrame: [decode, { name: 'Estimator', kind: 'estimator', ms: msPerEstimatorCall }],
    measuredTotal: msPerFrame.total,
    everyFrameTotal: msPerFrame.decode + msPerEstimatorCall,
  };
}

function recoveryParts({ denoise, recover }: CostReport['msPerFrame'], by: Recovery): MsPart[] {
  if (by === 'cubic') return [{ name: 'Spline', kind: 'recover', ms: recover }];
  return [
    { name: 'DenoiseNet', kind: 'denoise', ms: denoise },
    { name: 'RecoverNet', kind: 'recover', ms: recover },
  ];
}
