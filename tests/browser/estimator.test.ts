import { afterAll, beforeAll, expect, test } from 'vitest';
import { fetchListed } from '../../web/download.ts';
import { engineFiles } from '../../web/engine/files.ts';
import type { SpatialEstimate } from '../../web/estimators/estimator.ts';
import { fetchEstimatorManifest } from '../../web/estimators/manifest.ts';
import { MediaPipeEstimator } from '../../web/estimators/mediapipe.ts';
import { openFile } from '../../web/sources/file.ts';
import { fixture, walk } from './fixtures.ts';

const { estimators: BUNDLES, mediapipe: FILES } = engineFiles();
const NOSE = 0;
const LEFT_HIP = 23;
const RIGHT_HIP = 24;
const LEFT_HEEL = 29;

let estimator: MediaPipeEstimator;
beforeAll(async () => {
  const { estimators } = await fetchEstimatorManifest(BUNDLES);
  const bundle = await fetchListed(BUNDLES, estimators.lite);
  const flops = estimators.lite.flops.perCall;
  estimator = await MediaPipeEstimator.create({ name: 'lite', flops, bundle, files: FILES });
});
afterAll(() => estimator.close());

async function estimateFrame(file: Blob, wanted: number): Promise<SpatialEstimate | null> {
  const clip = await openFile(file, 'clip');
  try {
    for await (const { image } of clip.frames([wanted])) {
      return await estimator.estimate(image);
    }
    throw new Error('no frame');
  } finally {
    clip.close();
  }
}

test('a person is found: pixels y down, metres y up about the mid-hip', async () => {
  const pose = (await estimateFrame(await walk(), 60))!;
  expect(pose.keypoints2d.length).toBe(33 * 2);
  expect(pose.keypoints3d.length).toBe(33 * 3);
  expect(pose.scores.length).toBe(33);
  expect(pose.scores.every((score) => score >= 0 && score <= 1)).toBe(true);

  const at = (values: Float32Array, joint: number, dims: number) =>
    Array.from(values.subarray(joint * dims, (joint + 1) * dims)) as [number, number, number];
  const [, nosePx] = at(pose.keypoints2d, NOSE, 2);
  const [, heelPx] = at(pose.keypoints2d, LEFT_HEEL, 2);
  // The person stands upright in a picture of 456 pixels' height.
  expect(nosePx).toBeGreaterThan(0);
  expect(heelPx).toBeGreaterThan(nosePx + 100);
  expect(heelPx).toBeLessThan(456);

  const [, nose] = at(pose.keypoints3d, NOSE, 3);
  const [, heel] = at(pose.keypoints3d, LEFT_HEEL, 3);
  expect(nose).toBeGreaterThan(0.4);
  expect(heel).toBeLessThan(-0.5);
  const left = at(pose.keypoints3d, LEFT_HIP, 3);
  const right = at(pose.keypoints3d, RIGHT_HIP, 3);
  for (let d = 0; d < 3; d++) expect(left[d]! + right[d]!).toBeCloseTo(0, 6);
});

test('in an empty room, nobody is found', async () => {
  expect(await estimateFrame(await fixture('empty-room.mp4'), 0)).toBeNull();
});
