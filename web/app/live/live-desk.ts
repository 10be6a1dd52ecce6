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
import { CameraFollower } from '../../player/live/camera-follower.ts';
import type { ShownFrame } from '../../player/live/live-view.ts';
import { type Camera, type CameraChoice, listCameras } from '../../sources/camera.ts';
import type { PageEngine } from '../page-engine.ts';
import type { ClipFile } from '../recover-job.ts';
import { DEFAULT_SETTINGS, type Settings } from '../settings.ts';
import { CameraRecorder } from './camera-recorder.ts';

const TURNED = 'The camera was turned: the recording ends there.';
const PICTURE_LOST =
  'The picture could not be encoded to its end: the recording has its poses alone.';
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
  readonly #follower: CameraFollower;
  #cameras: readonly CameraChoice[] = [];
  #choices = DEFAULT_LIVE_CHOICES;
  #settings: Settings = DEFAULT_SETTINGS;
  #recording = false;
  #recovering = false;
  /** The one that is being started, and the one that runs. */
  #recorder: Promise<CameraRecorder> | null = null;
  #running: CameraRecorder | null = null;

  constructor(host: ReactiveControllerHost, engine: PageEngine, page: LivePage) {
    this.#host = host;
    this.#page = page;
    this.#follower = new CameraFollower({
      engine: () => engine.get(),
      draw: (view, stage) => page.draw(view, stage),
      isSlowToDraw: () => page.isSlowToDraw(),
      changed: () => host.requestUpdate(),
      failed: (error) => this.#fail(error),
    });
    host.addController(this);
  }

  /** A camera is on or being asked for. */
  get on(): boolean {
    return this.#follower.on;
  }

  get opening(): boolean {
    return this.#follower.opening;
  }

  get camera(): Camera | null {
    return this.#follower.camera;
  }

  get cameras(): readonly CameraChoice[] {
    return this.#cameras;
  }

  get choices(): LiveChoices {
    return this.#choices;
  }

  get status(): LiveStatus | null {
    return this.#follower.status;
  }

  get report(): LiveReport | null {
    return this.#follower.report;
  }

  /** The session itself, for measurements. */
  get session(): LiveSession | null {
    return this.#follower.session;
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
    if (this.opening) return;
    this.stop();
    this.#settings = settings;
    this.#page.say({ error: '', note: '', status: 'Asking for the camera.' });
    const camera = await this.#follower.start(() => this.#sessionSettings(), id);
    if (!camera) return;
    this.#choices = { ...this.#choices, mirrored: camera.facesUser };
    this.#host.requestUpdate();
    void this.#devicesChanged();
  }

  /** Switches the camera off. A recording that runs is thrown away. */
  stop(): void {
    this.#recording = false;
    this.#recovering = false;
    this.#recorder = null;
    void this.#running?.cancel();
    this.#running = null;
    this.#follower.stop();
  }

  /** Switches the camera off, and goes back to what was there before. */
  putAway(): void {
    this.stop();
    this.#page.stopped();
  }

  /** Another N or estimator. */
  change(settings: Settings): void {
    this.#settings = settings;
    this.#follower.change(this.#sessionSettings());
    this.#host.requestUpdate();
  }

  choose(choices: LiveChoices): void {
    const before = this.#choices;
    this.#choices = choices;
    const concerned = choices.mode !== before.mode || choices.load !== before.load;
    if (concerned) this.#follower.change(this.#sessionSettings());
    this.#host.requestUpdate();
  }

  /** A frame of the camera is on screen. */
  frame(shown: ShownFrame): void {
    this.#follower.frame(shown);
    this.#running?.add(shown);
    if (this.#recording && this.#running && this.session?.recordingUntil != null) {
      this.#page.say({ note: TURNED });
      void this.stopRecording();
    }
  }

  startRecording(): void {
    const { session } = this;
    if (!session || this.#recording || this.#recovering) return;
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
        if (this.#recorder !== recorder) return;
        this.#recorder = null;
        this.#recording = false;
        this.#recovering = false;
        this.#page.say({ error: messageOf(error) });
      },
    );
  }

  /** Recovers what was recorded, and hands it to the page. */
  async stopRecording(): Promise<void> {
    const starting = this.#recorder;
    if (!starting || !this.#recording) return;
    this.#recording = false;
    this.#recovering = true;
    this.#host.requestUpdate();
    const settings = this.#settings;
    // Thrown away meanwhile: the camera was put away, or something else was opened.
    const isOver = () => this.#recorder !== starting;
    try {
      const recorder = await starting;
      const recorded = isOver() ? null : await recorder.finish();
      if (isOver()) return;
      this.#recorder = null;
      this.#running = null;
      this.#recovering = false;
      if (recorded) {
        this.stop();
        this.#page.recorded(recorded.file, recorded.clip, settings);
        if (recorded.pictureLost) this.#page.say({ note: PICTURE_LOST });
      } else {
        this.#page.say({ error: NOTHING_RECORDED });
      }
    } catch (error) {
      if (!isOver()) this.#fail(error);
    }
    this.#host.requestUpdate();
  }

  #sessionSettings() {
    const { mode, load } = this.#choices;
    return { ...this.#settings, mode, load };
  }

  readonly #seen = () => {
    // The browser draws nothing in a hidden tab; figures would tell of that alone.
    if (document.hidden) this.#follower.forgetReport();
  };

  readonly #devicesChanged = async () => {
    if (!this.camera) return;
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
