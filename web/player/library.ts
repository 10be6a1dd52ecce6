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
} from '../engine/types.ts';
export { DeciWatchError, type DeciWatchErrorCode } from '../errors.ts';
