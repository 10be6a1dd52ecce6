/** Stretches that are looked back on, and how many of the latest among them are let go. */
const MEMORY = 8;
const LET_GO = 2;

/** Beyond the usual arrival. What comes later than that is held for, and eased into. */
const MARGIN_S = 0.005;

/** Seconds of delay gained or lost for each second: movement runs that much slower or faster. */
const SLOWER = 0.25;
const FASTER = 0.1;

/** A difference that is not worth slewing: the mode or N has changed. */
const JUMP_S = 1.5;

/**
 * How long after its capture a frame is shown in smooth mode: as long as the poses of an interval take to
 * come, counted from its first frame, and no longer. Follows what it sees without a jump.
 */
export class SmoothDelay {
  #lags: number[] = [];
  #delay: number | null = null;
  #last = 0;

  /**
   * Poses have come.
   * @param first seconds, of the earliest frame that they are new for
   * @param now seconds
   */
  arrived(first: number, now: number): void {
    this.#lags.push(now - first);
    if (this.#lags.length > MEMORY) this.#lags.shift();
  }

  /** Forgets what it knows: N or the estimator has changed, or the camera was away. */
  reset(): void {
    this.#lags = [];
  }

  /**
   * The delay to show with now, in seconds.
   * @param expected what it will be, as long as nothing has come yet
   */
  at(now: number, expected: number): number {
    const target = (this.#usual() ?? expected) + MARGIN_S;
    const passed = Math.max(0, now - this.#last);
    this.#last = now;
    const delay = this.#delay;
    if (delay === null || Math.abs(target - delay) > JUMP_S) {
      this.#delay = target;
    } else {
      this.#delay = Math.min(delay + SLOWER * passed, Math.max(delay - FASTER * passed, target));
    }
    return this.#delay;
  }

  /** A stretch or two that came late are no reason to show all others later: a pose is held for them. */
  #usual(): number | null {
    const sorted = [...this.#lags].sort((a, b) => b - a);
    return sorted[Math.min(LET_GO, sorted.length - 1)] ?? null;
  }
}
