import * as Comlink from 'comlink';
import { DeciWatchError } from '../errors.ts';
import { ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';
import { checkInterval } from '../sampling/watched.ts';
import { CallerEstimator } from './caller-estimator.ts';
import { type EngineFiles, engineFiles } from './files.ts';
import { WorkerLiveSession } from './live/session.ts';
import type { LiveSession, LiveSettings } from './live/types.ts';
import type { EngineWorker, Outcome } from './messages.ts';
import { startWorker } from './start-worker.ts';
import type { Engine, RecoveredClip, RecoverOptions, RecoverProgress } from './types.ts';
import { WorkerLife } from './worker-life.ts';

/** For those who serve the models from elsewhere, or their own. */
export interface EngineOptions {
  /**
   * Address of a folder that holds `models/` and `estimators/`, each with its `manifest.json`, as the
   * package's `lib/` does; relative to the page. Unless given, the files beside this module.
   */
  readonly models?: string | URL;
}

/**
 * Makes an engine. Nothing is fetched until the first clip or camera: then its worker starts and the models
 * come, and both are kept until {@link Engine.close}. After a crash a new worker is started.
 * @throws DeciWatchError `bad-option`
 */
export function createEngine(options: EngineOptions = {}): Engine {
  return new WorkerEngine(engineFiles(options.models));
}

function checkEstimator(name: unknown): void {
  if (ESTIMATOR_NAMES.some((known) => known === name)) return;
  if (typeof name === 'object' && name !== null) {
    throw new DeciWatchError(
      'bad-option',
      `Live playback takes no estimator of your own; choose one of ${ESTIMATOR_NAMES.join(', ')}.`,
    );
  }
  const given = typeof name === 'function' ? 'a function' : name;
  throw new DeciWatchError(
    'bad-option',
    `The estimator is ${given}; choose one of ${ESTIMATOR_NAMES.join(', ')}.`,
  );
}

/** A listener that throws must not end the job; its error shows where uncaught ones do. */
function tellSafely(listener: RecoverOptions['onProgress'], progress: RecoverProgress): void {
  try {
    listener?.(progress);
  } catch (error) {
    reportError(error);
  }
}

/** A worker, and how to wait for it. */
interface Running {
  readonly worker: Worker;
  readonly remote: Comlink.Remote<EngineWorker>;
  readonly life: WorkerLife;
}

class WorkerEngine implements Engine {
  #running: Running | undefined;
  #live: WorkerLiveSession | undefined;
  #lastJob: Promise<unknown> = Promise.resolve();
  readonly #closing = new AbortController();

  constructor(private readonly files: EngineFiles) {}

  async recover(file: Blob, name: string, options: RecoverOptions): Promise<RecoveredClip> {
    checkInterval(options.every);
    if (typeof options.estimator !== 'object') checkEstimator(options.estimator);
    const signals = [this.#closing.signal, ...(options.signal ? [options.signal] : [])];
    const signal = AbortSignal.any(signals);
    signal.throwIfAborted();
    const caller =
      typeof options.estimator === 'object' ? new CallerEstimator(options.estimator, signal) : null;
    const job = this.#lastJob.then(() => this.#run(file, name, options, caller, signal));
    this.#lastJob = job.catch(() => {});
    return untilAborted(job, signal);
  }

  live(settings: LiveSettings): LiveSession {
    checkInterval(settings.every);
    checkEstimator(settings.estimator);
    this.#closing.signal.throwIfAborted();
    this.#live?.end(
      new DeciWatchError(
        'camera-busy',
        'The camera is followed elsewhere on this page now: start it here again to have it back.',
      ),
    );
    this.#running ??= start();
    const { remote, life } = this.#running;
    const session = new WorkerLiveSession(
      {
        remote,
        life,
        files: this.files,
        onClose: () => {
          if (this.#live === session) this.#live = undefined;
        },
      },
      settings,
    );
    this.#live = session;
    // A worker that has died is started anew the next time.
    life.onDeath(() => {
      if (this.#running?.life === life) this.#stop();
    });
    return session;
  }

  close(): void {
    this.#live?.close();
    this.#closing.abort(new DOMException('The engine was closed.', 'AbortError'));
    this.#stop();
  }

  async #run(
    file: Blob,
    name: string,
    { every, estimator, onProgress }: RecoverOptions,
    caller: CallerEstimator | null,
    signal: AbortSignal,
  ): Promise<RecoveredClip> {
    signal.throwIfAborted();
    this.#running ??= start();
    const { remote, life } = this.#running;
    const abort = () => void remote.abort();
    signal.addEventListener('abort', abort);
    const tell = Comlink.proxy((progress: RecoverProgress) => {
      if (!signal.aborted) tellSafely(onProgress, progress);
    });
    const look = caller && Comlink.proxy(caller.look);
    try {
      const chosen = caller ? caller.message : (estimator as EstimatorName);
      const job = { file, name, every, estimator: chosen, files: this.files };
      return unwrap(await life.whileAlive(remote.recover(job, tell, look)), signal);
    } catch (error) {
      // The one that was made here knows its cause.
      if (caller?.failure && error instanceof DeciWatchError && error.code === 'estimator-failed') {
        throw caller.failure;
      }
      if (error instanceof DeciWatchError && error.code === 'engine-crashed') this.#stop();
      throw error;
    } finally {
      signal.removeEventListener('abort', abort);
    }
  }

  #stop(): void {
    this.#running?.worker.terminate();
    this.#running = undefined;
  }
}

function start(): Running {
  const worker = tryToStart();
  const life = new WorkerLife();
  worker.addEventListener('error', (event) => {
    event.preventDefault();
    life.end(crash(event.message || 'its code could not be loaded'));
  });
  worker.addEventListener('messageerror', () => life.end(crash('it sent what cannot be read')));
  return { worker, remote: Comlink.wrap<EngineWorker>(worker), life };
}

/** A page's content security policy can forbid workers, which throws. */
function tryToStart(): Worker {
  try {
    return startWorker();
  } catch (error) {
    throw crash(error instanceof Error ? error.message : String(error));
  }
}

function unwrap(outcome: Outcome, signal: AbortSignal): RecoveredClip {
  switch (outcome.kind) {
    case 'done':
      return outcome.clip;
    case 'failed':
      throw new DeciWatchError(outcome.code, outcome.message);
    case 'crashed':
      throw crash(outcome.message);
    case 'aborted':
      throw signal.reason;
  }
}

function crash(detail: string): DeciWatchError {
  return new DeciWatchError(
    'engine-crashed',
    `The engine stopped working (${detail}): try again, and reload the page if it happens twice.`,
  );
}

/** Rejects as soon as the signal says so, while the job ends in its own time. */
function untilAborted<T>(job: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise((resolve, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason), { once: true });
    job.then(resolve, reject);
  });
}
