import * as ort from 'onnxruntime-web/wasm';
import { beforeAll, expect, test } from 'vitest';
import type { Box } from '../../web/estimators/crop.ts';
import {
  type OnnxEstimatorOptions,
  OnnxPoseEstimator,
} from '../../web/estimators/onnx-estimator.ts';
import { skeletonFrom } from '../../web/pose/skeleton.ts';
import { colourSession } from './fixtures.ts';

type Kind = 'heatmap' | 'simcc';
type Options = OnnxEstimatorOptions<ort.Tensor>;

const COLOURS = ['#ff0000', '#00ff00', '#0000ff'];
const SPOTS = skeletonFrom('spots', ['red', 'green', 'blue'], [[0, 1]]);

const sessions = {} as Record<Kind, ort.InferenceSession>;
beforeAll(async () => {
  for (const kind of ['heatmap', 'simcc'] as const) {
    sessions[kind] = await colourSession(kind);
  }
});

function colourFinder(kind: Kind, more: Partial<Options> = {}): OnnxPoseEstimator<ort.Tensor> {
  return new OnnxPoseEstimator({
    name: `colours-${kind}`,
    session: sessions[kind],
    Tensor: ort.Tensor,
    input: { width: 48, height: 64, mean: [0, 0, 0], std: [255, 255, 255] },
    decode: kind,
    skeleton: SPOTS,
    ...more,
  });
}

/** A grey picture with a spot of each colour about each place. */
function picture(width: number, height: number, places: readonly number[][], radius: number) {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#808080';
  context.fillRect(0, 0, width, height);
  places.forEach(([x, y], k) => {
    context.fillStyle = COLOURS[k]!;
    context.beginPath();
    context.arc(x!, y!, radius, 0, 2 * Math.PI);
    context.fill();
  });
  return canvas;
}

const PLACES = [
  [150, 200],
  [300, 340],
  [310, 90],
];

/** The furthest that a keypoint is from its spot, in pixels of the picture. */
function furthest(found: Float32Array, places: readonly number[][]): number {
  return Math.max(
    ...places.map(([x, y], k) => Math.hypot(found[k * 2]! - x!, found[k * 2 + 1]! - y!)),
  );
}

test.each<[Kind, number]>([
  // A shift by a quarter leaves up to that much of a cell's four pixels in x and in y; a bin is half a pixel.
  ['heatmap', 1.5],
  ['simcc', 0.4],
])('a %s model finds each spot in the whole picture', async (kind, inputPixels) => {
  const image = picture(450, 600, PLACES, 40);
  const answer = (await colourFinder(kind).estimate(image, 0))!;
  expect(furthest(answer.keypoints2d, PLACES)).toBeLessThan((inputPixels * 600) / 64);
  expect(answer.keypoints3d).toBeNull();
  expect(answer.scores.every((score) => score > 0.3 && score <= 1)).toBe(true);
});

test('the crop to a box finds more exactly, beyond the picture too', async () => {
  // Spots of 6 pixels by the left border: in the whole picture, less than one of the model's.
  const near = PLACES.map(([x, y]) => [(x! - 150) / 5 + 4, y! / 5 + 200]);
  const image = picture(450, 600, near, 5);
  const box: Box = { x: -15, y: 200, width: 60, height: 80 };
  const answer = (await colourFinder('simcc', { findPerson: () => box }).estimate(image, 0))!;
  expect(furthest(answer.keypoints2d, near)).toBeLessThan((0.4 * 1.25 * 80) / 64);
  const tight = colourFinder('heatmap', { findPerson: async () => box, padding: 1 });
  const closer = (await tight.estimate(image, 0))!;
  expect(furthest(closer.keypoints2d, near)).toBeLessThan((1.5 * 80) / 64);
});

test('a bitmap and a VideoFrame are looked at like a canvas, and stay open', async () => {
  const canvas = picture(450, 600, PLACES, 40);
  const estimator = colourFinder('heatmap');
  const expected = await estimator.estimate(canvas, 0);
  const bitmap = await createImageBitmap(canvas);
  expect(await estimator.estimate(bitmap, 0)).toEqual(expected);
  expect(bitmap.width).toBe(450);
  bitmap.close();
  const frame = new VideoFrame(canvas, { timestamp: 0 });
  const seen = (await estimator.estimate(frame, 0))!;
  expect(furthest(seen.keypoints2d, PLACES)).toBeLessThan(20);
  expect(frame.codedWidth).toBe(450);
  frame.close();
});

test('where there is no colour, or no person, nobody is seen', async () => {
  const grey = picture(450, 600, [], 0);
  expect(await colourFinder('heatmap').estimate(grey, 0)).toBeNull();
  expect(await colourFinder('simcc').estimate(grey, 0)).toBeNull();
  const spots = picture(450, 600, PLACES, 40);
  expect(await colourFinder('heatmap', { findPerson: () => null }).estimate(spots, 0)).toBeNull();
  // One of three spots is missing: a mean of two thirds.
  const two = picture(450, 600, PLACES.slice(0, 2), 40);
  expect(await colourFinder('heatmap', { leastScore: 0.7 }).estimate(two, 0)).toBeNull();
  expect(await colourFinder('heatmap', { leastScore: 0.6 }).estimate(two, 0)).not.toBeNull();
  expect(await colourFinder('heatmap', { leastScore: 0 }).estimate(grey, 0)).not.toBeNull();
});

test('colours in the other order are other keypoints', async () => {
  const image = picture(450, 600, PLACES, 40);
  const input = { width: 48, height: 64, std: [255, 255, 255], mean: [0, 0, 0] } as const;
  const swapped = colourFinder('simcc', { input: { ...input, order: 'bgr' } });
  const answer = (await swapped.estimate(image, 0))!;
  expect(furthest(answer.keypoints2d, PLACES.toReversed())).toBeLessThan(10);
});

test('a model that does not fit what was said of it is told by its shape', async () => {
  const image = picture(48, 64, [], 0);
  const coarse = skeletonFrom('two', ['a', 'b'], []);
  await expect(colourFinder('heatmap', { skeleton: coarse }).estimate(image, 0)).rejects.toThrow(
    'the output heatmaps should be [1, 2, ?, ?], but is [1, 3, 16, 12]',
  );
  await expect(colourFinder('simcc', { decode: 'heatmap' }).estimate(image, 0)).rejects.toThrow(
    'simcc_x should be [1, 3, ?, ?]',
  );
  await expect(colourFinder('heatmap', { outputs: ['maps'] }).estimate(image, 0)).rejects.toThrow(
    'the model has no output maps (its outputs are heatmaps)',
  );
});
