/**
 * The library `deciwatch-web`: the engine, its parts, pose files and metrics. Importing it does nothing
 * by itself; `deciwatch-web/player` is the element.
 *
 * The headings here and in `poses.ts` are those of the API reference (`docs/api.md`), in this order.
 */

// # Recovering a clip

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
export { DEFAULT_INTERVAL, MAX_INTERVAL, MIN_INTERVAL } from '../sampling/watched.ts';

// # Estimators

export { DEFAULT_ESTIMATOR, ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';

// # Your own estimator

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

// # Following a camera

export type { LiveReport } from '../cost/live-meter.ts';
export type {
  LiveMode,
  LivePose,
  LiveSession,
  LiveSettings,
  LiveState,
  LiveStatus,
  LiveView,
  LoadPolicy,
} from '../engine/live/types.ts';
export { type Camera, type CameraChoice, listCameras, openCamera } from '../sources/camera.ts';
export { type CameraFrame, watchCameraFrames } from '../sources/camera-frames.ts';

// What needs no engine.

export * from './poses.ts';
