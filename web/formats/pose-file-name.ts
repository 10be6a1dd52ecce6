/** The name of a clip's pose file: `walk.mp4` gives `walk.poses.json`. */
export function poseFileName(clipName: string): string {
  return `${clipName.replace(/\.[^.]+$/, '') || 'clip'}.poses.json`;
}
