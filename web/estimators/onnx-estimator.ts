import type { Skeleton } from '../pose/skeleton.ts';
import { type Box, cropTo, type Size, toPicture } from './crop.ts';
import type { EstimatorImage, PoseEstimate, PoseEstimator } from './estimator.ts';
import { decodeHeatmaps } from './heatmap.ts';
import { imageSize } from './image-size.ts';
import { IMAGENET_MEAN, IMAGENET_STD, type InputFormat, inputValues } from './input-values.ts';
import type { DecodedKeypoints } from './peak.ts';
import { decodeSimcc } from './simcc.ts';

/** What is used of an onnxruntime-web `Tensor`. */
export interface OnnxTensor {
  readonly data: unknown;
  readonly dims: readonly number[];
  dispose?(): void;
}

/** What is used of an onnxruntime-web `InferenceSession`. */
export interface OnnxSession<TTensor extends OnnxTensor> {
  run(feeds: Record<string, TTensor>): Promise<Readonly<Record<string, OnnxTensor>>>;
}

/** onnxruntime-web's `Tensor` class. */
export type OnnxTensorClass<TTensor extends OnnxTensor> = new (
  type: 'float32',
  data: Float32Array,
  dims: readonly number[],
) => TTensor;

/** A model's input: one picture of a fixed size, float32. */
export interface OnnxInput extends Size, Partial<InputFormat> {
  /** Its name in the graph; `input` unless given. */
  readonly name?: string;
}

/** A person's box in pixels of the picture, or null where nobody is in it. */
export type FindPerson = (
  image: EstimatorImage,
  timeMs: number,
) => Promise<Box | null> | Box | null;

/** What an {@link OnnxPoseEstimator} is made of. */
export interface OnnxEstimatorOptions<TTensor extends OnnxTensor> {
  /** What to call it, in files and errors. */
  readonly name: string;
  /** Stays the caller's to release. Its outputs must come to the CPU, as they do by default. */
  readonly session: OnnxSession<TTensor>;
  /** `ort.Tensor`. */
  readonly Tensor: OnnxTensorClass<TTensor>;
  /** Without a format: ImageNet's mean and deviation, RGB, NCHW. */
  readonly input: OnnxInput;
  /**
   * What the model gives. `heatmap`: [1,K,H,W]. `simcc`: [1,K,Wx] and [1,K,Wy].
   */
  readonly decode: 'heatmap' | 'simcc';
  /** SimCC's bins for each pixel of the input; 2 unless given. */
  readonly splitRatio?: number;
  /** The outputs' names: the heatmaps', or x's and y's; the graph's first ones unless given. */
  readonly outputs?: readonly string[];
  /** The K joints, in the order of the model's outputs. */
  readonly skeleton: Skeleton;
  /** FLOPs of one call, a detector's included; 0, not known, unless given. */
  readonly flops?: number;
  /** Finds the one person to look at; unless given, the model is shown the whole picture. */
  readonly findPerson?: FindPerson;
  /** How many times as large as the box the crop is; 1.25 unless given. The whole picture is not widened. */
  readonly padding?: number;
  /** A mean score below this means that nobody is there; 0.3 unless given. */
  readonly leastScore?: number;
}

const DEFAULTS = { splitRatio: 2, flops: 0, padding: 1.25, leastScore: 0.3 };
const DEFAULT_INPUT = {
  name: 'input',
  mean: IMAGENET_MEAN,
  std: IMAGENET_STD,
  order: 'rgb',
  layout: 'nchw',
} as const;

/**
 * Any ONNX model of one person that gives heatmaps or SimCC's distributions: crops to the person, runs
 * the model, finds the peaks. It knows no depth.
 *
 * onnxruntime-web is not among its imports: the session comes from whoever uses it.
 */
export class OnnxPoseEstimator<TTensor extends OnnxTensor> implements PoseEstimator {
  readonly name: string;
  readonly skeleton: Skeleton;
  readonly flops: number;
  readonly #options: OnnxEstimatorOptions<TTensor> & typeof DEFAULTS;
  readonly #input: Required<OnnxInput>;
  readonly #context: OffscreenCanvasRenderingContext2D;

  constructor(options: OnnxEstimatorOptions<TTensor>) {
    const given = Object.entries(options).filter(([, value]) => value !== undefined);
    this.#options = { ...DEFAULTS, ...(Object.fromEntries(given) as typeof options) };
    this.#input = { ...DEFAULT_INPUT, ...options.input };
    this.name = options.name;
    this.skeleton = options.skeleton;
    this.flops = this.#options.flops;
    const canvas = new OffscreenCanvas(this.#input.width, this.#input.height);
    // Without alpha it is black where the crop reaches beyond the picture.
    const context = canvas.getContext('2d', { alpha: false, willReadFrequently: true });
    if (!context)
      throw new Error(`There is no canvas of ${canvas.width} × ${canvas.height} pixels.`);
    this.#context = context;
  }

  /** @throws Error where the model's outputs do not fit the skeleton and the way of decoding */
  async estimate(image: EstimatorImage, timeMs: number): Promise<PoseEstimate | null> {
    const { findPerson, padding, leastScore } = this.#options;
    const box = findPerson ? await findPerson(image, timeMs) : { x: 0, y: 0, ...imageSize(image) };
    if (!box) return null;
    const crop = cropTo(box, this.#input, findPerson ? padding : 1);
    const context = this.#context;
    context.resetTransform();
    context.clearRect(0, 0, this.#input.width, this.#input.height);
    context.setTransform(crop.scale, 0, 0, crop.scale, -crop.x * crop.scale, -crop.y * crop.scale);
    context.drawImage(image, 0, 0);
    const { positions, scores } = await this.#run();
    const clamped = scores.map((score) => Math.min(1, Math.max(0, score)));
    const mean = clamped.reduce((sum, score) => sum + score, 0) / clamped.length;
    if (!(mean >= leastScore)) return null;
    // A model's place 0 is the middle of its first pixel, which reaches from 0 to 1.
    const keypoints2d = toPicture(
      positions.map((at) => at + 0.5),
      crop,
    );
    return { keypoints2d, keypoints3d: null, scores: clamped };
  }

  /** The session stays open: it is whoever's made it. */
  close(): void {}

  /** Runs the model on what is drawn: positions as indices of its input's pixels. */
  async #run(): Promise<DecodedKeypoints> {
    const { session, Tensor } = this.#options;
    const { name, width, height, layout } = this.#input;
    const { data } = this.#context.getImageData(0, 0, width, height);
    const dims = layout === 'nchw' ? [1, 3, height, width] : [1, height, width, 3];
    const tensor = new Tensor('float32', inputValues(data, this.#input), dims);
    const outputs = await session.run({ [name]: tensor });
    try {
      return this.#decode(outputs);
    } finally {
      for (const used of [tensor, ...Object.values(outputs)]) used.dispose?.();
    }
  }

  #decode(outputs: Readonly<Record<string, OnnxTensor>>): DecodedKeypoints {
    const { decode, splitRatio, outputs: names = Object.keys(outputs), skeleton } = this.#options;
    const keypoints = skeleton.joints.length;
    if (decode === 'simcc') {
      const [x, y] = [0, 1].map((i) => floats(outputs, names[i], [1, keypoints, null]));
      return decodeSimcc(x!.data, y!.data, keypoints, splitRatio);
    }
    const { data, dims } = floats(outputs, names[0], [1, keypoints, null, null]);
    const [height, width] = dims.slice(2) as [number, number];
    const { positions, scores } = decodeHeatmaps(data, { keypoints, width, height });
    const stride = [this.#input.width / width, this.#input.height / height];
    return { positions: positions.map((cell, i) => cell * stride[i % 2]!), scores };
  }
}

/** An output that has the shape wanted; null there stands for any length. */
function floats(
  outputs: Readonly<Record<string, OnnxTensor>>,
  name: string | undefined,
  shape: readonly (number | null)[],
): { data: Float32Array; dims: readonly number[] } {
  const tensor = name === undefined ? undefined : outputs[name];
  if (!tensor) {
    const known = Object.keys(outputs).join(', ');
    throw new Error(`the model has no output ${name ?? 'left'} (its outputs are ${known})`);
  }
  const { data, dims } = tensor;
  const fits =
    dims.length === shape.length && shape.every((want, i) => want === null || want === dims[i]);
  if (!fits) {
    const wanted = shape.map((length) => length ?? '?').join(', ');
    throw new Error(`the output ${name} should be [${wanted}], but is [${dims.join(', ')}]`);
  }
  if (!(data instanceof Float32Array)) throw new Error(`the output ${name} is not float32`);
  return { data, dims };
}
