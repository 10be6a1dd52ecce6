import type { Engine, RecoveredClip, RecoverOptions, RecoverProgress } from '../engine/types.ts';
import { ClipWork } from './clip-work.ts';
import { clipPose } from './details.ts';
import { NOT_STARTED } from './parts/progress-words.ts';
import { PoseTeller } from './pose-teller.ts';
import type { PoseDetail } from './types.ts';

/** What the clip's side needs of the player. */
export interface ClipSideHost {
  /** What is to be played. @throws DeciWatchError `bad-option` */
  source(): Blob | URL;
  settings(): Pick<RecoverOptions, 'every' | 'estimator'>;
  engine(): Engine;
  /** Something that is shown is another one. */
  changed(): void;
  progressed(progress: RecoverProgress): void;
  /** The poses are there. */
  recovered(clip: RecoveredClip): void | Promise<void>;
  failed(error: unknown): void;
  pose(detail: PoseDetail): void;
}

/** A player's clip: fetched, recovered, and told of frame by frame. Owns the clip's address for its `<video>`. */
export class ClipSide {
  readonly #host: ClipSideHost;
  readonly #work = new ClipWork();
  readonly #teller = new PoseTeller();
  #loading: Promise<void> | null = null;
  #progress: RecoverProgress | null = null;
  #clip: RecoveredClip | null = null;
  #url: string | null = null;
  /** The page knows of the clip: it may be told of its frames. */
  #announced = false;

  constructor(host: ClipSideHost) {
    this.#host = host;
  }

  /** Null until the poses are there. */
  get clip(): RecoveredClip | null {
    return this.#clip;
  }

  /** Of the work that is being done, if any. */
  get progress(): RecoverProgress | null {
    return this.#progress;
  }

  /** Of the fetched clip. */
  get url(): string | null {
    return this.#url;
  }

  /** Recovers the clip, unless that has been done or is being done. Never rejects. */
  async load(): Promise<void> {
    if (!this.#clip) await (this.#loading ?? this.#begin());
  }

  /** The settings are other ones: what has been recovered, or is being recovered, is recovered anew. */
  async again(): Promise<void> {
    if (this.#clip || this.#loading) await this.#begin();
  }

  /** Lets go of the clip. */
  reset(): void {
    this.#work.forget();
    this.#teller.reset();
    this.#loading = null;
    this.#progress = null;
    this.#clip = null;
    this.#announced = false;
    this.#setUrl(null);
    this.#host.changed();
  }

  /** The page has been told of the clip: from now on it is told of frames, of the one on screen first. */
  announced(frame: number): void {
    this.#announced = true;
    this.shown(frame, true);
  }

  /** Somebody asked for another place in the clip. */
  jump(): void {
    this.#teller.jump();
  }

  /**
   * A frame is on screen.
   * @param landed false while a jump is still on its way
   */
  shown(frame: number, landed: boolean): void {
    if (!this.#clip || !this.#announced) return;
    this.#tell(this.#teller.shown(frame, this.#clip.poses2d.times.length, landed));
  }

  /** Playback has come to its end. */
  ended(): void {
    if (this.#clip && this.#announced)
      this.#tell(this.#teller.ended(this.#clip.poses2d.times.length));
  }

  #begin(): Promise<void> {
    const run = this.#recover().finally(() => {
      if (this.#loading === run) this.#loading = null;
    });
    this.#loading = run;
    return run;
  }

  async #recover(): Promise<void> {
    const host = this.#host;
    this.#setProgress(NOT_STARTED);
    try {
      const clip = await this.#work.run({
        source: host.source(),
        settings: host.settings(),
        engine: () => host.engine(),
        onFetched: ({ blob }) => this.#setUrl(URL.createObjectURL(blob)),
        onProgress: (progress) => {
          this.#setProgress(progress);
          host.progressed(progress);
        },
      });
      // Null: another one has taken its place, whose progress it now is.
      if (!clip) return;
      this.#clip = clip;
      this.#announced = false;
      this.#teller.reset();
      this.#setProgress(null);
      await host.recovered(clip);
    } catch (error) {
      this.#setProgress(null);
      host.failed(error);
    }
  }

  #tell(frames: readonly number[]): void {
    for (const frame of frames) {
      // Whoever is told may have put another clip in.
      if (this.#clip) this.#host.pose(clipPose(this.#clip, frame));
    }
  }

  #setProgress(progress: RecoverProgress | null): void {
    this.#progress = progress;
    this.#host.changed();
  }

  #setUrl(url: string | null): void {
    if (this.#url) URL.revokeObjectURL(this.#url);
    this.#url = url;
    this.#host.changed();
  }
}
