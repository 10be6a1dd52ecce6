/** A rectangle in CSS pixels. */
export interface Rect {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Where `object-fit: contain` puts a picture in a box.
 * @param box width and height in CSS pixels
 * @param picture width and height, in any unit
 */
export function containedRect(
  box: Pick<Rect, 'width' | 'height'>,
  picture: Pick<Rect, 'width' | 'height'>,
): Rect {
  const scale = Math.min(box.width / picture.width, box.height / picture.height);
  const width = picture.width * scale;
  const height = picture.height * scale;
  return { x: (box.width - width) / 2, y: (box.height - height) / 2, width, height };
}
