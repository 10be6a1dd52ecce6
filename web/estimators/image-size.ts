import type { EstimatorImage } from './estimator.ts';

/** Pixels of an image as it is displayed. */
export function imageSize(image: EstimatorImage): { width: number; height: number } {
  if ('displayWidth' in image) return { width: image.displayWidth, height: image.displayHeight };
  return { width: image.width, height: image.height };
}
