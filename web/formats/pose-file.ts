/** The pose file, `deciwatch-poses/1`: see `docs/pose-file.md`. */
export { poseFileName } from './pose-file-name.ts';
export { parsePoseFile } from './pose-file-reader.ts';
export { POSE_FILE_FORMAT } from './pose-file-schema.ts';
export type {
  PoseFile,
  PoseFileFrame,
  PoseFileSkeleton,
  PoseFileSource,
} from './pose-file-types.ts';
export { stringifyPoseFile, toPoseFile } from './pose-file-writer.ts';
export { posesFromFile } from './poses-from-file.ts';
