import { fetchListed } from '../download.ts';
import { fetchEstimatorManifest } from '../estimators/manifest.ts';
import { MediaPipeEstimator } from '../estimators/mediapipe.ts';
import type { EstimatorName } from '../estimators/names.ts';
import { Recoverer } from '../recovery/recoverer.ts';
import { setRuntimeFiles } from '../recovery/runtime.ts';
import type { EngineFiles } from './files.ts';

/** Large enough for the estimator to look at, and nobody in it. */
const WARM_UP_PX = 64;

/**
 * Keeps what was loaded, from one clip to the next: the nets, and the estimator that was used last.
 * Owns them until the worker ends. What failed to load is tried again the next time.
 */
export class Models {
  #recoverer: Recoverer | undefined;
  #estimator: MediaPipeEstimator | undefined;

  constructor(private readonly files: EngineFiles) {
    setRuntimeFiles(files.runtime);
  }

  /** @throws DeciWatchError `model-missing` or `model-mismatch` */
  async recoverer(signal: AbortSignal): Promise<Recoverer> {
    this.#recoverer ??= await Recoverer.load(this.files.models, signal);
    return this.#recoverer;
  }

  /**
   * Closes the estimator in use when another one is asked for. Its bundle is fetched only now.
   * @throws DeciWatchError `model-missing` or `model-mismatch`
   */
  async estimator(name: EstimatorName, signal: AbortSignal): Promise<MediaPipeEstimator> {
    if (this.#estimator?.name === name) return this.#estimator;
    const set = this.files.estimators;
    const { estimators } = await fetchEstimatorManifest(set, signal);
    const entry = estimators[name];
    const bundle = await fetchListed(set, entry, signal);
    this.#estimator?.close();
    this.#estimator = undefined;
    const estimator = await MediaPipeEstimator.create({
      name,
      flops: entry.flops.perCall,
      bundle,
      files: this.files.mediapipe,
    });
    // The first call prepares the nets, and would spoil the clip's own times.
    await estimator.estimate(blank());
    this.#estimator = estimator;
    return estimator;
  }
}

function blank(): OffscreenCanvas {
  const canvas = new OffscreenCanvas(WARM_UP_PX, WARM_UP_PX);
  // Without a context a canvas has no pixels to look at.
  canvas.getContext('2d');
  return canvas;
}
