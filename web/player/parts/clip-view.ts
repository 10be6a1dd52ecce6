import { css, html, LitElement, type PropertyValues } from 'lit';
import { property, query } from 'lit/decorators.js';
import type { RecoveredClip } from '../../engine/types.ts';
import { element } from './element.ts';
import { prepareCanvas } from './hi-dpi-canvas.ts';
import { containedRect } from './letterbox.ts';
import { paintOverlay } from './overlay-painter.ts';
import { Playback, type PlaybackState } from './playback.ts';
import { sharedStyles } from './styles.ts';

/**
 * The video with the 2D skeleton over it.
 *
 * @fires playback with a {@link PlaybackState} as detail, when another frame is on screen and when playing starts or stops
 * @fires picture with the video's width by height as detail, once known
 * @fires toggle when the picture is clicked
 * @fires media with the type of each event of the `<video>` that a page may want as detail
 * @fires unplayable when the browser cannot show the file
 */
@element('dw-clip-view')
export class ClipView extends LitElement {
  /** Object URL of the clip. */
  @property({ attribute: false }) src: string | null = null;
  @property({ attribute: false }) clip: RecoveredClip | null = null;
  @property({ attribute: false }) frame = 0;
  @property({ type: Boolean }) muted = true;
  @property({ type: Number }) rate = 1;
  @property({ type: Number }) volume = 1;
  @property({ attribute: false }) loop = true;
  /** How much of the video is fetched before it plays. */
  @property({ attribute: false }) preload: 'none' | 'metadata' | 'auto' = 'auto';
  /** Shown as in a mirror. */
  @property({ type: Boolean, reflect: true }) mirrored = false;
  @query('video') readonly video!: HTMLVideoElement;
  @query('canvas') private canvas!: HTMLCanvasElement;
  /** Null until the first render. */
  playback: Playback | null = null;
  private readonly resizes = new ResizeObserver(() => this.paint());

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

  override connectedCallback(): void {
    super.connectedCallback();
    this.resizes.observe(this);
    if (this.hasUpdated) this.attach();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resizes.disconnect();
    this.playback?.dispose();
    this.playback = null;
  }

  override render() {
    return html`
      <video
        data-testid="video"
        playsinline
        crossorigin="anonymous"
        .loop=${this.loop}
        .preload=${this.preload}
        .volume=${this.volume}
        aria-label="The video"
        .muted=${this.muted}
        @click=${() => this.dispatchEvent(new CustomEvent('toggle'))}
        @error=${() => this.dispatchEvent(new CustomEvent('unplayable'))}
        @loadedmetadata=${this.loaded}
        @durationchange=${this.forward}
        @play=${this.forward}
        @pause=${this.forward}
        @ended=${this.forward}
        @timeupdate=${this.forward}
        @seeking=${this.forward}
        @seeked=${this.forward}
        @volumechange=${this.forward}
        @ratechange=${this.forward}
      ></video>
      <canvas data-testid="overlay" aria-hidden="true"></canvas>
    `;
  }

  protected override firstUpdated(): void {
    this.attach();
  }

  protected override updated(changes: PropertyValues<this>): void {
    if (changes.has('src')) {
      if (this.src) this.video.src = this.src;
      else {
        this.video.removeAttribute('src');
        this.video.load();
      }
    }
    if (changes.has('clip')) this.playback?.setTimes(this.clip?.poses2d.times ?? null);
    if (changes.has('rate')) this.setRate();
    this.paint();
  }

  private forward(event: Event): void {
    this.dispatchEvent(new CustomEvent<string>('media', { detail: event.type }));
  }

  private loaded(event: Event): void {
    this.setRate();
    this.forward(event);
    const { videoWidth, videoHeight } = this.video;
    // A file with nothing but sound has no picture.
    if (videoHeight === 0) return;
    this.dispatchEvent(new CustomEvent<number>('picture', { detail: videoWidth / videoHeight }));
  }

  private setRate(): void {
    // The default too: loading another file goes back to it.
    this.video.defaultPlaybackRate = this.rate;
    this.video.playbackRate = this.rate;
  }

  private attach(): void {
    this.playback = new Playback(this.video, (detail) =>
      this.dispatchEvent(new CustomEvent<PlaybackState>('playback', { detail })),
    );
    this.playback.setTimes(this.clip?.poses2d.times ?? null);
  }

  private paint(): void {
    if (!this.canvas) return;
    const area = prepareCanvas(this.canvas);
    if (!area || !this.clip) return;
    const { source, poses2d } = this.clip;
    const picture = containedRect(area, source);
    // The element's own picture runs on while the page draws: a copy keeps it and the skeleton in step.
    if (this.playback?.playing) {
      const { x, y, width, height } = picture;
      area.context.drawImage(this.video, x, y, width, height);
    }
    paintOverlay(area.context, poses2d, this.frame, picture, source.width);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-clip-view': ClipView;
  }
}
