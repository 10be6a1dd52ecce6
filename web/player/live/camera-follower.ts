import type {
  LiveReport,
  LiveSession,
  LiveSettings,
  LiveStatus,
  LiveView,
} from '../../engine/live/types.ts';
import type { Engine } from '../../engine/types.ts';
import { type Camera, openCamera } from '../../sources/camera.ts';
import { DrawGovernor } from './draw-governor.ts';
import type { ShownFrame } from './live-view.ts';

/** Figures change so many times a second. */
const REPORT_MS = 500;

const NOTHING_DRAWN = { frame: null, presence: 0 };

/** What the follower needs of whoever shows the camera. */
export interface FollowerHost {
  /** The engine that follows; asked for once the camera is open. */
  engine(): Engine;
  /** Draws one moment, in the 3D view too where `stage` says so. */
  draw(view: LiveView, stage: boolean): void;
  /** Each picture is drawn by the processor: as often as the camera's is often enough. */
  isSlowToDraw(): boolean;
  /** The state or the figures are other ones. */
  changed(): void;
  /** It cannot go on, and has let go of the camera. */
  failed(error: unknown): void;
}

/** Opens a camera, follows whom it sees, and draws with every picture of the screen. */
export class CameraFollower {
  readonly #host: FollowerHost;
  #camera: Camera | null = null;
  #session: LiveSession | null = null;
  #opening = false;
  /** The newest start that nothing has stopped. */
  #asked: object | null = null;
  #report: LiveReport | null = null;
  #frameRequest = 0;
  #reportTimer = 0;
  /** What the last picture showed. */
  #drawn: { frame: number | null; presence: number } = NOTHING_DRAWN;
  #governor = new DrawGovernor();

  constructor(host: FollowerHost) {
    this.#host = host;
  }

  /** A camera is on or being asked for. */
  get on(): boolean {
    return this.#opening || this.#camera !== null;
  }

  get opening(): boolean {
    return this.#opening;
  }

  get camera(): Camera | null {
    return this.#camera;
  }

  get session(): LiveSession | null {
    return this.#session;
  }

  get status(): LiveStatus | null {
    return this.#session?.status ?? null;
  }

  get report(): LiveReport | null {
    return this.#report;
  }

  /**
   * Asks for the camera and follows whom it sees.
   * @param settings as they are when the camera is open
   * @param id another camera than the browser's own choice
   * @returns the camera; null where it failed, which the host has been told, or was stopped meanwhile
   */
  async start(settings: () => LiveSettings, id?: string): Promise<Camera | null> {
    if (this.#opening) return null;
    this.stop();
    this.#opening = true;
    const asked = {};
    this.#asked = asked;
    this.#host.changed();
    try {
      // What cannot be followed is not asked for.
      settings();
      const camera = await openCamera(id);
      if (this.#asked !== asked) {
        camera.close();
        return null;
      }
      this.#camera = camera;
      camera.onLost = (error) => this.#fail(error);
      this.#follow(settings());
      return camera;
    } catch (error) {
      if (this.#asked === asked) this.#fail(error);
      return null;
    } finally {
      if (this.#asked === asked) {
        this.#opening = false;
        this.#host.changed();
      }
    }
  }

  change(settings: LiveSettings): void {
    this.#session?.change(settings);
  }

  /** A frame of the camera is on screen. */
  frame({ video, frame }: ShownFrame): void {
    this.#session?.frame(video, frame);
  }

  /** Figures of a time when nothing was drawn tell of that alone. */
  forgetReport(): void {
    this.#report = null;
    this.#host.changed();
  }

  /** Switches the camera off. */
  stop(): void {
    cancelAnimationFrame(this.#frameRequest);
    clearInterval(this.#reportTimer);
    this.#opening = false;
    this.#asked = null;
    this.#session?.close();
    this.#session = null;
    this.#camera?.close();
    this.#camera = null;
    this.#report = null;
    this.#host.changed();
  }

  #follow(settings: LiveSettings): void {
    const session = this.#host.engine().live(settings);
    this.#session = session;
    session.onStatus = () => this.#host.changed();
    session.onError = (error) => this.#fail(error);
    this.#reportTimer = setInterval(() => {
      this.#report = session.report;
      this.#host.changed();
    }, REPORT_MS) as unknown as number;
    this.#drawn = NOTHING_DRAWN;
    this.#governor = new DrawGovernor();
    this.#frameRequest = requestAnimationFrame(this.#draw);
  }

  readonly #draw = (stamp: number) => {
    const session = this.#session;
    if (!session) return;
    this.#frameRequest = requestAnimationFrame(this.#draw);
    const view = session.view(performance.now() / 1000);
    const { frame } = view;
    const presence = view.pose?.presence ?? 0;
    // Somebody fades also where no more frames come.
    const fresh = frame !== this.#drawn.frame || presence !== this.#drawn.presence;
    if (this.#host.isSlowToDraw() && !fresh) return;
    this.#drawn = { frame, presence };
    this.#host.draw(view, this.#governor.offer(stamp));
  };

  #fail(error: unknown): void {
    this.stop();
    this.#host.failed(error);
  }
}
