import { css, html, LitElement, nothing, type PropertyValues } from 'lit';
import { property, query, state } from 'lit/decorators.js';
import type { RecoveredClip } from '../../engine/types.ts';
import { hasPose } from '../../pose/sequence.ts';
import { paletteFor } from '../../stage/palette.ts';
import { describeFrame } from './clip-words.ts';
import { element } from './element.ts';
import { prepareCanvas } from './hi-dpi-canvas.ts';
import { sharedStyles } from './styles.ts';
import { ThemeController, themeStyles } from './theme.ts';
import { frameX, paintTimeline } from './timeline-painter.ts';

/** CSS pixels; the slider's thumb is twice this wide. */
const INSET = 8;
const LABEL_HEIGHT = 16;

/**
 * One tick for every frame, with a slider over it.
 * @fires seek with a frame number as detail
 */
@element('dw-timeline')
export class Timeline extends LitElement {
  @property({ attribute: false }) clip: RecoveredClip | null = null;
  @property({ attribute: false }) frame = 0;
  @property({ type: Boolean }) playing = false;
  /** Without the seconds and the legend. */
  @property({ type: Boolean, reflect: true }) compact = false;
  @query('canvas') private canvas!: HTMLCanvasElement;
  private readonly themes = new ThemeController(this);
  private hasGaps = false;
  private paintedTheme = '';
  @state() private width = 0;
  private readonly resizes = new ResizeObserver(() => {
    this.width = this.clientWidth;
    this.paint();
  });

  static override styles = [
    sharedStyles,
    themeStyles,
    css`
      :host { display: block; --thumb: ${INSET * 2}px; }
      .track { direction: ltr; position: relative; height: 60px; border-radius: 6px; }
      .track:focus-within:has(:focus-visible) { outline: 2px solid var(--focus); outline-offset: 4px; }
      .track.empty::before {
        content: ''; position: absolute; inset: auto ${INSET}px 16px; height: 18px;
        background: repeating-linear-gradient(90deg, var(--line) 0 2px, transparent 2px 11px);
      }
      canvas { position: absolute; inset: 0; width: 100%; height: 100%; font: 11px system-ui, sans-serif; }
      .cursor {
        position: absolute; top: -3px; bottom: 13px; left: -1px; width: 2px; border-radius: 1px; background: var(--ink);
        pointer-events: none; box-shadow: 0 0 0 1.5px var(--surface);
      }
      .cursor::before {
        content: ''; position: absolute; top: -3px; left: -5px; width: 12px; height: 12px; border-radius: 50%;
        background: var(--ink); border: 2px solid var(--surface);
      }
      input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; appearance: none; background: none; cursor: ew-resize; outline: none; }
      input:disabled { cursor: default; }
      input::-webkit-slider-thumb { appearance: none; width: var(--thumb); height: 60px; background: none; }
      input::-moz-range-thumb { width: var(--thumb); height: 60px; background: none; border: 0; }
      .legend { display: flex; flex-wrap: wrap; gap: 4px 18px; margin: 8px ${INSET - 1}px 0; font-size: 13px; color: var(--muted); }
      .legend span { display: inline-flex; align-items: center; gap: 7px; }
      i { display: inline-block; border-radius: 1px; }
      .watched { width: 3px; height: 14px; background: var(--ink); }
      .recovered { width: 2px; height: 8px; background: var(--accent); }
      .gap { width: 10px; height: 2px; background: var(--line-strong); }
      .dot { width: 10px; height: 10px; border-radius: 50%; }
      :host([compact]) .track { height: 32px; }
      :host([compact]) .cursor { bottom: 0; }
      :host([compact]) input::-webkit-slider-thumb { height: 32px; }
      :host([compact]) input::-moz-range-thumb { height: 32px; }
      :host([compact]) .track.empty::before { inset: auto ${INSET}px 4px; }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.resizes.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resizes.disconnect();
  }

  protected override willUpdate(changes: PropertyValues<this>): void {
    if (!changes.has('clip')) return;
    const poses = this.clip?.poses2d;
    this.hasGaps = poses ? poses.times.some((_, frame) => !hasPose(poses, frame)) : false;
  }

  override render() {
    const { clip, frame } = this;
    const frames = clip?.poses2d.times.length ?? 1;
    const x = frameX(frame, frames, { width: this.width, inset: INSET });
    return html`
      <div class="track ${clip ? '' : 'empty'}" data-testid="timeline">
        <canvas aria-hidden="true"></canvas>
        ${clip ? html`<div class="cursor" .style=${`transform: translateX(${x.toFixed(1)}px)`}></div>` : nothing}
        <input
          type="range"
          aria-label="Frame"
          min="0"
          max=${frames - 1}
          step="1"
          .value=${String(frame)}
          aria-valuetext=${this.words()}
          ?disabled=${!clip}
          @input=${this.moved}
        />
      </div>
      ${this.compact ? nothing : this.renderLegend()}
    `;
  }

  private renderLegend() {
    const { sides } = paletteFor(this.themes.theme);
    // Styles as properties: a page's content security policy may forbid style attributes.
    return html`
      <div class="legend">
        <span><i class="watched"></i>Watched by the estimator</span>
        <span><i class="recovered"></i>Recovered</span>
        ${this.hasGaps ? html`<span><i class="gap"></i>Nobody seen</span>` : nothing}
        <span><i class="dot" .style=${`background: ${sides.left}`}></i>Left side</span>
        <span><i class="dot" .style=${`background: ${sides.right}`}></i>Right side</span>
      </div>
    `;
  }

  protected override updated(changes: PropertyValues<this>): void {
    if (changes.has('clip') || this.paintedTheme !== this.themes.theme) this.paint();
  }

  /** While playing, a screen reader would never come to the end of a sentence about one frame. */
  private words(): string {
    if (!this.clip) return 'no frames yet';
    return this.playing ? 'playing' : describeFrame(this.clip, this.frame);
  }

  private moved(event: Event): void {
    const detail = Number((event.target as HTMLInputElement).value);
    this.dispatchEvent(new CustomEvent<number>('seek', { detail }));
  }

  private paint(): void {
    if (!this.canvas) return;
    this.paintedTheme = this.themes.theme;
    const area = prepareCanvas(this.canvas);
    if (!area || !this.clip) return;
    const style = getComputedStyle(this.canvas);
    // As a colour, since the property itself may hold what a canvas cannot read: `light-dark()`, say.
    const colour = (name: string) => {
      this.canvas.style.color = `var(${name})`;
      return style.color;
    };
    area.context.font = style.font;
    paintTimeline(
      area.context,
      this.clip.poses2d,
      {
        width: area.width,
        height: area.height,
        inset: INSET,
        labelHeight: this.compact ? 0 : LABEL_HEIGHT,
      },
      {
        watched: colour('--ink'),
        recovered: colour('--accent'),
        gap: colour('--line-strong'),
        label: colour('--muted'),
      },
    );
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-timeline': Timeline;
  }
}
