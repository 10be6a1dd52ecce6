/**
 * Decides which frames are told of when a screen shows another one: in playing, every frame once and in
 * order, those too that the screen was too slow for; after a jump, the one jumped to alone.
 */
export class PoseTeller {
  #last: number | null = null;
  #jumped = true;

  /** Another clip: even the same frame is another one. */
  reset(): void {
    this.#last = null;
    this.#jumped = true;
  }

  /** Somebody asked for another place: the next frame shown does not follow from the last. */
  jump(): void {
    this.#jumped = true;
  }

  /**
   * @param frame on screen now, from 0
   * @param frames T
   * @param landed false while a jump is still on its way, and frames of the old place may show
   * @returns the frames to tell of, in order
   */
  shown(frame: number, frames: number, landed = true): number[] {
    const last = this.#last;
    if (frame === last) return [];
    this.#last = frame;
    const jumped = this.#jumped;
    if (landed) this.#jumped = false;
    if (last === null || jumped) return [frame];
    if (frame > last) return range(last + 1, frame);
    // Playback began anew: in a loop, or after its end.
    return [...range(last + 1, frames - 1), ...range(0, frame)];
  }

  /** Playback has come to its end: what has not been told of yet. */
  ended(frames: number): number[] {
    const last = this.#last;
    if (last === null || this.#jumped) return [];
    this.#last = frames - 1;
    return range(last + 1, frames - 1);
  }
}

function range(first: number, last: number): number[] {
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => first + i);
}
