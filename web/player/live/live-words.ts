import type { LiveSettings, LiveState, LiveStatus } from '../../engine/live/types.ts';

const STATES: Readonly<Record<LiveState, string>> = {
  loading: 'Loading the estimator and the nets …',
  waiting: 'Waiting for the camera’s picture.',
  looking: 'Nobody in view: step back until your whole body is in the picture.',
  following: 'Following one person.',
  lost: 'Lost from view.',
};

/** What is going on, in one sentence. */
export function liveWords(state: LiveState): string {
  return STATES[state];
}

/** Why fewer frames are watched than was asked for, or nothing. */
export function loadWords(status: LiveStatus, { every, load }: LiveSettings): string {
  if (load === 'skip' || status.every <= every) return '';
  return `This device is too slow for one frame in ${every} with this estimator: watching one in ${status.every}.`;
}

/** What a mode does, with its delay as measured. */
export function delayWords(mode: LiveSettings['mode'], medianMs: number): string {
  const figure = `${Math.round(medianMs)} ms`;
  return mode === 'smooth'
    ? `Shown ${figure} after it happened, with the picture that belongs to it.`
    : `Shown ${figure} after it happened; what comes after the last look is foreseen.`;
}
