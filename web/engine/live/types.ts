import type { LiveReport } from '../../cost/live-meter.ts';
import type { DeciWatchError } from '../../errors.ts';
import type { EstimatorName } from '../../estimators/names.ts';
import type { LoadPolicy } from '../../sampling/live-sampler.ts';
import type { CameraFrame } from '../../sources/camera-frames.ts';
import type { RecoveredClip } from '../types.ts';
import type { LivePose } from './track.ts';

export type { LivePose, LiveReport, LoadPolicy };

/**
 * `smooth`: shown one interval late, recovered between two watched frames. `now`: shown at once; what
 * comes after the last watched frame is foreseen.
 */
export type LiveMode = 'smooth' | 'now';

/** How a camera is to be followed. */
export interface LiveSettings {
  /** N, 1 to 20: the estimator watches one camera frame in N. */
  readonly every: number;
  /** One of those that come with the package. */
  readonly estimator: EstimatorName;
  readonly mode: LiveMode;
  readonly load: LoadPolicy;
}

/**
 * What is going on, in one word. `loading`: models come. `waiting`: no camera frame comes (the tab was
 * hidden, or the camera is starting). `looking`: frames come, nobody is in view. `following`: somebody is.
 * `lost`: somebody was, a moment ago.
 */
export type LiveState = 'loading' | 'waiting' | 'looking' | 'following' | 'lost';

/** How a {@link LiveSession} stands. */
export interface LiveStatus {
  readonly state: LiveState;
  /** N in force; larger than the one asked for while the estimator is too slow for that. */
  readonly every: number;
  /** Frames per second of the camera, measured; 0 until known. */
  readonly frameRate: number;
}

/** What to draw at one moment. */
export interface LiveView {
  /** Seconds: the capture time of what is shown. */
  readonly time: number;
  /** Seconds: the capture time of the last camera frame up to `time`; null while there is none. */
  readonly frame: number | null;
  /** The estimator looked at that frame. */
  readonly watched: boolean;
  /** Null where nobody is to be drawn. */
  readonly pose: LivePose | null;
}

/** Live playback of one camera on the engine. Whoever opened it closes it. */
export interface LiveSession {
  /** As they were asked for last. */
  readonly settings: LiveSettings;
  readonly status: LiveStatus;
  /** What the last ten seconds cost. */
  readonly report: LiveReport;
  /** Since the start: camera frames, those never seen, estimator calls, frames whose skeleton was drawn. */
  readonly totals: Readonly<{ frames: number; missed: number; calls: number; shown: number }>;
  /** The camera's picture in pixels, once its first frame is there. */
  readonly size: { readonly width: number; readonly height: number } | null;
  /** Told when `status` has changed. */
  onStatus: (() => void) | null;
  /** Told once, when it cannot go on. */
  onError: ((error: DeciWatchError) => void) | null;
  /**
   * Takes effect from the next camera frame on.
   * @throws DeciWatchError `bad-option`
   */
  change(settings: LiveSettings): void;
  /**
   * A camera frame is on screen in its `<video>`: to be called for each, as {@link watchCameraFrames} tells
   * of them. The session decides which are watched.
   */
  frame(video: HTMLVideoElement, frame: CameraFrame): void;
  /**
   * What to draw now. Counted as drawn.
   * @param now seconds on the page's clock, `performance.now() / 1000`
   */
  view(now: number): LiveView;
  /** Keeps what is needed to recover this stretch like a file. */
  startRecording(): void;
  /**
   * Ends the recording with the next look, and recovers all of its frames.
   * @param name for {@link RecoveredClip.source}
   * @returns its poses, times from 0; null where it was too short or nobody was seen
   */
  stopRecording(name: string): Promise<RecoveredClip | null>;
  /** When the recording began, in seconds on the page's clock; null while there is none. */
  readonly recordingSince: number | null;
  /** When it ended, on the same clock, while its frames are still being recovered. */
  readonly recordingUntil: number | null;
  /** Ends the session. The engine and the camera stay open. */
  close(): void;
}
