import * as Comlink from 'comlink';
import { DeciWatchError } from '../errors.ts';
import type { EstimatorName } from '../estimators/names.ts';
import { checkInterval } from '../sampling/watched.ts';
import { CallerEstimator } from './caller-estimator.ts';
import { checkEstimator } from './check-estimator.ts';
import { type EngineFiles, engineFiles } from './files.ts';
import { WorkerLiveSession } from './live/session.ts';
import type { LiveSession, LiveSettings } from './live/types.ts';
import type { EngineWorker, Outcome } from './messages.ts';
import { crash, errorOf } from './outcome.ts';
import { startWorker } from './start-worker.ts';
import type { Engine, RecoveredClip, RecoverOptions, RecoverProgress } from './types.ts';
import { untilAborted } from './until-aborted.ts';
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
    const { remote, life } = this.#worker();
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
    return session;
  }

  close(): void {
    const reason = new DOMException('The engine was closed.', 'AbortError');
    this.#live?.close();
    this.#closing.abort(reason);
    this.#running?.life.end(reason);
  }

  /** The one that runs, or a new one. */
  #worker(): Running {
    if (this.#running) return this.#running;
    const running = start();
    // The first of all who are told: whoever asks for a worker from then on gets another one.
    running.life.onDeath(() => {
      running.worker.terminate();
      this.#running = undefined;
    });
    this.#running = running;
    return running;
  }

  async #run(
    file: Blob,
    name: string,
    { every, estimator, onProgress }: RecoverOptions,
    caller: CallerEstimator | null,
    signal: AbortSignal,
  ): Promise<RecoveredClip> {
    signal.throwIfAborted();
    const { remote, life } = this.#worker();
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
      // Its state is unknown: whoever else waits for it waits in vain.
      if (error instanceof DeciWatchError && error.code === 'engine-crashed') life.end(error);
      throw error;
    } finally {
      signal.removeEventListener('abort', abort);
    }
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
    case 'aborted':
      throw signal.reason;
    default:
      throw errorOf(outcome);
  }
}
