import type { CostReport } from '../cost/report.ts';
import type { LiveMode, LiveReport } from '../engine/live/types.ts';
import type { RecoveredClip, RecoverProgress } from '../engine/types.ts';
import type { DeciWatchErrorCode } from '../errors.ts';
import type { PoseEstimator } from '../estimators/estimator.ts';
import type { EstimatorName } from '../estimators/names.ts';
import type { PoseSequence } from '../pose/sequence.ts';

/** What a player shows: the video with its 2D skeleton, the 3D view, or the two side by side. */
export type PlayerView = 'overlay' | 'stage' | 'both';

/** When a player fetches its clip and the models: once it is asked to play, or as soon as it is in view. */
export type PlayerPreload = 'none' | 'metadata' | 'auto';

/** One frame's pose, as the `pose` event tells it. */
export interface PoseDetail {
  /** Seconds: the file's own timestamp, or the camera's capture time on the page's clock. */
  readonly time: number;
  /** The frame's place in the clip, from 0; null where it is a camera's. */
  readonly frame: number | null;
  /** The estimator looked at this frame; otherwise its pose was recovered. */
  readonly watched: boolean;
  /** K·2 pixels of the picture as displayed, origin top left; null where nobody was seen. */
  readonly keypoints: Float32Array | null;
  /** K·3 metres relative to the mid-hip: x right, y up, z towards the camera; null as above. */
  readonly keypoints3d: Float32Array | null;
  /** K scores, 0 to 1; null as above. */
  readonly scores: Float32Array | null;
}

/** What went wrong, as the `error` event tells it. */
export interface PlayerErrorDetail {
  readonly type: DeciWatchErrorCode;
  /** One sentence for people: what was wrong and what to do. The player shows it too. */
  readonly message: string;
  readonly cause: unknown;
  /** Nothing can be played; otherwise the rest goes on (the video without the 3D view, say). */
  readonly fatal: boolean;
}

/** The player's own events; each is a `CustomEvent` with this as its `detail`. None bubbles. */
export interface PlayerEventMap {
  /** The poses of the clip are there. */
  load: CustomEvent<RecoveredClip>;
  /** Models are loaded, frames watched, poses recovered. */
  progress: CustomEvent<RecoverProgress>;
  /**
   * A frame is on screen. While playing, none is left out: frames that the screen was too slow for are
   * told before the one that it shows.
   */
  pose: CustomEvent<PoseDetail>;
  /** What the clip cost, once; with a camera, twice a second, what the last ten seconds cost. */
  cost: CustomEvent<CostReport | LiveReport>;
  error: CustomEvent<PlayerErrorDetail>;
}

/**
 * `<deciwatch-player>`: plays a video, or a camera, with a skeleton for every frame. Attributes and
 * properties have the names of `<video>`'s where they mean the same.
 */
export interface DeciWatchPlayer extends HTMLElement {
  /** Address of the clip, relative to the page. Another host's must allow it (CORS). */
  src: string;
  /** A clip that is in the page already, instead of `src`. */
  srcObject: Blob | null;
  /** Follows the camera instead of a clip. */
  camera: boolean;
  /** N, 1 to 20: the estimator watches one frame in N. */
  every: number;
  /** One of MediaPipe's variants, by name; or, for clips and as a property only, one of the page's own. */
  estimator: EstimatorName | PoseEstimator;
  /** With a camera: one interval late, or at once. */
  mode: LiveMode;
  view: PlayerView;
  /** Shows the bar with play, the frames, sound and views. */
  controls: boolean;
  autoplay: boolean;
  loop: boolean;
  muted: boolean;
  /** 0 to 1; anything else throws. */
  volume: number;
  /** 1 is the clip's own speed; below 1/16 and above 16 it throws. */
  playbackRate: number;
  /** Address of a picture that is shown before playing. */
  poster: string;
  /** Shows the picture as in a mirror. */
  mirror: boolean;
  preload: PlayerPreload;
  /** Address of a folder with `models/` and `estimators/`; relative to the page. See {@link EngineOptions}. */
  models: string;
  /** Seconds from the clip's first frame to the start of the one on screen; at the end, the duration. */
  currentTime: number;
  /** Seconds; NaN until the clip is there. */
  readonly duration: number;
  readonly paused: boolean;
  readonly ended: boolean;
  /** Pixels of the picture as displayed; 0 until known. */
  readonly videoWidth: number;
  readonly videoHeight: number;
  /** What made the last `error` event; null once something else is played. */
  readonly error: PlayerErrorDetail | null;
  /** The 2D poses of the clip, in pixels; null until they are there. */
  readonly poses: PoseSequence | null;
  /** The 3D poses of the clip, in metres; null until they are there. */
  readonly poses3d: PoseSequence | null;
  /** All that is known of the clip: poses, cost, size. */
  readonly clip: RecoveredClip | null;
  /** Starts once the poses are there. Never rejects: what goes wrong is told by `error`. */
  play(): Promise<void>;
  pause(): void;
  /** Fetches the clip and recovers its poses, without playing it. Never rejects. */
  load(): Promise<void>;

  /** As of any element; {@link PlayerEventMap} lists the player's own events. */
  addEventListener<K extends keyof PlayerEventMap>(
    type: K,
    listener: (this: DeciWatchPlayer, event: PlayerEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener<K extends Exclude<keyof HTMLElementEventMap, keyof PlayerEventMap>>(
    type: K,
    listener: (this: DeciWatchPlayer, event: HTMLElementEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  /** As of any element. */
  removeEventListener<K extends keyof PlayerEventMap>(
    type: K,
    listener: (this: DeciWatchPlayer, event: PlayerEventMap[K]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener<K extends Exclude<keyof HTMLElementEventMap, keyof PlayerEventMap>>(
    type: K,
    listener: (this: DeciWatchPlayer, event: HTMLElementEventMap[K]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'deciwatch-player': DeciWatchPlayer;
  }
}
