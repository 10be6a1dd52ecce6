import type { LiveReport, LiveSettings, LiveView as Moment } from '../engine/live/types.ts';
import type { Engine } from '../engine/types.ts';
import { cameraPose } from './details.ts';
import { CameraFollower } from './live/camera-follower.ts';
import type { ShownFrame } from './live/live-view.ts';
import { delayWords, liveWords } from './live/live-words.ts';
import type { PoseDetail } from './types.ts';

/** What the camera's side needs of the player. */
export interface CameraSideHost {
  /** @throws DeciWatchError `bad-option` */
  settings(): LiveSettings;
  engine(): Engine;
  /** Draws one moment, in the 3D view too where `stage` says so. */
  draw(moment: Moment, stage: boolean): void;
  isSlowToDraw(): boolean;
  changed(): void;
  failed(error: unknown): void;
  pose(detail: PoseDetail): void;
  cost(report: LiveReport): void;
}

/** A player's camera: followed, drawn, and told of frame by frame. */
export class CameraSide {
  readonly #host: CameraSideHost;
  readonly #follower: CameraFollower;
  #toldReport: LiveReport | null = null;
  #toldFrame: number | null = null;

  constructor(host: CameraSideHost) {
    this.#host = host;
    this.#follower = new CameraFollower({
      engine: () => host.engine(),
      draw: (moment, stage) => this.#draw(moment, stage),
      isSlowToDraw: () => host.isSlowToDraw(),
      changed: () => this.#changed(),
      failed: (error) => host.failed(error),
    });
  }

  /** It is on, or being asked for. */
  get on(): boolean {
    return this.#follower.on;
  }

  get stream(): MediaStream | null {
    return this.#follower.camera?.stream ?? null;
  }

  /** The picture in pixels, once its first frame is there. */
  get size(): { readonly width: number; readonly height: number } | null {
    return this.#follower.session?.size ?? null;
  }

  /** What is going on, in words. */
  get words(): string {
    const { opening, status, report, session } = this.#follower;
    if (opening) return 'Asking for the camera: allow it for this page.';
    if (!status || !session) return 'The camera is off.';
    const words = liveWords(status.state);
    if (!report || report.shown === 0) return words;
    return `${words} ${delayWords(session.settings.mode, report.delayMs.median)}`;
  }

  /** @returns whether it is on now; where not, the host has been told why, or has stopped it */
  async start(): Promise<boolean> {
    if (this.on) return true;
    return (await this.#follower.start(() => this.#host.settings())) !== null;
  }

  /** The settings are other ones. @throws DeciWatchError `bad-option` */
  changeSettings(): void {
    if (this.on) this.#follower.change(this.#host.settings());
  }

  /** A frame of the camera is on screen. */
  frame(shown: ShownFrame): void {
    this.#follower.frame(shown);
  }

  stop(): void {
    this.#follower.stop();
  }

  #changed(): void {
    const { report } = this.#follower;
    if (report && report !== this.#toldReport && report.estimatorCalls > 0) {
      this.#toldReport = report;
      this.#host.cost(report);
    }
    this.#host.changed();
  }

  #draw(moment: Moment, stage: boolean): void {
    this.#host.draw(moment, stage);
    const { frame } = moment;
    if (frame === null || frame === this.#toldFrame) return;
    this.#toldFrame = frame;
    this.#host.pose(cameraPose(frame, moment));
  }
}
