import { WebGLRenderer } from 'three';
import { DeciWatchError } from '../errors.ts';

const MAX_PIXEL_RATIO = 2;
/** Instead of smooth edges, which cost more. */
const SOFTWARE_PIXEL_RATIO = 1.5;
const SOFTWARE_LIVE_PIXEL_RATIO = 0.7;

/** A renderer, and what is to be asked of it. */
export interface StageRenderer {
  readonly renderer: WebGLRenderer;
  /** Device pixels to a CSS pixel. */
  readonly maxPixelRatio: number;
  /** The same while poses come live, thirty a second. */
  readonly livePixelRatio: number;
  /** Pictures are drawn by the processor: each costs some milliseconds of it. */
  readonly software: boolean;
}

/**
 * Starts WebGL 2 on a new canvas. Where the browser warns that it would be slow (drawn in software), one
 * device pixel to a CSS pixel is all that is asked of it.
 * @throws DeciWatchError `webgl-unavailable`
 */
export function createRenderer(): StageRenderer {
  const canvas = document.createElement('canvas');
  const options: WebGLContextAttributes = { antialias: true, alpha: true };
  const fast = canvas.getContext('webgl2', { ...options, failIfMajorPerformanceCaveat: true });
  // In software four samples a pixel take four times as long.
  const context = fast ?? canvas.getContext('webgl2', { ...options, antialias: false });
  if (!context) {
    throw new DeciWatchError(
      'webgl-unavailable',
      'The 3D view needs WebGL 2, which this browser has switched off or lacks; everything else works without it.',
    );
  }
  return {
    renderer: new WebGLRenderer({ canvas, context, antialias: fast !== null, alpha: true }),
    maxPixelRatio: fast ? MAX_PIXEL_RATIO : SOFTWARE_PIXEL_RATIO,
    livePixelRatio: fast ? MAX_PIXEL_RATIO : SOFTWARE_LIVE_PIXEL_RATIO,
    software: !fast,
  };
}
