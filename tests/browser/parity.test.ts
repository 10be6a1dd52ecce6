import { beforeAll, describe, expect, test } from 'vitest';
import { fetchListed } from '../../web/download.ts';
import { engineFiles } from '../../web/engine/files.ts';
import { fetchModelManifest, type ModelManifest } from '../../web/recovery/manifest.ts';
import { fetchPair, NetPair } from '../../web/recovery/net-pair.ts';
import { Net } from '../../web/recovery/runtime.ts';
import inputs from '../fixtures/inputs.json';
import parity2d from '../fixtures/parity-2d.json';
import parity3d from '../fixtures/parity-3d.json';

/** onnxruntime-web adds up in another order than torch does. */
const TOLERANCE = 1e-4;

const { models: MODELS } = engineFiles();

type Case = (typeof parity3d.cases)[number];
type Name = keyof Case['shapes'];

let manifest: ModelManifest;
beforeAll(async () => {
  manifest = await fetchModelManifest(MODELS);
});

function given(from: Case, name: Name) {
  return { data: Float32Array.from(from[name]), dims: from.shapes[name] };
}

function greatestDifference(actual: Float32Array, expected: readonly number[]): number {
  expect(actual.length).toBe(expected.length);
  return expected.reduce((most, value, i) => Math.max(most, Math.abs(value - actual[i]!)), 0);
}

describe.each([
  ['3d', parity3d],
  ['2d', parity2d],
] as const)('the %s nets give what torch gave', (name, { cases }) => {
  let denoise: Net;
  let recover: Net;
  let forecast: Net;
  beforeAll(async () => {
    const pair = manifest.pairs[name];
    denoise = await Net.create(await fetchListed(MODELS, pair.denoise));
    recover = await Net.create(await fetchListed(MODELS, pair.recover));
    forecast = await Net.create(await fetchListed(MODELS, pair.forecast!));
    return () => Promise.all([denoise.dispose(), recover.dispose(), forecast.dispose()]);
  });

  test.each<Case>(cases)('$name: S = $samples, T = $frames', async (one) => {
    const { clean, features } = await denoise.run({
      sampled: given(one, 'sampled'),
      sample_times: given(one, 'sampleTimes'),
    });
    expect(greatestDifference(clean!.data, one.clean)).toBeLessThan(TOLERANCE);
    expect(greatestDifference(features!.data, one.features)).toBeLessThan(TOLERANCE);
    expect(features!.dims).toEqual(one.shapes.features);
    const { poses } = await recover.run({
      clean: clean!,
      features: features!,
      sample_times: given(one, 'sampleTimes'),
      frame_times: given(one, 'frameTimes'),
    });
    expect(poses!.dims).toEqual(one.shapes.poses);
    expect(greatestDifference(poses!.data, one.poses)).toBeLessThan(TOLERANCE);
    const ahead = await forecast.run({
      sampled: given(one, 'sampled'),
      sample_times: given(one, 'sampleTimes'),
      frame_times: given(one, 'aheadTimes'),
    });
    expect(greatestDifference(ahead.poses!.data, one.forecast)).toBeLessThan(TOLERANCE);
  });

  test('runs that are asked for at once wait for one another', async () => {
    const one = cases[0]! as Case;
    const inputs = { sampled: given(one, 'sampled'), sample_times: given(one, 'sampleTimes') };
    const [first, second] = await Promise.all([denoise.run(inputs), denoise.run(inputs)]);
    expect(second!.clean!.data).toEqual(first!.clean!.data);
  });
});

describe.each(['3d', '2d'] as const)('from estimates to %s poses with every input', (name) => {
  let pair: NetPair;
  beforeAll(async () => {
    const set = { manifest: new URL('../fixtures/models/manifest.json', import.meta.url).href };
    const entry = (await fetchModelManifest(set)).pairs[name];
    expect([...entry.inputs].sort()).toEqual(['2d', '3d', 'scores']);
    pair = await NetPair.create(entry, await fetchPair(set, entry));
    return () => pair.dispose();
  });

  test.each(inputs.cases)('$name', async (one) => {
    const part = (values: readonly number[], s: number) => {
      const size = values.length / one.sampleTimes.length;
      return Float32Array.from(values.slice(s * size, (s + 1) * size));
    };
    const { poses } = await pair.run({
      samples: one.sampleTimes.map((_, s) => ({
        keypoints2d: part(one.keypoints2d, s),
        keypoints3d: part(one.keypoints3d, s),
        scores: part(one.scores, s),
      })),
      sampleTimes: Float64Array.from(one.sampleTimes),
      frameTimes: Float64Array.from(one.frameTimes),
    });
    // The person is about 500 px high, which is the 1 of the 2D nets.
    const [expected, unit] = name === '3d' ? [one.poses3d, 0.5] : [one.poses2d, 500];
    expect(greatestDifference(poses, expected)).toBeLessThan(unit * TOLERANCE);
  });
});
