import { LitElement } from 'lit';
import { property } from 'lit/decorators.js';
import type { LiveMode } from '../engine/live/types.ts';
import type { PoseEstimator } from '../estimators/estimator.ts';
import { DEFAULT_ESTIMATOR, type EstimatorName } from '../estimators/names.ts';
import type { PlayerPreload, PlayerView } from './types.ts';

const DEFAULT_EVERY = 10;

/** Browsers refuse to play slower or faster. */
const SLOWEST = 1 / 16;
const FASTEST = 16;

/** An estimator of the page's own has no place in an attribute. */
const ESTIMATOR = {
  fromAttribute: (name: string | null) => (name ?? DEFAULT_ESTIMATOR) as EstimatorName,
  toAttribute: (value: unknown) => (typeof value === 'string' ? value : null),
};

/** What says what is played. */
export const SOURCE = ['src', 'srcObject', 'camera', 'models'] as const;

/** What says how a clip's poses are recovered. */
export const SETTINGS = ['every', 'estimator'] as const;

/** What says how the camera is followed. */
export const LIVE_SETTINGS = [...SETTINGS, 'mode'] as const;

/** The player's attributes and the properties that can be set; `DeciWatchPlayer` says what they mean. */
export class PlayerProperties extends LitElement {
  @property({ reflect: true, useDefault: true }) src = '';
  @property({ attribute: false }) srcObject: Blob | null = null;
  @property({ type: Boolean, reflect: true }) camera = false;
  @property({ type: Number, reflect: true, useDefault: true }) every = DEFAULT_EVERY;
  @property({ reflect: true, useDefault: true, converter: ESTIMATOR })
  estimator: EstimatorName | PoseEstimator = DEFAULT_ESTIMATOR;
  @property({ reflect: true, useDefault: true }) mode: LiveMode = 'smooth';
  @property({ reflect: true, useDefault: true }) view: PlayerView = 'both';
  @property({ type: Boolean, reflect: true }) controls = false;
  @property({ type: Boolean, reflect: true }) autoplay = false;
  @property({ type: Boolean, reflect: true }) loop = false;
  @property({ type: Boolean }) muted = false;
  @property({ reflect: true, useDefault: true }) poster = '';
  @property({ type: Boolean, reflect: true }) mirror = false;
  @property({ reflect: true, useDefault: true }) preload: PlayerPreload = 'metadata';
  @property({ reflect: true, useDefault: true }) models = '';
  private loudness = 1;
  private speed = 1;

  @property({ attribute: false })
  get volume(): number {
    return this.loudness;
  }

  set volume(volume: number) {
    if (!(volume >= 0 && volume <= 1)) {
      throw new DOMException(`The volume ${volume} is not between 0 and 1.`, 'IndexSizeError');
    }
    this.loudness = volume;
  }

  @property({ attribute: false })
  get playbackRate(): number {
    return this.speed;
  }

  set playbackRate(rate: number) {
    if (!(rate >= SLOWEST && rate <= FASTEST)) {
      const words = `The playback rate ${rate} is not between ${SLOWEST} and ${FASTEST}.`;
      throw new DOMException(words, 'NotSupportedError');
    }
    this.speed = rate;
  }
}
