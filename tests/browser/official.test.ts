import { beforeAll, describe, expect, test } from 'vitest';
import { fetchModelManifest } from '../../web/recovery/manifest.ts';
import { fetchPair } from '../../web/recovery/net-pair.ts';
import { Recoverer } from '../../web/recovery/recoverer.ts';
import { type Matrix, Net } from '../../web/recovery/runtime.ts';
import cases from '../fixtures/official/cases.json';

/** onnxruntime-web adds up in another order than torch does. */
const TOLERANCE = 1e-4;

const OFFICIAL = { manifest: new URL('../fixtures/official/manifest.json', import.meta.url).href };

type Case = (typeof cases)['3d'];

function given({ data, dims }: Case[keyof Case]): Matrix {
  return { data: Float32Array.from(data), dims };
}

function expectEqual(actual: Matrix | undefined, { data, dims }: Case[keyof Case]) {
  expect(actual?.dims).toEqual(dims);
  const greatest = data.reduce((most, x, i) => Math.max(most, Math.abs(x - actual!.data[i]!)), 0);
  expect(greatest).toBeLessThan(TOLERANCE);
}

test('the page can load what import-official wrote', async () => {
  const recoverer = await Recoverer.load(OFFICIAL);
  await recoverer.dispose();
});

// 3D is pre-norm, 2D post-norm. Expected is torch's net with all frames masked but the samples.
describe.each(['3d', '2d'] as const)('imported %s nets', (name) => {
  let denoise: Net;
  let recover: Net;
  beforeAll(async () => {
    const { pairs } = await fetchModelManifest(OFFICIAL);
    const files = await fetchPair(OFFICIAL, pairs[name]);
    denoise = await Net.create(files.denoise);
    recover = await Net.create(files.recover);
    return () => Promise.all([denoise.dispose(), recover.dispose()]);
  });

  test('give what the net gives the way its authors run it', async () => {
    const one = cases[name];
    const sample_times = given(one.sample_times);
    const { clean, features } = await denoise.run({ sampled: given(one.sampled), sample_times });
    expectEqual(clean, one.clean);
    expectEqual(features, one.features);
    const frame_times = given(one.frame_times);
    const { poses } = await recover.run({
      clean: clean!,
      features: features!,
      sample_times,
      frame_times,
    });
    expectEqual(poses, one.poses);
  });
});
