/** Seconds in which the difference between what was shown and what is known better falls to 37 %. */
export const EASE_SECONDS = 0.03;

/**
 * The share of an old difference that is still shown, `age` seconds after it came about: 1 at first, so
 * that nothing jumps, and less and less.
 *
 * The same as `eased_share` in `export/deciwatch/live/easing.py`, which measures the live modes.
 */
export function easedShare(age: number): number {
  return Math.exp(-Math.max(age, 0) / EASE_SECONDS);
}
