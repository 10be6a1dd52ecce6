import poseLoader from '@mediapipe/tasks-vision/vision_wasm_module_internal.js?url';
import poseWasm from '@mediapipe/tasks-vision/vision_wasm_module_internal.wasm?url';
import poseLibrary from '@mediapipe/tasks-vision?url';
import runtimeModule from 'onnxruntime-web/ort-wasm-simd-threaded.mjs?url';
import runtimeWasm from 'onnxruntime-web/ort-wasm-simd-threaded.wasm?url';
import estimatorManifest from '/estimators/manifest.json?url';
import full from '/estimators/pose_landmarker_full.task?url';
import heavy from '/estimators/pose_landmarker_heavy.task?url';
import lite from '/estimators/pose_landmarker_lite.task?url';
import denoise2d from '/models/2d-denoise.onnx?url';
import forecast2d from '/models/2d-forecast.onnx?url';
import recover2d from '/models/2d-recover.onnx?url';
import denoise3d from '/models/3d-denoise.onnx?url';
import forecast3d from '/models/3d-forecast.onnx?url';
import recover3d from '/models/3d-recover.onnx?url';
import modelManifest from '/models/manifest.json?url';
import type { FileSet } from '../download.ts';
import { DeciWatchError } from '../errors.ts';
import type { MediaPipeFiles } from '../estimators/mediapipe.ts';
import type { RuntimeFiles } from '../recovery/runtime.ts';

/** Where everything is that the engine fetches: absolute addresses, which the worker is told. */
export interface EngineFiles {
  readonly runtime: RuntimeFiles;
  readonly mediapipe: MediaPipeFiles;
  readonly models: FileSet;
  readonly estimators: FileSet;
}

// In a constant: where an unknown address meets `import.meta.url` itself, webpack puts a search of its own.
const HERE = import.meta.url;

const own = (url: string) => new URL(url, HERE).href;

/**
 * The engine's files: beside this module, or where `models` says. Each is named here, on the page's side
 * of the engine: so a bundler of somebody else's finds and copies all of them, whatever it calls them.
 * @param models of a folder that holds `models/` and `estimators/`, relative to the page
 */
export function engineFiles(models?: string | URL): EngineFiles {
  return {
    runtime: { mjs: own(runtimeModule), wasm: own(runtimeWasm) },
    mediapipe: { library: own(poseLibrary), loader: own(poseLoader), wasm: own(poseWasm) },
    ...(models === undefined ? ownModels() : modelsIn(models)),
  };
}

function modelsIn(folder: string | URL): Pick<EngineFiles, 'models' | 'estimators'> {
  if (!URL.canParse(folder, document.baseURI)) {
    throw new DeciWatchError(
      'bad-option',
      `${folder} is not the address of a folder: mend models.`,
    );
  }
  const { href } = new URL(folder, document.baseURI);
  const base = href.endsWith('/') ? href : `${href}/`;
  return {
    models: { manifest: new URL('models/manifest.json', base).href },
    estimators: { manifest: new URL('estimators/manifest.json', base).href },
  };
}

function ownModels(): Pick<EngineFiles, 'models' | 'estimators'> {
  return {
    models: {
      manifest: own(modelManifest),
      files: {
        '2d-denoise.onnx': own(denoise2d),
        '2d-recover.onnx': own(recover2d),
        '2d-forecast.onnx': own(forecast2d),
        '3d-denoise.onnx': own(denoise3d),
        '3d-recover.onnx': own(recover3d),
        '3d-forecast.onnx': own(forecast3d),
      },
    },
    estimators: {
      manifest: own(estimatorManifest),
      files: {
        'pose_landmarker_lite.task': own(lite),
        'pose_landmarker_full.task': own(full),
        'pose_landmarker_heavy.task': own(heavy),
      },
    },
  };
}
