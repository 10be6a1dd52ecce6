import type { RecoveredClip } from '../../engine/types.ts';
import { hasPose } from '../../pose/sequence.ts';
import { formatCount, formatTime } from './format.ts';

/** How a frame got its pose. */
export type FrameKind = 'watched' | 'recovered' | 'nobody seen';

export function frameKind(clip: RecoveredClip, frame: number): FrameKind {
  if (!hasPose(clip.poses2d, frame)) return 'nobody seen';
  return clip.poses2d.watched[frame] === 1 ? 'watched' : 'recovered';
}

/** A frame in words, counted from 1 as people do: `frame 31 of 150, 1.03 s, recovered`. */
export function describeFrame(clip: RecoveredClip, frame: number): string {
  const { times } = clip.poses2d;
  const time = formatTime(times[frame]! - times[0]!);
  return `frame ${formatCount(frame + 1)} of ${formatCount(times.length)}, ${time}, ${frameKind(clip, frame)}`;
}
