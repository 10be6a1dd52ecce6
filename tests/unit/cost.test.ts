import { expect, it } from 'vitest';
import { type FlopsPolynomial, netFlops } from '../../web/cost/flops.ts';
import { CostMeter } from '../../web/cost/meter.ts';
import { readFixture, readJson } from './fixture.ts';

it('evaluates the FLOPs polynomial of the manifest', () => {
  const polynomial = { '1': 7, S: 11, SS: 13, T: 17, ST: 19, TT: 23 };
  expect(netFlops(polynomial, 2, 3)).toBe(7 + 22 + 52 + 51 + 114 + 207);
  expect(netFlops(polynomial, 0, 0)).toBe(7);
});

it("agrees with the FLOPs counted in the nets' graphs", () => {
  type Net = 'denoise' | 'recover' | 'forecast';
  type Counted = Record<'samples' | 'frames' | Net, number>;
  type Manifest = { pairs: Record<string, Record<Net, { flops: FlopsPolynomial }>> };
  const { pairs } = readFixture<{ pairs: Record<string, Counted[]> }>('flops.json');
  const manifest = readJson<Manifest>('public/models/manifest.json');
  expect(Object.keys(pairs).toSorted()).toEqual(Object.keys(manifest.pairs).toSorted());
  for (const [name, calls] of Object.entries(pairs)) {
    const { denoise, recover, forecast } = manifest.pairs[name]!;
    expect(calls.length).toBeGreaterThan(6);
    for (const call of calls) {
      expect(netFlops(denoise.flops, call.samples, call.frames)).toBe(call.denoise);
      expect(netFlops(recover.flops, call.samples, call.frames)).toBe(call.recover);
      expect(netFlops(forecast.flops, call.samples, call.frames)).toBe(call.forecast);
    }
  }
});

it('gives equation 5 of the paper where its assumptions hold', () => {
  // T = 100, N = 10, f(E) = 4.14 GFLOP, f(D) + f(R) = 0.7 MFLOP per frame: 0.414 + 0.0007 GFLOP.
  const meter = new CostMeter(4.14e9);
  for (let call = 0; call < 10; call++) meter.addEstimatorCall(30);
  meter.addDenoise(100 * 0.2e6, 8);
  meter.addRecover(100 * 0.5e6, 12);
  const { flopsPerFrame, flopsRatio, everyFrameFlopsPerFrame } = meter.report(100, 500);
  expect(flopsPerFrame.estimator).toBeCloseTo(0.414e9, 3);
  expect(flopsPerFrame.denoise).toBeCloseTo(0.2e6, 3);
  expect(flopsPerFrame.recover).toBeCloseTo(0.5e6, 3);
  expect(flopsPerFrame.total).toBeCloseTo(0.4147e9, 3);
  expect(everyFrameFlopsPerFrame).toBe(4.14e9);
  expect(flopsRatio).toBeCloseTo(0.100169, 6);
});

it('counts the extra last frame and windows that overlap', () => {
  // 22 frames at N = 10 watch 0, 10, 20 and 21; two windows are each denoised and recovered.
  const meter = new CostMeter(1000);
  for (let call = 0; call < 4; call++) meter.addEstimatorCall(5 + call);
  for (const scale of [1, 2]) {
    meter.addDenoise(110 * scale, 1.1);
    meter.addRecover(220 * scale, 2.2);
  }
  meter.addDecode(33);
  meter.addDecode(11);
  const report = meter.report(22, 99);
  expect(report.estimatorCalls).toBe(4);
  expect(report.flopsPerFrame.estimator).toBeCloseTo(4000 / 22, 9);
  expect(report.flopsPerFrame.denoise).toBeCloseTo(15, 9);
  expect(report.flopsPerFrame.recover).toBeCloseTo(30, 9);
  expect(report.flopsRatio).toBeCloseTo((4000 / 22 + 45) / 1000, 9);
  expect(report.msPerEstimatorCall).toBe(6.5);
  expect(report.msPerFrame.decode).toBe(2);
  expect(report.msPerFrame.total).toBeCloseTo((26 + 2.2 + 4.4 + 44) / 22, 9);
  expect(report).toMatchObject({ frames: 22, wallMs: 99 });
});

it('reports no time for calls that were not made', () => {
  const report = new CostMeter(1000).report(5, 1);
  expect(report.msPerEstimatorCall).toBe(0);
  expect(report.flopsPerFrame.total).toBe(0);
});

it('has no ratio where the FLOPs of a look are not known, and nothing that is no number', () => {
  const meter = new CostMeter(0);
  meter.addEstimatorCall(30);
  meter.addRecover(5e6, 2);
  const report = meter.report(10, 50);
  expect(report.flopsRatio).toBeNull();
  expect(report.everyFrameFlopsPerFrame).toBe(0);
  expect(report.flopsPerFrame).toEqual({ estimator: 0, denoise: 0, recover: 5e5, total: 5e5 });
});
