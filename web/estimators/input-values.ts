/** How a picture becomes the numbers that a model takes. */
export interface InputFormat {
  /** Taken off each channel, which goes from 0 to 255; red, green, blue. */
  readonly mean: readonly [number, number, number];
  /** What is left is divided by this; red, green, blue. */
  readonly std: readonly [number, number, number];
  /** The order of the channels in the model's input. */
  readonly order: 'rgb' | 'bgr';
  /** Channels one after another, or side by side in each pixel. */
  readonly layout: 'nchw' | 'nhwc';
}

/** ImageNet's mean of red, green and blue, 0 to 255, which most pose models are trained with. */
export const IMAGENET_MEAN = [123.675, 116.28, 103.53] as const;

/** ImageNet's deviation of red, green and blue, of channels from 0 to 255. */
export const IMAGENET_STD = [58.395, 57.12, 57.375] as const;

/**
 * The values of a model's input.
 * @param rgba H·W·4 bytes; the fourth of each pixel is left out
 * @returns 3·H·W values
 */
export function inputValues(
  rgba: Uint8ClampedArray,
  { mean, std, order, layout }: InputFormat,
): Float32Array {
  const pixels = rgba.length / 4;
  const values = new Float32Array(3 * pixels);
  for (let colour = 0; colour < 3; colour++) {
    const channel = order === 'rgb' ? colour : 2 - colour;
    const [start, step] = layout === 'nchw' ? [channel * pixels, 1] : [channel, 3];
    const less = mean[colour]!;
    const by = std[colour]!;
    for (let i = 0; i < pixels; i++) {
      values[start + i * step] = (rgba[i * 4 + colour]! - less) / by;
    }
  }
  return values;
}
