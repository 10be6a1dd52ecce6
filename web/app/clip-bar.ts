import { css, html, LitElement, nothing } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { ClipInfo } from '../engine/types.ts';
import { formatCount, formatTime } from '../player/parts/format.ts';
import { icon } from '../player/parts/icons.ts';
import { sharedStyles } from '../player/parts/styles.ts';

/**
 * What is shown, and the buttons to open another video and to save the poses.
 *
 * @fires files with the chosen files as detail
 * @fires save
 * @fires help
 * @fires camera
 */
@customElement('dw-clip-bar')
export class ClipBar extends LitElement {
  @property() name = '';
  @property({ attribute: false }) info: ClipInfo | null = null;
  /** The camera is on: there is no clip to save. */
  @property({ type: Boolean }) live = false;
  @query('input') private input!: HTMLInputElement;

  static override styles = [
    sharedStyles,
    css`
      :host { display: flex; flex-wrap: wrap; align-items: center; gap: 0.625rem 1rem; }
      .what { flex: 1 1 14rem; min-width: 0; }
      h2 { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; font-size: 1rem; }
      .facts { font-size: 0.8125rem; color: var(--muted); min-height: 1.2em; }
      .buttons { display: flex; gap: 0.5rem; }
      @media (max-width: 30rem) {
        .buttons { flex: 1 0 100%; flex-wrap: wrap; }
        .buttons > button:not(.bare) { flex: 1 1 auto; padding: 0 0.375rem; gap: 0.375rem; font-size: 0.9375rem; white-space: nowrap; }
      }
    `,
  ];

  /** Opens the system's file chooser. */
  choose(): void {
    this.input.click();
  }

  override render() {
    const { info } = this;
    const rate = info && Number(info.frameRate.toFixed(2));
    return html`
      <div class="what">
        <h2 title=${this.name}>${this.name || 'No video yet'}</h2>
        <p class="facts numbers">
          ${
            info
              ? `${info.width} × ${info.height} · ${formatCount(info.frameCount)} frames · ${rate} per second · ${formatTime(info.duration)}`
              : nothing
          }
        </p>
      </div>
      <div class="buttons">
        <button class="bare" aria-label="Keys" title="Keys (?)" @click=${() => this.tell('help')}>${icon('keyboard')}</button>
        <button data-testid="save" ?disabled=${!info || this.live} @click=${() => this.tell('save')}>${icon('save')}Save poses</button>
        <button data-testid="start-camera" ?disabled=${this.live} @click=${() => this.tell('camera')}>${icon('camera')}Use camera</button>
        <button class="primary" @click=${() => this.choose()}>${icon('open')}Open a video</button>
        <input data-testid="open-file" type="file" accept="video/*,.mkv" hidden @change=${this.chosen} />
      </div>
    `;
  }

  private tell(type: 'save' | 'help' | 'camera'): void {
    this.dispatchEvent(new CustomEvent(type));
  }

  private chosen(): void {
    const detail = [...(this.input.files ?? [])];
    // So that choosing the same file again counts as a change.
    this.input.value = '';
    if (detail.length > 0)
      this.dispatchEvent(new CustomEvent<readonly File[]>('files', { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-clip-bar': ClipBar;
  }
}
