/** Seconds in which what was shown passes over into what is known better by now. */
export const EASE_SECONDS = 0.1;

/**
 * The share of an old difference that is still shown, `age` seconds after it came about: 1 at first, 0
 * from `EASE_SECONDS` on, flat at both ends (1 − smootherstep), so that neither place nor speed jumps.
 *
 * The same as `eased_share` in `export/deciwatch/live/easing.py`, which measures the live modes.
 */
export function easedShare(age: number): number {
  const x = Math.min(Math.max(age / EASE_SECONDS, 0), 1);
  return 1 - x * x * x * (x * (6 * x - 15) + 10);
}
