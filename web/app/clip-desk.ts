import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { RecoveredClip } from '../engine/types.ts';
import { costHeadline } from '../player/parts/cost-words.ts';
import { formatCount } from '../player/parts/format.ts';
import { pickVideo } from './dropped-file.ts';
import type { PageEngine } from './page-engine.ts';
import { type ClipFile, type Job, RecoverJob } from './recover-job.ts';
import { fetchSample } from './sample.ts';
import { savePoses } from './save-poses.ts';
import { DEFAULT_SETTINGS, isSame, type Settings } from './settings.ts';

/** Long enough for a slider to come to rest. */
const SETTLE_MS = 350;

const BLANK =
  'This recording has no picture, so that it cannot be watched again with other settings: record the picture too.';

/** A video with an address that the `<video>` can play. Whoever drops it revokes the address. */
export interface OpenFile extends ClipFile {
  readonly url: string;
}

/** What the page shows: a video, and its poses once they are there. */
interface Shown {
  readonly file: OpenFile;
  readonly result: { readonly clip: RecoveredClip; readonly settings: Settings } | null;
}

/** What the desk needs of the page that shows its clip. */
export interface DeskPlayer {
  isPlaying(): boolean;
  play(): void;
  pause(): void;
  /** Another video is shown from now on. */
  rewind(): void;
}

/**
 * The clip on the page's desk: which video is open, with which settings its poses are recovered, what
 * came of it, and what is said about that. A result stays until the next one is ready.
 */
export class ClipDesk implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #player: DeskPlayer;
  readonly #work: RecoverJob<OpenFile>;
  #shown: Shown | null = null;
  #settings = DEFAULT_SETTINGS;
  #error = '';
  #note = '';
  #status = '';
  /** Playback pauses while a job runs, so that the milliseconds measured are the job's own. */
  #resume = false;
  /** Somebody has begun something of their own: the sample is not wanted any more. */
  #taken = false;

  constructor(host: ReactiveControllerHost, engine: PageEngine, player: DeskPlayer) {
    this.#host = host;
    this.#player = player;
    // Before the job's own controller, which forgets its file when it is disconnected.
    host.addController(this);
    this.#work = new RecoverJob<OpenFile>(host, engine, {
      done: (file, clip) => this.#finish(file, clip),
      failed: (file, message) => this.#fail(file, message),
    });
  }

  /** The video on screen, and its address. */
  get file(): OpenFile | null {
    return this.#shown?.file ?? null;
  }

  /** The poses on screen, if there are any. */
  get clip(): RecoveredClip | null {
    return this.#shown?.result?.clip ?? null;
  }

  get job(): Job<ClipFile> | null {
    return this.#work.job;
  }

  get settings(): Settings {
    return this.#settings;
  }

  /** A video is open, but its poses are neither there nor being worked on. */
  get waiting(): boolean {
    return this.#shown !== null && this.#shown.result === null && !this.job;
  }

  /** What went wrong, in one sentence, or nothing. */
  get error(): string {
    return this.#error;
  }

  /** What else somebody should know, or nothing. */
  get note(): string {
    return this.#note;
  }

  /** For screen readers: what is going on. */
  get status(): string {
    return this.#status;
  }

  hostConnected(): void {
    void this.#openSample();
  }

  hostDisconnected(): void {
    this.#cancelJob();
    if (this.#shown) URL.revokeObjectURL(this.#shown.file.url);
    this.#shown = null;
  }

  /**
   * Opens the first video among some files.
   * @returns false where there is none, which is told
   */
  openFiles(files: readonly File[]): boolean {
    this.#taken = true;
    const { file, note } = pickVideo(files);
    this.#say({ error: file ? '' : (note ?? ''), note: file ? (note ?? '') : '' });
    if (file) this.#open({ blob: file, name: file.name });
    return file !== null;
  }

  /** Shows a clip whose poses are there already: a recording. */
  showRecording(clip: ClipFile, recovered: RecoveredClip, settings: Settings): void {
    this.#cancelJob();
    this.#settings = settings;
    const file: OpenFile = { ...clip, url: URL.createObjectURL(clip.blob) };
    this.#finish(file, recovered);
  }

  /** Takes settings over without working on anything. */
  adopt(settings: Settings): void {
    this.#settings = settings;
    this.#host.requestUpdate();
  }

  /** Something else is on the page now: stops work and playback, keeps what is there. */
  rest(): void {
    this.#taken = true;
    const file = this.#cancelJob();
    this.#player.pause();
    if (file) this.#forget(file);
  }

  /** Goes back to the settings that the shown poses were made with. */
  resume(): void {
    // A new object, so that the controls show again what is in force.
    this.#settings = { ...(this.#shown?.result?.settings ?? this.#settings) };
    this.#host.requestUpdate();
  }

  /** What somebody should know. */
  say(words: { error?: string; note?: string; status?: string }): void {
    this.#say(words);
  }

  /** Recovers the open video with other settings, once they have come to rest. */
  change(settings: Settings): void {
    this.#settings = settings;
    this.#host.requestUpdate();
    const file = this.#work.job?.file ?? this.#shown?.file;
    if (!file || this.waiting) return;
    if (!this.#work.job && isSame(settings, this.#shown?.result?.settings)) return;
    if (file.blank) {
      this.resume();
      this.#say({ note: BLANK });
      return;
    }
    this.#say({ error: '' });
    this.#begin(file, SETTLE_MS);
  }

  /** Recovers the open video where that was cancelled before. */
  start(): void {
    if (!this.#shown) return;
    this.#say({ error: '' });
    this.#begin(this.#shown.file);
  }

  cancel(): void {
    const file = this.#cancelJob();
    this.#say({ status: 'Cancelled.' });
    if (file) this.#forget(file);
  }

  save(): void {
    if (!this.clip) return;
    savePoses(this.clip);
    this.#say({ status: 'The pose file has been saved.' });
  }

  /** The browser's `<video>` cannot show the open file. */
  cannotPlay(): void {
    if (!this.#shown) return;
    this.#say({
      note: 'This browser cannot play this video; if its poses can be recovered, step through them frame by frame.',
    });
  }

  dismissError(): void {
    this.#say({ error: '' });
  }

  dismissNote(): void {
    this.#say({ note: '' });
  }

  #say(words: { error?: string; note?: string; status?: string }): void {
    this.#error = words.error ?? this.#error;
    this.#note = words.note ?? this.#note;
    this.#status = words.status ?? this.#status;
    this.#host.requestUpdate();
  }

  async #openSample(): Promise<void> {
    try {
      const file = await fetchSample();
      if (!this.#taken) this.#open(file);
    } catch (error) {
      if (!this.#taken) this.#say({ error: (error as Error).message });
    }
  }

  #open(clip: ClipFile): void {
    const file: OpenFile = { ...clip, url: URL.createObjectURL(clip.blob) };
    this.#cancelJob();
    // A result stays on screen until the next one is ready; a video without one makes way.
    if (!this.#shown?.result) this.#show({ file, result: null });
    this.#begin(file);
  }

  #begin(file: OpenFile, delayMs = 0): void {
    this.#resume ||= this.#player.isPlaying();
    this.#player.pause();
    this.#say({ status: `Working on ${file.name}.` });
    this.#work.start(file, this.#settings, delayMs);
  }

  #finish(file: OpenFile, clip: RecoveredClip): void {
    const fresh = !this.#shown?.result || this.#shown.file !== file;
    this.#show({ file, result: { clip, settings: this.#settings } });
    const { figure, sentence } = costHeadline(clip.cost);
    const frames = formatCount(clip.cost.frames);
    const looks = formatCount(clip.cost.estimatorCalls);
    this.#say({ status: `Done: ${frames} frames from ${looks} looks, ${figure} ${sentence}.` });
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const play = fresh ? !still : this.#resume;
    this.#resume = false;
    if (play) void this.#host.updateComplete.then(() => this.#player.play());
  }

  #fail(file: OpenFile, message: string): void {
    this.#say({ error: message, status: '' });
    this.#forget(file);
  }

  /** Ends the running job, whose file is then nobody's unless it is shown. */
  #cancelJob(): OpenFile | null {
    const file = this.#work.job?.file ?? null;
    this.#work.cancel();
    if (file && file !== this.#shown?.file) URL.revokeObjectURL(file.url);
    return file;
  }

  /** After a job that came to nothing: back to what was shown, with the settings that it was made with. */
  #forget(file: OpenFile): void {
    if (file !== this.#shown?.file) URL.revokeObjectURL(file.url);
    if (this.#shown?.result) this.#settings = this.#shown.result.settings;
    if (this.#resume) this.#player.play();
    this.#resume = false;
    this.#host.requestUpdate();
  }

  #show(shown: Shown): void {
    const old = this.#shown?.file;
    if (old && old !== shown.file) {
      URL.revokeObjectURL(old.url);
      this.#player.rewind();
    }
    this.#shown = shown;
    this.#host.requestUpdate();
  }
}
