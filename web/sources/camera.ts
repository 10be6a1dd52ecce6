import type { DeciWatchError } from '../errors.ts';
import { cameraError, cameraLost, insecurePage } from './camera-errors.ts';

/** Enough for the estimator, which looks at 256 × 256 pixels of the person, and quick to copy. */
const WANTED = { width: { ideal: 640 }, height: { ideal: 480 }, frameRate: { ideal: 30, max: 60 } };

/** A camera that can be chosen. */
export interface CameraChoice {
  /** For {@link openCamera}. */
  readonly id: string;
  /** For people; `Camera 1` and so on as long as the browser does not tell. */
  readonly label: string;
}

/** A camera that is on. Whoever opened it closes it, which switches its light off. */
export interface Camera {
  /** For the `srcObject` of a `<video>`. */
  readonly stream: MediaStream;
  readonly id: string;
  readonly label: string;
  /** It looks at the person in front of the screen, who expects a mirror. */
  readonly facesUser: boolean;
  /** Told once if the camera goes away by itself: unplugged, or its permission withdrawn. */
  onLost: ((error: DeciWatchError) => void) | null;
  /** Switches it off. */
  close(): void;
}

/**
 * Asks for a camera; the browser may ask the person. To be called on a click.
 * @param id of the one to open; else the browser's choice, facing the user where there are several
 * @throws DeciWatchError `camera-refused`, `camera-missing`, `camera-busy` or `camera-insecure`
 */
export async function openCamera(id?: string): Promise<Camera> {
  if (!globalThis.isSecureContext || !navigator.mediaDevices?.getUserMedia) throw insecurePage();
  const which = id ? { deviceId: { exact: id } } : { facingMode: 'user' };
  let stream: MediaStream;
  try {
    stream = await navigator.mediaDevices.getUserMedia({
      audio: false,
      video: { ...WANTED, ...which },
    });
  } catch (error) {
    throw cameraError(error);
  }
  const track = stream.getVideoTracks()[0];
  if (!track) throw cameraError(new DOMException('No video track', 'NotFoundError'));
  return new TrackCamera(stream, track);
}

/** The cameras that there are; without labels until one has been allowed. */
export async function listCameras(): Promise<CameraChoice[]> {
  const devices = (await navigator.mediaDevices?.enumerateDevices()) ?? [];
  return devices
    .filter(({ kind, deviceId }) => kind === 'videoinput' && deviceId !== '')
    .map(({ deviceId, label }, i) => ({ id: deviceId, label: label || `Camera ${i + 1}` }));
}

class TrackCamera implements Camera {
  readonly id: string;
  readonly label: string;
  readonly facesUser: boolean;
  onLost: ((error: DeciWatchError) => void) | null = null;

  constructor(
    readonly stream: MediaStream,
    private readonly track: MediaStreamTrack,
  ) {
    const { deviceId, facingMode } = track.getSettings();
    this.id = deviceId ?? '';
    this.label = track.label;
    // A computer's own camera says nothing, and faces its user.
    this.facesUser = facingMode !== 'environment';
    track.addEventListener('ended', this.#ended);
  }

  close(): void {
    this.track.removeEventListener('ended', this.#ended);
    for (const track of this.stream.getTracks()) track.stop();
  }

  readonly #ended = () => {
    this.close();
    this.onLost?.(cameraLost());
  };
}
