import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { EstimatorName } from '../../estimators/names.ts';
import { type KeptCopy, OfflineCopy, OfflineError, type OfflineFailure } from './offline-copy.ts';
import { bytesOf, entriesFor, fetchRelease, type Release } from './release.ts';

/** A copy on its way. */
export interface Keeping {
  readonly done: number;
  readonly total: number;
  /** A newer release takes the place of the one that is kept. */
  readonly update: boolean;
}

/**
 * Whether the page is kept for offline use, and the work of keeping and removing it. A kept page is brought up
 * to date whenever it is opened with a connection: that is what keeping it means.
 */
export class OfflineDesk implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #copy: OfflineCopy;
  #release: Release | null = null;
  #kept: KeptCopy | null = null;
  #keeping: Keeping | null = null;
  #failure: OfflineFailure | null = null;
  #removed = false;
  /** Counts what has begun to change what is kept: a look from before it is out of date. */
  #changes = 0;
  #removing = false;
  #cancelling = new AbortController();

  constructor(
    host: ReactiveControllerHost,
    private readonly scope: URL,
  ) {
    this.#host = host;
    this.#copy = new OfflineCopy(scope);
    host.addController(this);
  }

  /** Something can be offered or told; false while nothing is known, and where keeping is impossible. */
  get known(): boolean {
    return this.#release !== null || this.#kept !== null;
  }

  get kept(): KeptCopy | null {
    return this.#kept;
  }

  get keeping(): Keeping | null {
    return this.#keeping;
  }

  get failure(): OfflineFailure | null {
    return this.#failure;
  }

  /** Removed by this very page. */
  get removed(): boolean {
    return this.#removed;
  }

  hostConnected(): void {
    void this.#begin();
  }

  hostDisconnected(): void {
    this.cancel();
  }

  /** Bytes on the device, with an estimator; of what is kept where it is kept. */
  bytes(estimators: readonly EstimatorName[]): number {
    const release = this.#kept?.release ?? this.#release;
    return release ? bytesOf(entriesFor(release, estimators)) : 0;
  }

  /** Looks again at what is kept: the service worker keeps estimators as they come into use. */
  async look(): Promise<void> {
    if (this.#keeping || this.#removing || !this.#kept) return;
    const changes = this.#changes;
    const now = await this.#copy.read();
    if (this.#changes !== changes) return;
    this.#kept = now;
    this.#host.requestUpdate();
  }

  async keep(estimators: readonly EstimatorName[], update = false): Promise<void> {
    const release = this.#release;
    if (!release || this.#keeping) return;
    this.#changes++;
    this.#cancelling = new AbortController();
    const { signal } = this.#cancelling;
    this.#failure = null;
    this.#removed = false;
    const tell = (done: number, total: number) => {
      this.#keeping = { done, total, update };
      this.#host.requestUpdate();
    };
    tell(0, bytesOf(entriesFor(release, estimators)));
    try {
      await this.#copy.keep(release, estimators, tell, signal);
    } catch (error) {
      if (!signal.aborted) this.#failure = error instanceof OfflineError ? error.why : 'no-answer';
    }
    this.#kept = await this.#copy.read();
    this.#keeping = null;
    this.#host.requestUpdate();
  }

  cancel(): void {
    this.#cancelling.abort();
  }

  async remove(): Promise<void> {
    this.#changes++;
    this.#removing = true;
    await this.#copy.remove();
    this.#removing = false;
    this.#kept = null;
    this.#failure = null;
    this.#removed = true;
    this.#host.requestUpdate();
  }

  async #begin(): Promise<void> {
    // Whatever it comes to: it is tried again at the next visit.
    this.#copy.tidy().catch(() => {});
    this.#kept = await this.#copy.read().catch(() => null);
    this.#host.requestUpdate();
    // Without a connection there is nothing to offer; what is kept says so itself.
    this.#release = await fetchRelease(this.scope).catch(() => null);
    this.#host.requestUpdate();
    if (this.#release && this.#kept && this.#release.release !== this.#kept.release.release) {
      await this.keep(this.#kept.estimators, true);
    }
  }
}
