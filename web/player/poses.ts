/**
 * The part of the library that needs no engine: `deciwatch-web/poses`. An entry of its own, since bundlers
 * copy the engine's models beside every page that imports anything from its module.
 */

// # Poses

export { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
export { COCO_17 } from '../pose/coco17.ts';
export { HALPE_26 } from '../pose/halpe26.ts';
export {
  type Dimensions,
  frameAtTime,
  hasPose,
  type PoseSequence,
  poseAt,
} from '../pose/sequence.ts';
export { type Side, type Skeleton, sideOf, skeletonFrom } from '../pose/skeleton.ts';

// # Filling in frames

export {
  INTERPOLATION_KINDS,
  type InterpolationKind,
  interpolate,
} from '../pose/interpolation.ts';

// # Accuracy

export { accelError, mpjpe, type PoseShape, pck } from '../pose/metrics.ts';

// # Pose files

export {
  POSE_FILE_FORMAT,
  type PoseFile,
  type PoseFileFrame,
  type PoseFileSkeleton,
  type PoseFileSource,
  parsePoseFile,
  poseFileName,
  posesFromFile,
  stringifyPoseFile,
  toPoseFile,
} from '../formats/pose-file.ts';

// # Cost

export type { CostParts, CostReport } from '../cost/report.ts';

// # Errors

export { DeciWatchError, type DeciWatchErrorCode } from '../errors.ts';
