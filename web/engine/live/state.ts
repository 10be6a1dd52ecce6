import type { LiveState } from './types.ts';

/** Frames are taken not to come any more after so many seconds. */
const SILENT_S = 1;

/** Somebody who is not seen any more is called lost for so long, then looked for. */
const LOST_S = 3;

/** What is going on, told from the last frame and the last look. Times are in seconds. */
export class LiveStateWatch {
  #lastFrame: number | null = null;
  #lastSeen: number | null = null;
  #seen = false;

  /** A frame of the camera has come. */
  frame(now: number): void {
    this.#lastFrame = now;
  }

  /** A look has been answered. @param seen somebody was in view */
  answered(now: number, seen: boolean): void {
    this.#seen = seen;
    if (seen) this.#lastSeen = now;
  }

  at(now: number): LiveState {
    if (this.#lastFrame === null || now - this.#lastFrame > SILENT_S) return 'waiting';
    if (this.#seen) return 'following';
    return this.#lastSeen !== null && now - this.#lastSeen < LOST_S ? 'lost' : 'looking';
  }
}
