import { css, html, LitElement, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { RecoveredClip } from '../engine/types.ts';
import { frameKind } from '../player/parts/clip-words.ts';
import { formatCount, formatTime } from '../player/parts/format.ts';
import { type IconName, icon } from '../player/parts/icons.ts';
import { sharedStyles } from '../player/parts/styles.ts';

const RATES = [0.25, 0.5, 1];

/** What the transport's buttons ask for. */
export type TransportAction = 'toggle' | 'back' | 'forward' | 'first' | 'last';

/**
 * Play, step, speed and sound.
 *
 * @fires transport with a {@link TransportAction} as detail
 * @fires rate-change with the new speed (1 is the clip's own) as detail
 * @fires muted-change with the new state as detail
 */
@customElement('dw-transport-bar')
export class TransportBar extends LitElement {
  @property({ attribute: false }) clip: RecoveredClip | null = null;
  @property({ attribute: false }) frame = 0;
  @property({ type: Boolean }) playing = false;
  @property({ type: Boolean }) muted = true;
  @property({ type: Number }) rate = 1;

  static override styles = [
    sharedStyles,
    css`
      :host { display: flex; flex-wrap: wrap; align-items: center; gap: 0.375rem 0.75rem; }
      .buttons { display: flex; align-items: center; gap: 0.125rem; }
      .where { flex: 1 1 7rem; display: flex; flex-wrap: wrap; gap: 0 0.75rem; font-size: 0.875rem; }
      .extra { display: flex; align-items: center; gap: 0.25rem; }
      label { display: flex; align-items: center; gap: 0.5rem; font-size: 0.875rem; color: var(--muted); }
      select { min-height: 2.25rem; padding: 0 0.5rem; font-size: 0.875rem; color: var(--ink); }
      button.primary { border-radius: 50%; padding: 0; min-width: 2.75rem; min-height: 2.75rem; margin: 0 0.25rem; }
      button.primary:disabled { background: var(--pressed); border-color: var(--pressed); color: var(--disabled); }
    `,
  ];

  override render() {
    return html`
      <div class="buttons" role="group" aria-label="Playback">
        ${this.button('First frame', 'first', 'first')}
        ${this.button('One frame back', 'previous', 'back')}
        <button
          class="primary"
          data-testid="play"
          aria-label=${this.playing ? 'Pause' : 'Play'}
          ?disabled=${!this.clip}
          @click=${() => this.ask('toggle')}
        >${icon(this.playing ? 'pause' : 'play')}</button>
        ${this.button('One frame on', 'next', 'forward')}
        ${this.button('Last frame', 'last', 'last')}
      </div>
      <p class="where numbers">${this.clip ? this.renderPlace(this.clip) : nothing}</p>
      <div class="extra">
        <label>
          Speed
          <select @change=${this.setRate} ?disabled=${!this.clip}>
            ${RATES.map((rate) => html`<option value=${rate} ?selected=${rate === this.rate}>${rate}×</option>`)}
          </select>
        </label>
        <button
          class="bare"
          aria-label="Sound"
          aria-pressed=${!this.muted}
          title=${this.muted ? 'Sound is off' : 'Sound is on'}
          @click=${() => this.dispatchEvent(new CustomEvent<boolean>('muted-change', { detail: !this.muted }))}
        >${icon(this.muted ? 'muted' : 'sound')}</button>
      </div>
    `;
  }

  private renderPlace(clip: RecoveredClip) {
    const { times } = clip.poses2d;
    const frame = Math.min(this.frame, times.length - 1);
    return html`
      <span>Frame ${formatCount(frame + 1)} of ${formatCount(times.length)}</span>
      <span class="muted">${formatTime(times[frame]! - times[0]!)}</span>
      ${this.playing ? nothing : html`<span class="muted">${frameKind(clip, frame)}</span>`}
    `;
  }

  private button(label: string, name: IconName, action: TransportAction) {
    return html`<button
      class="bare"
      aria-label=${label}
      title=${label}
      ?disabled=${!this.clip}
      @click=${() => this.ask(action)}
    >${icon(name)}</button>`;
  }

  private ask(detail: TransportAction): void {
    this.dispatchEvent(new CustomEvent<TransportAction>('transport', { detail }));
  }

  private setRate(event: Event): void {
    const detail = Number((event.target as HTMLSelectElement).value);
    this.dispatchEvent(new CustomEvent<number>('rate-change', { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-transport-bar': TransportBar;
  }
}
