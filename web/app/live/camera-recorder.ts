import type { LiveSession } from '../../engine/live/types.ts';
import type { RecoveredClip } from '../../engine/types.ts';
import type { ShownFrame } from '../../player/live/live-view.ts';
import type { ClipFile } from '../recover-job.ts';
import { blankVideo } from './blank-video.ts';
import { PictureRecorder } from './picture-recorder.ts';

/** A recording that can be played: its video, black where the picture was not kept, and its poses. */
export interface Recorded {
  readonly file: ClipFile;
  readonly clip: RecoveredClip;
  /** The picture was asked for, but the encoder gave up. */
  readonly pictureLost: boolean;
}

/** One recording of a live session, perhaps with the camera's picture. */
export class CameraRecorder {
  #pictures: PictureRecorder | null = null;
  #over = false;

  private constructor(private readonly session: LiveSession) {}

  /**
   * @param keepPicture encodes the camera's picture too
   * @throws DeciWatchError `browser-unsupported` where the picture cannot be encoded
   */
  static async start(session: LiveSession, keepPicture: boolean): Promise<CameraRecorder> {
    const recorder = new CameraRecorder(session);
    const { size } = session;
    if (keepPicture && size) {
      recorder.#pictures = await PictureRecorder.start(size.width, size.height);
    }
    session.startRecording();
    return recorder;
  }

  /** A frame of the camera is on screen. */
  add({ video, frame }: ShownFrame): void {
    const { recordingSince: since, recordingUntil: until } = this.session;
    if (this.#over || since === null || frame.time < since) return;
    if (until === null || frame.time <= until) this.#pictures?.add(video, frame.time);
  }

  /** Recovers what was recorded; null where nobody was seen, or it was too short. */
  async finish(): Promise<Recorded | null> {
    const pictures = this.#pictures;
    const stamp = new Date().toISOString().slice(0, 19).replaceAll(':', '-');
    const name = `recording-${stamp}.${pictures?.mimeType.includes('mp4') ? 'mp4' : 'webm'}`;
    const clip = await this.session.stopRecording(name);
    this.#over = true;
    if (!clip) {
      await this.cancel();
      return null;
    }
    const { width, height } = clip.source;
    // The poses are whole, whatever became of the picture.
    const picture = await pictures?.finish().catch(() => null);
    const blob = picture ?? (await blankVideo(clip.poses2d.times, width / height));
    return {
      file: { blob, name, blank: !picture },
      clip,
      pictureLost: Boolean(pictures && !picture),
    };
  }

  /** Throws it away. */
  async cancel(): Promise<void> {
    this.#over = true;
    await this.#pictures?.cancel().catch(() => {});
  }
}
