import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { RecoveredClip, RecoverProgress } from '../engine/types.ts';
import { DeciWatchError } from '../errors.ts';
import { NOT_STARTED } from '../player/parts/progress-words.ts';
import type { PageEngine } from './page-engine.ts';
import type { Settings } from './settings.ts';

/** A video to work on. */
export interface ClipFile {
  readonly blob: Blob;
  readonly name: string;
  /** Its pictures are black: a recording that was made without them. Nobody can be seen in it. */
  readonly blank?: boolean;
}

/** The job that is running or about to. */
export interface Job<TFile extends ClipFile> {
  readonly file: TFile;
  readonly settings: Settings;
  readonly progress: RecoverProgress;
}

/** How a job ended. A job that was cancelled or overtaken by another does not end: it is forgotten. */
export interface JobOutcomes<TFile extends ClipFile> {
  done(file: TFile, clip: RecoveredClip): void;
  /** `message` is one sentence for people. */
  failed(file: TFile, message: string): void;
}

/**
 * Runs one job at a time on the page's engine: a new one aborts the one before. Re-renders its host
 * as the job goes on.
 */
export class RecoverJob<TFile extends ClipFile> implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #outcomes: JobOutcomes<TFile>;
  readonly #engine: PageEngine;
  #job: Job<TFile> | null = null;
  #abort: AbortController | null = null;
  #timer = 0;

  constructor(host: ReactiveControllerHost, engine: PageEngine, outcomes: JobOutcomes<TFile>) {
    this.#host = host;
    this.#engine = engine;
    this.#outcomes = outcomes;
    host.addController(this);
  }

  get job(): Job<TFile> | null {
    return this.#job;
  }

  /** @param delayMs waits this long for another call, which would replace this one */
  start(file: TFile, settings: Settings, delayMs = 0): void {
    this.cancel();
    this.#set({ file, settings, progress: NOT_STARTED });
    this.#timer = setTimeout(() => void this.#run(file, settings), delayMs) as unknown as number;
  }

  /** Aborts the job, if there is one. */
  cancel(): void {
    clearTimeout(this.#timer);
    this.#abort?.abort();
    this.#abort = null;
    this.#set(null);
  }

  hostDisconnected(): void {
    this.cancel();
  }

  async #run(file: TFile, settings: Settings): Promise<void> {
    const abort = new AbortController();
    const { signal } = abort;
    this.#abort = abort;
    try {
      const clip = await this.#engine.get().recover(file.blob, file.name, {
        ...settings,
        signal,
        onProgress: (progress) => {
          if (!signal.aborted) this.#set({ file, settings, progress });
        },
      });
      if (signal.aborted) return;
      this.#set(null);
      this.#outcomes.done(file, clip);
    } catch (error) {
      if (signal.aborted) return;
      this.#set(null);
      this.#outcomes.failed(file, messageOf(error));
    }
  }

  #set(job: Job<TFile> | null): void {
    this.#job = job;
    this.#host.requestUpdate();
  }
}

function messageOf(error: unknown): string {
  if (error instanceof DeciWatchError) return error.message;
  const detail = error instanceof Error ? error.message : String(error);
  return `Something failed that should not have (${detail}): please try again, or another video.`;
}
