import { sha256 } from '../../digest.ts';
import type { EstimatorName } from '../../estimators/names.ts';
import { cachePrefix, isImmutable, LIST, wholeCopies } from './addresses.ts';
import { bytesOf, entriesFor, parseRelease, type Release, type ReleaseEntry } from './release.ts';

/** What is kept, and whole. */
export interface KeptCopy {
  readonly release: Release;
  readonly estimators: readonly EstimatorName[];
}

/** Why a copy could not be kept. */
export type OfflineFailure = 'no-room' | 'no-answer' | 'another-file' | 'no-worker' | 'busy';

export class OfflineError extends Error {
  override readonly name = 'OfflineError';

  constructor(
    readonly why: OfflineFailure,
    options?: ErrorOptions,
  ) {
    super(why, options);
  }
}

/** Whether this browser can keep a page, on this address. */
export function canKeep(): boolean {
  return isSecureContext && 'serviceWorker' in navigator && 'caches' in globalThis;
}

/**
 * The copy of the page that works without a connection: a cache with its files, and the service worker that
 * answers from it. Two tabs never write at a time.
 */
export class OfflineCopy {
  readonly #prefix: string;

  constructor(private readonly scope: URL) {
    this.#prefix = cachePrefix(scope);
  }

  /** What is kept, if all of it is there. */
  async read(): Promise<KeptCopy | null> {
    const newest = await this.#newest();
    const list = await newest?.cache.match(this.#address(LIST));
    const release = list ? await parseRelease(list) : null;
    if (!newest || !release) return null;
    const kept = new Set((await newest.cache.keys()).map(({ url }) => url));
    const has = ({ file }: ReleaseEntry) => kept.has(this.#address(file));
    if (!entriesFor(release, []).every(has)) return null;
    const estimators = release.files.filter(has).flatMap(({ estimator }) => estimator ?? []);
    return { release, estimators };
  }

  /**
   * Keeps a release for some estimators, and only then lets go of an earlier one.
   * @param onProgress bytes that are there, of those in all
   * @throws OfflineError with nothing changed; what the signal says where that is aborted
   */
  async keep(
    release: Release,
    estimators: readonly EstimatorName[],
    onProgress: (done: number, total: number) => void,
    signal: AbortSignal,
  ): Promise<void> {
    await this.#alone(async () => {
      const before = await wholeCopies(this.scope);
      const name = `${this.#prefix}${release.release}`;
      try {
        await this.#fill(name, release, entriesFor(release, estimators), onProgress, signal);
      } catch (error) {
        if (!before.some((copy) => copy.name === name)) await caches.delete(name);
        if (before.length === 0) await (await this.#registration())?.unregister();
        signal.throwIfAborted();
        throw error instanceof OfflineError ? error : new OfflineError(whyStoringFailed(error));
      }
      await this.#dropAllBut(name);
    });
  }

  /** Puts away what a closed tab left unfinished, once no tab is at work. */
  async tidy(): Promise<void> {
    await navigator.locks.request(this.#prefix, async () => {
      await this.#dropAllBut((await this.#newest())?.name);
    });
  }

  /** Removes all that is kept, and the service worker. */
  async remove(): Promise<void> {
    await navigator.locks.request(this.#prefix, async () => {
      await (await this.#registration())?.unregister();
      await this.#dropAllBut();
    });
  }

  /** Keeping is refused while another tab keeps, and waits for one that only tidies. */
  async #alone(work: () => Promise<void>): Promise<void> {
    await navigator.locks.request(`${this.#prefix}keeping`, { ifAvailable: true }, async (lock) => {
      if (!lock) throw new OfflineError('busy');
      await navigator.locks.request(this.#prefix, work);
    });
  }

  async #newest() {
    return (await this.#registration()) ? (await wholeCopies(this.scope)).at(-1) : undefined;
  }

  async #fill(
    name: string,
    release: Release,
    entries: readonly ReleaseEntry[],
    onProgress: (done: number, total: number) => void,
    signal: AbortSignal,
  ): Promise<void> {
    const total = bytesOf(entries);
    await checkRoom(total);
    const cache = await caches.open(name);
    let done = 0;
    for (const entry of entries) {
      signal.throwIfAborted();
      onProgress(done, total);
      const before = done;
      await this.#store(cache, entry, signal, (bytes) => onProgress(before + bytes, total));
      done += entry.bytes;
    }
    onProgress(total, total);
    await this.#register();
    signal.throwIfAborted();
    const list = JSON.stringify(release);
    await cache.put(
      this.#address(LIST),
      new Response(list, { headers: { 'Content-Type': 'application/json' } }),
    );
  }

  async #store(
    cache: Cache,
    entry: ReleaseEntry,
    signal: AbortSignal,
    onBytes: (bytes: number) => void,
  ): Promise<void> {
    const url = new URL(entry.file, this.scope);
    const immutable = isImmutable(url, this.scope);
    // Of an earlier release, perhaps: most of it never changes.
    const earlier = immutable ? await caches.match(url, { ignoreVary: true }) : undefined;
    const response = earlier ?? (await get(url, immutable, signal));
    const bytes = await readAll(response, signal, onBytes);
    if ((await sha256(bytes)) !== entry.sha256) throw new OfflineError('another-file');
    // Whatever the host says of its files (a content security policy, say) holds for the copy too.
    const headers = new Headers(response.headers);
    headers.delete('content-encoding');
    headers.delete('content-length');
    await cache.put(url, new Response(bytes, { headers }));
  }

  async #register(): Promise<void> {
    try {
      const registration = await navigator.serviceWorker.register(this.#address('sw.js'), {
        scope: this.scope.pathname,
        updateViaCache: 'none',
      });
      const worker = registration.active ?? registration.waiting ?? registration.installing;
      if (worker) await whenActive(worker);
    } catch (cause) {
      throw new OfflineError('no-worker', { cause });
    }
  }

  async #registration(): Promise<ServiceWorkerRegistration | undefined> {
    const found = await navigator.serviceWorker.getRegistration(this.scope.href);
    return found?.scope === this.scope.href ? found : undefined;
  }

  async #dropAllBut(name?: string): Promise<void> {
    const names = (await caches.keys()).filter((other) => other.startsWith(this.#prefix));
    await Promise.all(names.filter((other) => other !== name).map((other) => caches.delete(other)));
  }

  #address(file: string): string {
    return new URL(file, this.scope).href;
  }
}

/** Better said before tens of megabytes are fetched than after. */
async function checkRoom(bytes: number): Promise<void> {
  const { quota, usage } = await navigator.storage.estimate();
  if (quota !== undefined && usage !== undefined && quota - usage < bytes) {
    throw new OfflineError('no-room');
  }
}

async function get(url: URL, immutable: boolean, signal: AbortSignal): Promise<Response> {
  // Some hosts let a refusal be cached as long as the file: so, once more and past the cache.
  for (const cache of [immutable ? 'default' : 'no-cache', 'reload'] as const) {
    try {
      const response = await fetch(url, { cache, signal });
      if (response.ok) return response;
    } catch {
      // Said in the same words as a refusal.
    }
    signal.throwIfAborted();
  }
  throw new OfflineError('no-answer');
}

async function readAll(
  response: Response,
  signal: AbortSignal,
  onBytes: (bytes: number) => void,
): Promise<ArrayBuffer> {
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  const reader = response.body?.getReader();
  try {
    for (let read = await reader?.read(); read && !read.done; read = await reader?.read()) {
      pieces.push(read.value as Uint8Array<ArrayBuffer>);
      bytes += read.value.length;
      onBytes(bytes);
    }
  } catch (cause) {
    signal.throwIfAborted();
    throw new OfflineError('no-answer', { cause });
  }
  return new Blob(pieces).arrayBuffer();
}

function whyStoringFailed(error: unknown): OfflineFailure {
  return error instanceof DOMException && error.name === 'QuotaExceededError'
    ? 'no-room'
    : 'no-answer';
}

function whenActive(worker: ServiceWorker): Promise<void> {
  return new Promise((resolve, reject) => {
    const look = () => {
      if (worker.state === 'activated') resolve();
      if (worker.state === 'redundant') reject(new Error('the service worker was not accepted'));
    };
    worker.addEventListener('statechange', look);
    look();
  });
}
