import { addFeet, SOLE_M, verticalExtent } from './ground-level.ts';

/** Seconds in which the hip's height, the place of the feet and the stature follow what is seen. */
const HIP_S = 0.12;
const FEET_S = 2;
const STATURE_S = 4;

/**
 * Where somebody stands whose poses come one by one: the lowest joint on the ground, the feet in the
 * middle, all followed without haste. The streaming form of `estimateStanding`.
 */
export class LiveStanding {
  hipHeight = 0;
  feet: [x: number, z: number] = [0, 0];
  stature = 1.7;
  #last: number | null = null;

  /**
   * @param values K·3 metres relative to the mid-hip, y up
   * @param time seconds
   */
  follow(values: Float32Array, time: number): void {
    const [low, high] = verticalExtent(values);
    const feet = { x: 0, z: 0, count: 0 };
    addFeet(feet, values, low);
    const passed = this.#last === null ? Number.POSITIVE_INFINITY : Math.max(0, time - this.#last);
    this.#last = time;
    const share = (seconds: number) => 1 - Math.exp(-passed / seconds);
    this.hipHeight += share(HIP_S) * (SOLE_M - low - this.hipHeight);
    this.feet[0] += share(FEET_S) * (feet.x / feet.count - this.feet[0]);
    this.feet[1] += share(FEET_S) * (feet.z / feet.count - this.feet[1]);
    // Nobody is shorter for sitting down: it falls slowly.
    const stature = high - low;
    const rise = stature > this.stature ? share(HIP_S) : share(STATURE_S) / 4;
    this.stature += rise * (stature - this.stature);
  }

  /** Somebody else may come. */
  reset(): void {
    this.#last = null;
  }
}
