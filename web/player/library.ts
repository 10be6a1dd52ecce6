/**
 * The library `deciwatch-web`: the engine, its parts, pose files and metrics. Importing it does nothing
 * by itself; `deciwatch-web/player` is the element.
 */
export { createEngine, type EngineOptions } from '../engine/client.ts';
export type {
  ClipInfo,
  Engine,
  RecoveredClip,
  RecoverOptions,
  RecoverProgress,
  RecoverStage,
  Recovery,
} from '../engine/types.ts';
export { DeciWatchError, type DeciWatchErrorCode } from '../errors.ts';
export { type Box, type Crop, cropTo, type Size, toInput, toPicture } from '../estimators/crop.ts';
export type {
  EstimatorImage,
  PoseEstimate,
  PoseEstimator,
  SpatialEstimate,
} from '../estimators/estimator.ts';
export { decodeHeatmaps, type HeatmapShape } from '../estimators/heatmap.ts';
export {
  IMAGENET_MEAN,
  IMAGENET_STD,
  type InputFormat,
  inputValues,
} from '../estimators/input-values.ts';
export { ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';
export {
  type FindPerson,
  type OnnxEstimatorOptions,
  type OnnxInput,
  OnnxPoseEstimator,
  type OnnxSession,
  type OnnxTensor,
  type OnnxTensorClass,
} from '../estimators/onnx-estimator.ts';
export type { DecodedKeypoints } from '../estimators/peak.ts';
export {
  RecordedEstimator,
  type RecordedOptions,
  type RecordedPoses,
} from '../estimators/recorded.ts';
export { decodeSimcc } from '../estimators/simcc.ts';
export { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
export { COCO_17 } from '../pose/coco17.ts';
export { HALPE_26 } from '../pose/halpe26.ts';
export type { Dimensions, PoseSequence } from '../pose/sequence.ts';
export { type Side, type Skeleton, skeletonFrom } from '../pose/skeleton.ts';
