/** Rejects as soon as the signal says so, while the job ends in its own time. */
export function untilAborted<T>(job: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise((resolve, reject) => {
    if (signal.aborted) {
      reject(signal.reason);
      return;
    }
    const abort = () => reject(signal.reason);
    signal.addEventListener('abort', abort);
    // A signal may outlive the job by far, and its listener would keep the result as long.
    const done = () => signal.removeEventListener('abort', abort);
    job.then(resolve, reject).then(done, done);
  });
}
