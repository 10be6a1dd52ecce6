import type { RecoveredClip } from '../engine/types.ts';
import { stringifyPoseFile, toPoseFile } from '../formats/pose-file.ts';

/** The name of a clip's pose file: `walk.mp4` becomes `walk.poses.json`. */
export function poseFileName(clipName: string): string {
  return `${clipName.replace(/\.[^.]+$/, '') || 'clip'}.poses.json`;
}

/** Hands the pose file of a clip to the browser's downloads. */
export function savePoses(clip: RecoveredClip): void {
  const blob = new Blob([stringifyPoseFile(toPoseFile(clip))], { type: 'application/json' });
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = poseFileName(clip.source.name);
  link.click();
  // Once the click has been dealt with, the download holds the blob itself.
  setTimeout(() => URL.revokeObjectURL(link.href), 0);
}
