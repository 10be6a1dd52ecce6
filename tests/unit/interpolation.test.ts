import { describe, expect, it } from 'vitest';
import {
  INTERPOLATION_KINDS,
  type InterpolationKind,
  interpolate,
} from '../../web/pose/interpolation.ts';
import { readFixture } from './fixture.ts';

const times = Float64Array.of(0, 0.3, 0.7, 1, 1.5, 1.6, 2.4);
const values = Float64Array.of(3, -1, 4, -1, 5, -9, 2);

/** Samples [S][C] at times [S], and what SciPy's interp1d makes of them at queries [T]: [T][C]. */
interface Case {
  readonly name: string;
  readonly times: number[];
  readonly values: number[][];
  readonly queries: number[];
  readonly results: Partial<Record<InterpolationKind, number[][]>>;
}

const { cases } = readFixture<{ cases: Case[] }>('interpolation.json');

describe('equals SciPy', () => {
  it.each(cases)('through $name samples', ({ results, ...samples }) => {
    const [sampleTimes, sampleValues, queries] = [
      Float64Array.from(samples.times),
      Float64Array.from(samples.values.flat()),
      Float64Array.from(samples.queries),
    ];
    const kinds = INTERPOLATION_KINDS.filter((kind) => results[kind]);
    expect(kinds).toHaveLength(Math.min(4, samples.times.length));
    for (const kind of kinds) {
      const found = interpolate(kind, sampleTimes, sampleValues, queries);
      const expected = results[kind]!.flat();
      const errors = expected.map((value, i) => Math.abs(value - found[i]!));
      expect(found).toHaveLength(expected.length);
      expect(Math.max(...errors), kind).toBeLessThan(1e-8);
    }
  });
});

it('holds the end values outside the samples', () => {
  for (const kind of INTERPOLATION_KINDS) {
    expect([...interpolate(kind, times, values, Float64Array.of(9, -1))]).toEqual([
      expect.closeTo(2, 10),
      expect.closeTo(3, 10),
    ]);
  }
});

it('takes the earlier sample half way between two', () => {
  expect([...interpolate('nearest', times, values, Float64Array.of(0.15, 0.1501))]).toEqual([
    3, -1,
  ]);
});

it('passes through the samples, and reproduces polynomials of its degree', () => {
  const degrees = { nearest: 0, linear: 1, quadratic: 2, cubic: 3 };
  const queries = Float64Array.from({ length: 49 }, (_, i) => i / 20);
  for (const kind of INTERPOLATION_KINDS) {
    const through = interpolate(kind, times, values, times);
    values.forEach((value, i) => {
      expect(through[i]).toBeCloseTo(value, 10);
    });
    const curve = (time: number) => 2 - (time - 1) ** degrees[kind];
    const found = interpolate(kind, times, times.map(curve), queries);
    queries.forEach((time, i) => {
      expect(found[i], `${kind} at ${time}`).toBeCloseTo(curve(Math.min(time, 2.4)), 10);
    });
  }
});

it('falls to the highest degree that the samples allow', () => {
  const queries = Float64Array.of(0.1, 0.45, 0.9);
  const of = (kind: (typeof INTERPOLATION_KINDS)[number], samples: number) =>
    interpolate(kind, times.subarray(0, samples), values.subarray(0, samples), queries);
  expect(of('cubic', 3)).toEqual(of('quadratic', 3));
  expect(of('quadratic', 2)).toEqual(of('linear', 2));
  expect([...of('cubic', 1)]).toEqual([3, 3, 3]);
});

it('keeps channels apart and the kind of array', () => {
  const two = Float32Array.from([...values].flatMap((value) => [value, -2 * value]));
  for (const kind of INTERPOLATION_KINDS) {
    const found = interpolate(kind, times, two, Float64Array.of(0.2, 2));
    const alone = interpolate(kind, times, values, Float64Array.of(0.2, 2));
    expect(found).toBeInstanceOf(Float32Array);
    expect(found).toEqual(Float32Array.of(alone[0]!, -2 * alone[0]!, alone[1]!, -2 * alone[1]!));
  }
});

it('refuses values that do not fit the times', () => {
  expect(() => interpolate('linear', times, values.subarray(1), times)).toThrow(RangeError);
  expect(() => interpolate('linear', times.subarray(7), values, times)).toThrow(RangeError);
});
