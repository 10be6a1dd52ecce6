import type { PoseLandmarker } from '@mediapipe/tasks-vision';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import type { EstimatorImage, PoseEstimator, SpatialEstimate } from './estimator.ts';
import { imageSize } from './image-size.ts';

/** Where MediaPipe's library, its WebAssembly and the loader of that are: absolute addresses. */
export interface MediaPipeFiles {
  readonly library: string;
  readonly loader: string;
  readonly wasm: string;
}

/** What a MediaPipe Pose variant is made of. */
export interface MediaPipeModel {
  readonly name: string;
  /** FLOPs of one call: detector and landmarks. */
  readonly flops: number;
  /** The bytes of a `.task` bundle. */
  readonly bundle: Uint8Array;
  readonly files: MediaPipeFiles;
}

interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

type ModuleFactory = (options: object) => Promise<unknown>;

/** What MediaPipe's loader leaves in the global scope, and looks for there. */
interface MediaPipeGlobals {
  ModuleFactory: ModuleFactory;
  custom_dbg: (line: string) => void;
}

/** What MediaPipe's log says at each start when all is well. */
const CHATTER = /^[IW]\d{4} |^INFO: |^Graph /;

const [LEFT_HIP, RIGHT_HIP] = BLAZEPOSE_33.root as [number, number];

/**
 * MediaPipe Pose on the CPU, one person.
 *
 * Every call is in image mode: the detector, then the landmarks. Video mode would take the crop from
 * the landmarks of the call before, which with N = 10 are a third of a second old: a person who walks
 * has left it.
 */
export class MediaPipeEstimator implements PoseEstimator {
  readonly skeleton = BLAZEPOSE_33;

  private constructor(
    readonly name: string,
    readonly flops: number,
    private readonly landmarker: PoseLandmarker,
  ) {}

  /** Loads the WebAssembly (once for each call) and the bundle. */
  static async create(model: MediaPipeModel): Promise<MediaPipeEstimator> {
    // Not bundled: who brings an estimator of their own has no need of it.
    const { PoseLandmarker }: typeof import('@mediapipe/tasks-vision') = await import(
      /* @vite-ignore */ model.files.library
    );
    // MediaPipe would import the loader itself, and read the factory that it leaves in the global
    // scope. A module runs once only, so that fails from the second estimator on.
    const loader: { default: ModuleFactory } = await import(/* @vite-ignore */ model.files.loader);
    const globals = globalThis as unknown as MediaPipeGlobals;
    globals.ModuleFactory = (options) => loader.default({ ...options, print: log, printErr: log });
    globals.custom_dbg = log;
    const landmarker = await PoseLandmarker.createFromOptions(
      { wasmLoaderPath: '', wasmBinaryPath: model.files.wasm },
      {
        baseOptions: { modelAssetBuffer: model.bundle, delegate: 'CPU' },
        runningMode: 'IMAGE',
        numPoses: 1,
      },
    );
    return new MediaPipeEstimator(model.name, model.flops, landmarker);
  }

  async estimate(image: EstimatorImage): Promise<SpatialEstimate | null> {
    const result = this.landmarker.detect(image);
    const landmarks = result.landmarks[0];
    const world = result.worldLandmarks[0];
    if (!landmarks || !world) return null;
    const { width, height } = imageSize(image);
    return {
      keypoints2d: Float32Array.from(landmarks.flatMap(({ x, y }) => [x * width, y * height])),
      keypoints3d: fromMidHip(world),
      scores: Float32Array.from(landmarks, ({ visibility }) =>
        Math.min(1, Math.max(0, visibility ?? 0)),
      ),
    };
  }

  close(): void {
    this.landmarker.close();
  }
}

/** World landmarks (y down, z away from the camera) in our axes, the mid-hip exactly at the origin. */
function fromMidHip(world: readonly Point[]): Float32Array {
  const left = world[LEFT_HIP]!;
  const right = world[RIGHT_HIP]!;
  const hip = { x: (left.x + right.x) / 2, y: (left.y + right.y) / 2, z: (left.z + right.z) / 2 };
  return Float32Array.from(world.flatMap(({ x, y, z }) => [x - hip.x, hip.y - y, hip.z - z]));
}

function log(line: string): void {
  if (!CHATTER.test(line)) console.warn(line);
}
