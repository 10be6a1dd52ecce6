import type { RecoverProgress } from '../../engine/types.ts';

/** What is being done, in a few words. */
export function progressWords({ stage }: RecoverProgress, every: number): string {
  switch (stage) {
    case 'loading':
      return 'Loading the models';
    case 'watching':
      return every === 1 ? 'Looking at every frame' : `Looking at one frame in ${every}`;
    case 'recovering':
      return every === 1 ? 'Smoothing' : 'Recovering the frames between';
  }
}

/** A job that has only just been asked for. */
export const NOT_STARTED: RecoverProgress = {
  stage: 'loading',
  fraction: 0,
  framesDone: 0,
  framesTotal: 0,
};
