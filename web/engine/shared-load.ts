import { untilAborted } from './until-aborted.ts';

interface Loading<T> {
  readonly promise: Promise<T>;
  readonly giveUp: AbortController;
  waiting: number;
  value: { readonly of: T } | null;
}

/**
 * Something that is loaded once for all who want it. The load is given up when nobody waits for it any more;
 * after a failure the next one who wants it tries again.
 */
export class SharedLoad<T> {
  readonly #load: (signal: AbortSignal) => Promise<T>;
  #loading: Loading<T> | null = null;

  /** @param load may end in a value although its signal was aborted: the value is kept */
  constructor(load: (signal: AbortSignal) => Promise<T>) {
    this.#load = load;
  }

  /** @throws what the load throws; the signal's reason once it is aborted */
  async get(signal: AbortSignal): Promise<T> {
    signal.throwIfAborted();
    // One that was given up ends first: two at a time would leave a value behind that nobody has.
    while (this.#loading?.giveUp.signal.aborted && !this.#loading.value) {
      await untilAborted(
        this.#loading.promise.catch(() => {}),
        signal,
      );
    }
    this.#loading ??= this.#begin();
    const loading = this.#loading;
    loading.waiting++;
    try {
      return await untilAborted(loading.promise, signal);
    } finally {
      if (--loading.waiting === 0 && !loading.value) loading.giveUp.abort();
    }
  }

  /** Takes the value away, if there is one: it is loaded anew for the next one who wants it. */
  take(): T | undefined {
    const value = this.#loading?.value;
    if (!value) return undefined;
    this.#loading = null;
    return value.of;
  }

  #begin(): Loading<T> {
    const giveUp = new AbortController();
    const loading: Loading<T> = {
      giveUp,
      waiting: 0,
      value: null,
      promise: this.#load(giveUp.signal).then(
        (value) => {
          loading.value = { of: value };
          return value;
        },
        (error) => {
          this.#loading = null;
          throw error;
        },
      ),
    };
    return loading;
  }
}
