import type { Engine, RecoveredClip, RecoverOptions } from '../engine/types.ts';
import { type FetchedClip, fetchClip } from './fetch-clip.ts';

/** What is to be recovered, and who wants to know. */
export interface ClipOrder {
  readonly source: Blob | URL;
  readonly settings: Pick<RecoverOptions, 'every' | 'estimator'>;
  /** Asked for once the clip is there. */
  engine(): Engine;
  /** The clip is there; not told again for the same source. */
  onFetched(clip: FetchedClip): void;
  readonly onProgress: NonNullable<RecoverOptions['onProgress']>;
}

/** Fetches a clip and recovers its poses. A new order ends the one before. */
export class ClipWork {
  #abort: AbortController | null = null;
  #fetched: { readonly key: Blob | string; readonly clip: FetchedClip } | null = null;

  /**
   * @returns null where the order was cancelled, or another one has taken its place
   * @throws DeciWatchError
   */
  async run(order: ClipOrder): Promise<RecoveredClip | null> {
    this.cancel();
    const abort = new AbortController();
    const { signal } = abort;
    this.#abort = abort;
    try {
      const { blob, name } = await this.#fetch(order, signal);
      signal.throwIfAborted();
      return await order.engine().recover(blob, name, {
        ...order.settings,
        signal,
        onProgress: order.onProgress,
      });
    } catch (error) {
      if (signal.aborted) return null;
      // What came may not be what is there: it is fetched anew the next time.
      this.#fetched = null;
      throw error;
    }
  }

  cancel(): void {
    this.#abort?.abort();
    this.#abort = null;
  }

  /** Lets go of the clip too. */
  forget(): void {
    this.cancel();
    this.#fetched = null;
  }

  async #fetch({ source, onFetched }: ClipOrder, signal: AbortSignal): Promise<FetchedClip> {
    const key = source instanceof Blob ? source : source.href;
    if (this.#fetched?.key === key) return this.#fetched.clip;
    const clip =
      source instanceof Blob
        ? { blob: source, name: source instanceof File ? source.name : 'The clip' }
        : await fetchClip(source, signal);
    signal.throwIfAborted();
    this.#fetched = { key, clip };
    onFetched(clip);
    return clip;
  }
}
