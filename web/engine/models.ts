import { fetchListed } from '../download.ts';
import { fetchEstimatorManifest } from '../estimators/manifest.ts';
import { MediaPipeEstimator } from '../estimators/mediapipe.ts';
import type { EstimatorName } from '../estimators/names.ts';
import { Recoverer } from '../recovery/recoverer.ts';
import { setRuntimeFiles } from '../recovery/runtime.ts';
import type { EngineFiles } from './files.ts';
import { SharedLoad } from './shared-load.ts';

/** Large enough for the estimator to look at, and nobody in it. */
const WARM_UP_PX = 64;

/** An estimator that is not closed before it is given back. */
export interface BorrowedEstimator {
  readonly estimator: MediaPipeEstimator;
  /** Once only. */
  release(): void;
}

interface Shelf {
  readonly load: SharedLoad<MediaPipeEstimator>;
  users: number;
}

/**
 * Keeps what was loaded, from one clip to the next: the nets, the estimators in use, and of the others the
 * one that was used last. A clip and the camera may use them at a time. Owns them until the worker ends.
 */
export class Models {
  readonly #recoverer: SharedLoad<Recoverer>;
  readonly #shelves = new Map<EstimatorName, Shelf>();

  constructor(private readonly files: EngineFiles) {
    setRuntimeFiles(files.runtime);
    this.#recoverer = new SharedLoad((signal) => Recoverer.load(files.models, signal));
  }

  /** @throws DeciWatchError `model-missing` or `model-mismatch` */
  recoverer(signal: AbortSignal): Promise<Recoverer> {
    return this.#recoverer.get(signal);
  }

  /**
   * Its bundle is fetched only now, and those that nobody uses make room for it.
   * @throws DeciWatchError `model-missing` or `model-mismatch`
   */
  async borrow(name: EstimatorName, signal: AbortSignal): Promise<BorrowedEstimator> {
    const shelf = this.#shelf(name);
    // From now on: it may be there already, and nobody is to close it while this one waits its turn.
    shelf.users++;
    try {
      const estimator = await shelf.load.get(signal);
      return { estimator, release: () => void shelf.users-- };
    } catch (error) {
      shelf.users--;
      throw error;
    }
  }

  #shelf(name: EstimatorName): Shelf {
    let shelf = this.#shelves.get(name);
    if (!shelf) {
      shelf = { load: new SharedLoad((signal) => this.#load(name, signal)), users: 0 };
      this.#shelves.set(name, shelf);
    }
    return shelf;
  }

  async #load(name: EstimatorName, signal: AbortSignal): Promise<MediaPipeEstimator> {
    const set = this.files.estimators;
    const { estimators } = await fetchEstimatorManifest(set, signal);
    const entry = estimators[name];
    const bundle = await fetchListed(set, entry, signal);
    for (const { load, users } of this.#shelves.values()) {
      if (users === 0) load.take()?.close();
    }
    const estimator = await MediaPipeEstimator.create({
      name,
      flops: entry.flops.perCall,
      bundle,
      files: this.files.mediapipe,
    });
    // The first call prepares the nets, and would spoil the clip's own times.
    await estimator.estimate(blank());
    return estimator;
  }
}

function blank(): OffscreenCanvas {
  const canvas = new OffscreenCanvas(WARM_UP_PX, WARM_UP_PX);
  // Without a context a canvas has no pixels to look at.
  canvas.getContext('2d');
  return canvas;
}
