import { frameAtTime } from './sequence.ts';
import { InterpolatingSpline } from './spline.ts';

/** The classical ways to fill in frames, from the plainest to the smoothest. */
export const INTERPOLATION_KINDS = ['nearest', 'linear', 'quadratic', 'cubic'] as const;

/** One of {@link INTERPOLATION_KINDS}. */
export type InterpolationKind = (typeof INTERPOLATION_KINDS)[number];

/**
 * Interpolates C channels over time, as SciPy's `interp1d` of the same kind does. Before the first
 * and after the last sample the end value holds. Too few samples for a kind: the highest degree
 * that they allow (cubic needs 4, quadratic 3, linear 2).
 *
 * @param kind `nearest`, `linear`, `quadratic` or `cubic`
 * @param times S sample times, strictly increasing, spaced as they like
 * @param values S·C finite values: leave out samples in which nobody was seen
 * @param queries T times, in any order
 * @returns T·C values, in the same kind of array as `values`
 * @throws RangeError where there is no sample, or the values are not C for each
 * @see https://docs.scipy.org/doc/scipy/reference/generated/scipy.interpolate.interp1d.html
 */
export function interpolate<V extends Float32Array | Float64Array>(
  kind: InterpolationKind,
  times: Float64Array,
  values: V,
  queries: Float64Array,
): V {
  const samples = times.length;
  const channels = values.length / samples;
  if (samples === 0 || !Number.isInteger(channels)) {
    throw new RangeError(`${values.length} values cannot be spread over ${samples} sample times.`);
  }
  const write = writerFor(Math.min(INTERPOLATION_KINDS.indexOf(kind), samples - 1), times, values);
  const length = queries.length * channels;
  const out = values instanceof Float32Array ? new Float32Array(length) : new Float64Array(length);
  const last = times[samples - 1]!;
  queries.forEach((query, t) => {
    write(Math.min(Math.max(query, times[0]!), last), out, t * channels);
  });
  return out as V;
}

/** Writes the C values at a time within the samples into `out` from `offset` on. */
type Writer = (time: number, out: Float32Array | Float64Array, offset: number) => void;

function writerFor(degree: number, times: Float64Array, values: ArrayLike<number>): Writer {
  if (degree === 0) return nearestWriter(times, values);
  if (degree === 1) return linearWriter(times, values);
  const spline = new InterpolatingSpline(degree === 2 ? 2 : 3, times, values);
  return (time, out, offset) => spline.evaluate(time, out, offset);
}

function nearestWriter(times: Float64Array, values: ArrayLike<number>): Writer {
  const channels = values.length / times.length;
  return (time, out, offset) => {
    const left = frameAtTime(times, time);
    // Half way between two samples the earlier one counts, as in SciPy.
    const isLeft = left === times.length - 1 || time <= times[left]! / 2 + times[left + 1]! / 2;
    const from = (isLeft ? left : left + 1) * channels;
    for (let c = 0; c < channels; c++) out[offset + c] = values[from + c]!;
  };
}

function linearWriter(times: Float64Array, values: ArrayLike<number>): Writer {
  const channels = values.length / times.length;
  return (time, out, offset) => {
    const left = Math.min(frameAtTime(times, time), times.length - 2);
    const share = (time - times[left]!) / (times[left + 1]! - times[left]!);
    for (let c = 0; c < channels; c++) {
      const a = values[left * channels + c]!;
      out[offset + c] = a + share * (values[(left + 1) * channels + c]! - a);
    }
  };
}
