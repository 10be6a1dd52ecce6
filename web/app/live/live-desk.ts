import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type {
  LiveMode,
  LiveReport,
  LiveSession,
  LiveStatus,
  LiveView,
  LoadPolicy,
} from '../../engine/live/types.ts';
import type { RecoveredClip } from '../../engine/types.ts';
import { DeciWatchError } from '../../errors.ts';
import { DrawGovernor } from '../../player/live/draw-governor.ts';
import type { ShownFrame } from '../../player/live/live-view.ts';
import { type Camera, type CameraChoice, listCameras, openCamera } from '../../sources/camera.ts';
import type { PageEngine } from '../page-engine.ts';
import type { ClipFile } from '../recover-job.ts';
import { DEFAULT_SETTINGS, type Settings } from '../settings.ts';
import { CameraRecorder } from './camera-recorder.ts';

/** Figures change so many times a second. */
const REPORT_MS = 500;

const NOTHING_DRAWN = { frame: null, presence: 0 };

const NOTHING_RECORDED =
  'Nothing was recorded: nobody was seen, or it was too short; record for a second or more.';

/** What somebody chooses of live playback beside N and the estimator. */
export interface LiveChoices {
  readonly mode: LiveMode;
  readonly load: LoadPolicy;
  readonly mirrored: boolean;
  /** Recordings keep the camera's picture. */
  readonly keepPicture: boolean;
}

export const DEFAULT_LIVE_CHOICES: LiveChoices = {
  mode: 'smooth',
  load: 'adapt',
  mirrored: true,
  keepPicture: false,
};

/** What the desk needs of the page. */
export interface LivePage {
  /** Draws one moment, in the 3D view too where `stage` says so. */
  draw(view: LiveView, stage: boolean): void;
  /** Each picture is drawn by the processor: as often as the camera's is often enough. */
  isSlowToDraw(): boolean;
  /** A recording is ready to be played. */
  recorded(file: ClipFile, clip: RecoveredClip, settings: Settings): void;
  /** The camera was put away, with nothing recorded: what was there before shows again. */
  stopped(): void;
  /** One sentence for people. */
  say(words: { error?: string; note?: string; status?: string }): void;
}

/** The camera on the page's desk: opens it, follows whom it sees, records, and puts it away. */
export class LiveDesk implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #page: LivePage;
  readonly #engine: PageEngine;
  #camera: Camera | null = null;
  #session: LiveSession | null = null;
  #opening = false;
  #cameras: readonly CameraChoice[] = [];
  #choices = DEFAULT_LIVE_CHOICES;
  #settings: Settings = DEFAULT_SETTINGS;
  #report: LiveReport | null = null;
  #frameRequest = 0;
  #reportTimer = 0;
  /** What the last picture showed. */
  #drawn: { frame: number | null; presence: number } = NOTHING_DRAWN;
  #governor = new DrawGovernor();
  #recording = false;
  #recovering = false;
  /** The one that is being started, and the one that runs. */
  #recorder: Promise<CameraRecorder> | null = null;
  #running: CameraRecorder | null = null;

  constructor(host: ReactiveControllerHost, engine: PageEngine, page: LivePage) {
    this.#host = host;
    this.#engine = engine;
    this.#page = page;
    host.addController(this);
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

  get cameras(): readonly CameraChoice[] {
    return this.#cameras;
  }

  get choices(): LiveChoices {
    return this.#choices;
  }

  get status(): LiveStatus | null {
    return this.#session?.status ?? null;
  }

  get report(): LiveReport | null {
    return this.#report;
  }

  /** The session itself, for measurements. */
  get session(): LiveSession | null {
    return this.#session;
  }

  get recording(): boolean {
    return this.#recording;
  }

  /** The frames of a recording are being recovered. */
  get recovering(): boolean {
    return this.#recovering;
  }

  hostConnected(): void {
    document.addEventListener('visibilitychange', this.#seen);
    navigator.mediaDevices?.addEventListener('devicechange', this.#devicesChanged);
  }

  hostDisconnected(): void {
    document.removeEventListener('visibilitychange', this.#seen);
    navigator.mediaDevices?.removeEventListener('devicechange', this.#devicesChanged);
    this.stop();
  }

  /**
   * Asks for the camera and follows whom it sees.
   * @param id another camera than the browser's own choice
   */
  async start(settings: Settings, id?: string): Promise<void> {
    if (this.#opening) return;
    this.stop();
    this.#settings = settings;
    this.#opening = true;
    this.#page.say({ error: '', note: '', status: 'Asking for the camera.' });
    this.#host.requestUpdate();
    try {
      const camera = await openCamera(id);
      if (!this.#opening) {
        camera.close();
        return;
      }
      this.#camera = camera;
      camera.onLost = (error) => this.#fail(error);
      this.#choices = { ...this.#choices, mirrored: camera.facesUser };
      this.#open();
      void this.#devicesChanged();
    } catch (error) {
      this.#fail(error);
    } finally {
      this.#opening = false;
      this.#host.requestUpdate();
    }
  }

  /** Switches the camera off. A recording that runs is thrown away. */
  stop(): void {
    cancelAnimationFrame(this.#frameRequest);
    clearInterval(this.#reportTimer);
    this.#opening = false;
    this.#recording = false;
    this.#recorder = null;
    void this.#running?.cancel();
    this.#running = null;
    this.#session?.close();
    this.#session = null;
    this.#camera?.close();
    this.#camera = null;
    this.#report = null;
    this.#host.requestUpdate();
  }

  /** Switches the camera off, and goes back to what was there before. */
  putAway(): void {
    this.stop();
    this.#page.stopped();
  }

  /** Another N or estimator. */
  change(settings: Settings): void {
    this.#settings = settings;
    this.#session?.change(this.#sessionSettings());
    this.#host.requestUpdate();
  }

  choose(choices: LiveChoices): void {
    const before = this.#choices;
    this.#choices = choices;
    const concerned = choices.mode !== before.mode || choices.load !== before.load;
    if (concerned) this.#session?.change(this.#sessionSettings());
    this.#host.requestUpdate();
  }

  /** A frame of the camera is on screen. */
  frame(shown: ShownFrame): void {
    this.#session?.frame(shown.video, shown.frame);
    this.#running?.add(shown);
  }

  startRecording(): void {
    const session = this.#session;
    if (!session || this.#recording) return;
    this.#recording = true;
    this.#page.say({ status: 'Recording.' });
    const recorder = CameraRecorder.start(session, this.#choices.keepPicture);
    this.#recorder = recorder;
    recorder.then(
      (started) => {
        if (this.#recorder === recorder) this.#running = started;
        else void started.cancel();
      },
      (error) => {
        this.#recording = false;
        this.#page.say({ error: messageOf(error) });
      },
    );
  }

  /** Recovers what was recorded, and hands it to the page. */
  async stopRecording(): Promise<void> {
    const recorder = this.#running;
    if (!recorder || !this.#recording) return;
    this.#recording = false;
    this.#recovering = true;
    this.#host.requestUpdate();
    const settings = this.#settings;
    try {
      const recorded = await recorder.finish();
      this.#running = null;
      if (recorded) {
        this.stop();
        this.#page.recorded(recorded.file, recorded.clip, settings);
      } else {
        this.#page.say({ error: NOTHING_RECORDED });
      }
    } catch (error) {
      this.#fail(error);
    } finally {
      this.#recovering = false;
      this.#host.requestUpdate();
    }
  }

  #open(): void {
    const session = this.#engine.get().live(this.#sessionSettings());
    this.#session = session;
    session.onStatus = () => this.#host.requestUpdate();
    session.onError = (error) => this.#fail(error);
    this.#reportTimer = setInterval(() => {
      this.#report = session.report;
      this.#host.requestUpdate();
    }, REPORT_MS) as unknown as number;
    this.#drawn = NOTHING_DRAWN;
    this.#governor = new DrawGovernor();
    this.#frameRequest = requestAnimationFrame(this.#draw);
  }

  #sessionSettings() {
    const { mode, load } = this.#choices;
    return { ...this.#settings, mode, load };
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
    if (this.#page.isSlowToDraw() && !fresh) return;
    this.#drawn = { frame, presence };
    this.#page.draw(view, this.#governor.offer(stamp));
  };

  readonly #seen = () => {
    // The browser draws nothing in a hidden tab; figures would tell of that alone.
    if (document.hidden) this.#report = null;
    this.#host.requestUpdate();
  };

  readonly #devicesChanged = async () => {
    if (!this.#camera) return;
    this.#cameras = await listCameras();
    this.#host.requestUpdate();
  };

  #fail(error: unknown): void {
    this.putAway();
    this.#page.say({ error: messageOf(error), status: '' });
  }
}

function messageOf(error: unknown): string {
  if (error instanceof DeciWatchError) return error.message;
  const detail = error instanceof Error ? error.message : String(error);
  return `Something failed that should not have (${detail}): please start the camera again.`;
}
