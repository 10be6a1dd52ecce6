import { type InterpolationKind, interpolate } from '../pose/interpolation.ts';
import type { Dimensions, PoseSequence } from '../pose/sequence.ts';
import type { Skeleton } from '../pose/skeleton.ts';
import { splitSegments } from '../sampling/segments.ts';
import { centreOnRoot } from './root.ts';
import { type SeenSample, type WatchedClip, watchedFlags } from './watched-clip.ts';

/**
 * A pose for every frame without nets, for what they were not trained on: a cubic spline through the
 * samples, which keeps their noise. Gaps are bridged by the same rule as with the nets, scores run in
 * straight lines.
 *
 * @param skeleton of the samples
 * @returns no 3D sequence where the samples have no 3D
 */
export function recoverCubic(
  clip: WatchedClip,
  skeleton: Skeleton,
): { poses2d: PoseSequence; poses3d: PoseSequence | null } {
  const joints = skeleton.joints.length;
  const shared = {
    skeleton,
    times: clip.times,
    scores: between(clip, 'linear', joints, 0, ({ estimate }) => estimate.scores),
    watched: watchedFlags(clip),
  };
  const sequence = (dims: Dimensions, valuesOf: ValuesOf): PoseSequence => {
    const values = between(clip, 'cubic', joints * dims, Number.NaN, valuesOf);
    return { ...shared, dims, values };
  };
  const poses2d = sequence(2, ({ estimate }) => estimate.keypoints2d);
  if (clip.seen.some(({ estimate }) => !estimate.keypoints3d)) return { poses2d, poses3d: null };
  const poses3d = sequence(3, ({ estimate }) => estimate.keypoints3d!);
  centreOnRoot(poses3d.values, skeleton);
  return { poses2d, poses3d };
}

type ValuesOf = (sample: SeenSample) => Float32Array;

/** T·size values: those of the samples and between them, and `elsewhere` in frames outside all segments. */
function between(
  { times, seen, every }: WatchedClip,
  kind: InterpolationKind,
  size: number,
  elsewhere: number,
  valuesOf: ValuesOf,
): Float32Array {
  const out = new Float32Array(times.length * size).fill(elsewhere);
  const seenFrames = seen.map(({ frame }) => frame);
  for (const [start, end] of splitSegments(seenFrames, times, every)) {
    const samples = seen.slice(start, end);
    const values = new Float32Array(samples.length * size);
    samples.forEach((sample, s) => {
      values.set(valuesOf(sample), s * size);
    });
    const first = seenFrames[start]!;
    const frameTimes = times.subarray(first, seenFrames[end - 1]! + 1);
    const sampleTimes = Float64Array.from(samples, ({ frame }) => times[frame]!);
    out.set(interpolate(kind, sampleTimes, values, frameTimes), first * size);
  }
  return out;
}
