/** A rectangle of a picture, in pixels; it may reach beyond the picture. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Width and height in pixels. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** How a part of a picture becomes a model's input: input = (picture − origin) × scale. */
export interface Crop {
  /** The input's top left corner, in pixels of the picture. */
  readonly x: number;
  readonly y: number;
  /** Pixels of the input for one of the picture, the same in x and y: nobody is stretched. */
  readonly scale: number;
}

/**
 * The smallest crop of the input's shape that holds a box, widened, about the box's middle.
 *
 * @param input the model's input in pixels
 * @param padding how many times as large as the box; models of single persons are trained with 1.25
 * @throws RangeError where the box has no extent
 */
export function cropTo(box: Box, input: Size, padding = 1): Crop {
  const scale = Math.min(input.width / box.width, input.height / box.height) / padding;
  if (!(box.width > 0 && box.height > 0 && scale > 0)) {
    throw new RangeError(`A box of ${box.width} × ${box.height} pixels cannot be cropped to.`);
  }
  return {
    x: box.x + box.width / 2 - input.width / 2 / scale,
    y: box.y + box.height / 2 - input.height / 2 / scale,
    scale,
  };
}

/** Points of the picture as points of the input. @param points any number of x, y in turn */
export function toInput(points: Float32Array, { x, y, scale }: Crop): Float32Array {
  return points.map((value, i) => (value - (i % 2 === 0 ? x : y)) * scale);
}

/** Points of the input as points of the picture: the inverse of {@link toInput}. */
export function toPicture(points: Float32Array, { x, y, scale }: Crop): Float32Array {
  return points.map((value, i) => value / scale + (i % 2 === 0 ? x : y));
}
