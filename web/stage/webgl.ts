import { WebGLRenderer } from 'three';
import { DeciWatchError } from '../errors.ts';

const MAX_PIXEL_RATIO = 2;

/** A renderer, and how many device pixels to a CSS pixel it should draw. */
export interface StageRenderer {
  readonly renderer: WebGLRenderer;
  readonly maxPixelRatio: number;
}

/**
 * Starts WebGL 2 on a new canvas. Where the browser warns that it would be slow (drawn in software), one
 * device pixel to a CSS pixel is all that is asked of it.
 * @throws DeciWatchError `browser-unsupported`
 */
export function createRenderer(): StageRenderer {
  const canvas = document.createElement('canvas');
  const options: WebGLContextAttributes = { antialias: true, alpha: true };
  const fast = canvas.getContext('webgl2', { ...options, failIfMajorPerformanceCaveat: true });
  const context = fast ?? canvas.getContext('webgl2', options);
  if (!context) {
    throw new DeciWatchError(
      'browser-unsupported',
      'The 3D view needs WebGL 2, which this browser has switched off or lacks; everything else on this page works without it.',
    );
  }
  return {
    renderer: new WebGLRenderer({ canvas, context, antialias: true, alpha: true }),
    maxPixelRatio: fast ? MAX_PIXEL_RATIO : 1,
  };
}
