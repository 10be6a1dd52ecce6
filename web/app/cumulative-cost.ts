import type { RecoveredClip } from '../engine/types.ts';

/** FLOPs up to and including a frame. */
export interface CumulativeFlops {
  readonly spent: number;
  /** What the estimator would have cost on every frame so far. */
  readonly everyFrame: number;
  /** Frames that the estimator looked at so far. */
  readonly calls: number;
}

/**
 * Counts what a clip had cost up to each of its frames: the estimator where it looked, the two nets
 * evenly over all frames.
 * @returns a function of the frame, from 0
 */
export function cumulativeFlops(clip: RecoveredClip): (frame: number) => CumulativeFlops {
  const { watched } = clip.poses2d;
  const { estimatorCalls, everyFrameFlopsPerFrame, flopsPerFrame } = clip.cost;
  const calls = new Uint32Array(watched.length);
  let sum = 0;
  for (let frame = 0; frame < watched.length; frame++) {
    sum += watched[frame]!;
    calls[frame] = sum;
  }
  return (frame) => {
    const last = Math.min(Math.max(frame, 0), watched.length - 1);
    const frames = last + 1;
    // The meter's own count at the end, so that the counter closes on the report's figure.
    const soFar = last === watched.length - 1 ? estimatorCalls : calls[last]!;
    return {
      spent:
        soFar * clip.estimator.flops + frames * (flopsPerFrame.denoise + flopsPerFrame.recover),
      everyFrame: frames * everyFrameFlopsPerFrame,
      calls: soFar,
    };
  };
}
