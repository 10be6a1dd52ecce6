import type { RecoveredClip } from '../engine/types.ts';
import { poseFileName, stringifyPoseFile, toPoseFile } from '../formats/pose-file.ts';

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
