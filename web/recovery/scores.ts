import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import type { SampleWindow } from '../sampling/windows.ts';
import type { WatchedClip } from './watched-clip.ts';

/**
 * A score for every joint of every frame: straight lines between the samples of a window, and 0 in
 * frames that no window reaches. The nets do not judge their own poses.
 * @returns T·K values, 0 to 1
 */
export function interpolateScores(
  { times, seen }: Pick<WatchedClip, 'times' | 'seen'>,
  windows: readonly SampleWindow[],
): Float32Array {
  const keypoints = BLAZEPOSE_33.joints.length;
  const scores = new Float32Array(times.length * keypoints);
  for (const { samples } of windows) {
    for (const [s, position] of samples.entries()) {
      const from = seen[position]!;
      // A window's last sample stands for its own frame alone.
      const to = seen[samples[s + 1] ?? position]!;
      const between = scoresBetween(
        { time: times[from.frame]!, estimate: from.estimate },
        { time: times[to.frame]!, estimate: to.estimate },
        times.subarray(from.frame, to.frame + 1),
      );
      scores.set(between, from.frame * keypoints);
    }
  }
  return scores;
}

/**
 * The scores at times between two samples: straight lines.
 * @param times T seconds, from the one's to the other's
 * @returns T·K values
 */
export function scoresBetween(
  from: { readonly time: number; readonly estimate: { readonly scores: Float32Array } },
  to: { readonly time: number; readonly estimate: { readonly scores: Float32Array } },
  times: Float64Array,
): Float32Array {
  const keypoints = from.estimate.scores.length;
  const scores = new Float32Array(times.length * keypoints);
  const length = to.time - from.time;
  times.forEach((time, t) => {
    const share = length > 0 ? (time - from.time) / length : 0;
    for (let k = 0; k < keypoints; k++) {
      const start = from.estimate.scores[k]!;
      scores[t * keypoints + k] = start + share * (to.estimate.scores[k]! - start);
    }
  });
  return scores;
}
