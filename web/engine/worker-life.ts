/**
 * Waits for a worker's answers as long as it lives. A race against a promise that settles when the worker
 * dies would do the same, but such a promise keeps every race that it was ever in: a kilobyte for each
 * look of live playback, for ever.
 */
export class WorkerLife {
  readonly #waiting = new Set<(error: Error) => void>();
  #error: Error | null = null;

  /** The answer, or the reason of the worker's death if that comes first. */
  whileAlive<T extends Promise<unknown>>(answer: T): Promise<Awaited<T>> {
    return new Promise((resolve, reject) => {
      if (this.#error) {
        reject(this.#error);
        return;
      }
      this.#waiting.add(reject);
      const done = () => this.#waiting.delete(reject);
      answer.then(
        (value) => {
          done();
          resolve(value as Awaited<T>);
        },
        (error) => {
          done();
          reject(error);
        },
      );
    });
  }

  /** @param listener told once, at once where the worker has died already. @returns takes it back */
  onDeath(listener: (error: Error) => void): () => void {
    if (this.#error) listener(this.#error);
    else this.#waiting.add(listener);
    return () => void this.#waiting.delete(listener);
  }

  /** The worker has died, or is to be ended. */
  end(error: Error): void {
    if (this.#error) return;
    this.#error = error;
    const waiting = [...this.#waiting];
    this.#waiting.clear();
    for (const tell of waiting) {
      try {
        tell(error);
      } catch (thrown) {
        // The others are told all the same.
        reportError(thrown);
      }
    }
  }
}
