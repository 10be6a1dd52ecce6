import { easedShare } from '../../pose/easing.ts';
import type { LiveChunk } from '../../recovery/live-recoverer.ts';

/** Seconds in which a skeleton fades in where it appears, and out where nobody is seen any more. */
export const FADE_SECONDS = 0.3;

/** Seconds that the last pose stays before it fades: the next ones may only be late. */
export const HOLD_SECONDS = 0.1;

/** Seconds of poses that are kept behind what is shown. */
const KEPT_SECONDS = 1;

/** A faded skeleton is not eased into the next one: it would be seen to fly. */
const EASED_FROM = 0.5;

/** What is to be drawn at one moment. */
export interface LivePose {
  /** K·2 pixels of the camera's picture, origin top left. */
  readonly values2d: Float32Array;
  /** K·3 metres relative to the mid-hip: x right, y up, z towards the camera. */
  readonly values3d: Float32Array;
  /** K scores, 0 to 1. */
  readonly scores: Float32Array;
  /** 0 (gone) to 1 (there): less while it fades in or out. */
  readonly presence: number;
}

interface Moment {
  readonly time: number;
  readonly values2d: Float32Array;
  readonly values3d: Float32Array;
  readonly scores: Float32Array;
  /** When this stretch without a gap began, in seconds. */
  readonly since: number;
}

interface Difference {
  readonly at: number;
  readonly values2d: Float32Array;
  readonly values3d: Float32Array;
}

/**
 * The poses that live playback shows, over time. Newer stretches replace older ones, and what was on
 * screen is eased into them. Beyond the last pose it stays and fades away.
 */
export class LiveTrack {
  #moments: Moment[] = [];
  #difference: Difference | null = null;

  /**
   * Takes a stretch over from its first time on.
   * @param shown the time that is on screen now: what is shown from there on is to change smoothly
   */
  append(chunk: LiveChunk, shown: number): void {
    const { times } = chunk;
    const first = times[0];
    if (first === undefined) return;
    const at = Math.max(first, shown);
    const before = this.at(at);
    const solid = before !== null && before.presence === 1;
    // Fades in from where the fading out had come to.
    const since = solid ? this.#moments.at(-1)!.since : at - (before?.presence ?? 0) * FADE_SECONDS;
    this.#moments = this.#moments.filter(({ time }) => time < first && time > shown - KEPT_SECONDS);
    const sizes = [chunk.values2d, chunk.values3d, chunk.scores].map(
      (values) => values.length / times.length,
    ) as [number, number, number];
    times.forEach((time, t) => {
      const [values2d, values3d, scores] = [chunk.values2d, chunk.values3d, chunk.scores].map(
        (values, i) => values.subarray(t * sizes[i]!, (t + 1) * sizes[i]!),
      ) as [Float32Array, Float32Array, Float32Array];
      this.#moments.push({ time, values2d, values3d, scores, since });
    });
    this.#difference = null;
    const after = this.at(at);
    if (!before || !after || before.presence < EASED_FROM) return;
    this.#difference = {
      at,
      values2d: before.values2d.map((value, i) => value - after.values2d[i]!),
      values3d: before.values3d.map((value, i) => value - after.values3d[i]!),
    };
  }

  /** What to draw at a time in seconds; null where there is nothing, or nothing any more. */
  at(time: number): LivePose | null {
    const moments = this.#moments;
    const right = moments.findIndex((moment) => moment.time > time);
    const from = moments[right < 0 ? moments.length - 1 : right - 1];
    if (!from) return null;
    const to = right < 0 ? undefined : moments[right];
    // Over a gap nothing is made up: the pose before it stays, and fades.
    const between = to && to.since === from.since ? to : undefined;
    const stale = between ? 0 : Math.max(0, time - from.time);
    const presence =
      Math.min(1, Math.max(0, 1 - (stale - HOLD_SECONDS) / FADE_SECONDS)) *
      Math.min(1, Math.max(0, (time - from.since) / FADE_SECONDS));
    if (presence <= 0 && stale > 0) return null;
    const share = between ? (time - from.time) / (between.time - from.time) : 0;
    const eased = this.#difference ? easedShare(time - this.#difference.at) : 0;
    const mix = (key: 'values2d' | 'values3d') =>
      from[key].map((value, i) => {
        const plain = value + (between ? share * (between[key][i]! - value) : 0);
        return eased > 1e-4 ? plain + eased * this.#difference![key][i]! : plain;
      });
    const scores = from.scores.map((value, i) =>
      between ? value + share * (between.scores[i]! - value) : value,
    );
    return { values2d: mix('values2d'), values3d: mix('values3d'), scores, presence };
  }

  /** Poses that are kept. */
  get size(): number {
    return this.#moments.length;
  }

  clear(): void {
    this.#moments = [];
    this.#difference = null;
  }
}
