import { css, html, LitElement, type PropertyValues } from 'lit';
import { property, query } from 'lit/decorators.js';
import type { LiveView as Moment } from '../../engine/live/types.ts';
import { BLAZEPOSE_33 } from '../../pose/blazepose33.ts';
import { type CameraFrame, watchCameraFrames } from '../../sources/camera-frames.ts';
import { element } from '../parts/element.ts';
import { prepareCanvas } from '../parts/hi-dpi-canvas.ts';
import { containedRect } from '../parts/letterbox.ts';
import { paintOverlay } from '../parts/overlay-painter.ts';
import { sharedStyles } from '../parts/styles.ts';
import { DelayedPictures } from './delayed-pictures.ts';

/** What the camera's `<video>` shows, and which frame that is. */
export interface ShownFrame {
  readonly video: HTMLVideoElement;
  readonly frame: CameraFrame;
}

/**
 * A camera's picture with the skeleton over it.
 *
 * @fires camera-frame with a {@link ShownFrame} as detail, for every frame of the camera
 * @fires picture with width by height as detail, once known
 */
@element('dw-live-view')
export class LiveView extends LitElement {
  @property({ attribute: false }) stream: MediaStream | null = null;
  @property({ type: Boolean, reflect: true }) mirrored = true;
  /** The picture is shown as late as the skeleton. */
  @property({ type: Boolean }) delayed = true;
  @query('video') private video!: HTMLVideoElement;
  @query('canvas') private canvas!: HTMLCanvasElement;
  private readonly pictures = new DelayedPictures();
  private stopWatching: (() => void) | null = null;

  static override styles = [
    sharedStyles,
    css`
      :host { display: block; position: relative; background: var(--video); overflow: hidden; }
      :host([mirrored]) { transform: scaleX(-1); }
      video, canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; }
      video { object-fit: contain; }
      canvas { pointer-events: none; }
    `,
  ];

  override render() {
    return html`
      <video
        data-testid="camera"
        playsinline
        muted
        aria-label="The camera’s picture"
        @resize=${this.resized}
      ></video>
      <canvas data-testid="overlay" aria-hidden="true"></canvas>
    `;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    // Moved within the page.
    if (this.hasUpdated) this.attach();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.release();
  }

  /** Holds the picture, so that no more frames come, or lets it go on. */
  rest(resting: boolean): void {
    if (resting) this.video.pause();
    else void this.video.play().catch(() => {});
  }

  /** Draws one moment over its picture. */
  paint({ time, pose }: Pick<Moment, 'time' | 'pose'>): void {
    const { video } = this;
    const area = this.canvas && prepareCanvas(this.canvas);
    if (!area || !video.videoWidth) return;
    const picture = containedRect(area, { width: video.videoWidth, height: video.videoHeight });
    const late = this.delayed ? this.pictures.at(time) : null;
    if (late) {
      area.context.drawImage(late, picture.x, picture.y, picture.width, picture.height);
    }
    if (!pose) return;
    const sequence = {
      skeleton: BLAZEPOSE_33,
      dims: 2,
      times: Float64Array.of(time),
      values: pose.values2d,
      scores: pose.scores,
      watched: Uint8Array.of(0),
    } as const;
    paintOverlay(area.context, sequence, 0, picture, video.videoWidth, pose.presence);
  }

  protected override updated(changes: PropertyValues<this>): void {
    if (changes.has('stream')) this.attach();
  }

  private attach(): void {
    this.release();
    if (!this.stream) return;
    // Lit sets attributes, and a muted attribute that is set late does not mute.
    this.video.muted = true;
    this.video.srcObject = this.stream;
    void this.video.play().catch(() => {});
    this.stopWatching = watchCameraFrames(this.video, this.shown);
  }

  private readonly shown = (frame: CameraFrame) => {
    if (this.delayed) this.pictures.add(this.video, frame.time);
    else this.pictures.clear();
    const detail: ShownFrame = { video: this.video, frame };
    this.dispatchEvent(new CustomEvent<ShownFrame>('camera-frame', { detail }));
  };

  private resized(): void {
    const { videoWidth, videoHeight } = this.video;
    if (videoHeight === 0) return;
    this.dispatchEvent(new CustomEvent<number>('picture', { detail: videoWidth / videoHeight }));
  }

  private release(): void {
    this.stopWatching?.();
    this.stopWatching = null;
    this.pictures.clear();
    if (this.video) this.video.srcObject = null;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-live-view': LiveView;
  }
}
