import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { RecoverProgress } from '../engine/types.ts';
import { progressWords } from '../player/parts/progress-words.ts';
import { sharedStyles } from '../player/parts/styles.ts';

/**
 * How far a running job is, and the button that ends it.
 * @fires cancel
 */
@customElement('dw-progress-card')
export class ProgressCard extends LitElement {
  @property() name = '';
  @property({ type: Number }) every = 1;
  @property({ attribute: false }) progress!: RecoverProgress;

  static override styles = [
    sharedStyles,
    css`
      :host {
        display: block; padding: 1rem 1.125rem 1.125rem; background: var(--surface); border: 1px solid var(--line);
        border-radius: var(--round); box-shadow: 0 10px 34px rgb(8 14 22 / 0.18);
      }
      .row { display: flex; align-items: center; justify-content: space-between; gap: 1rem; }
      .name { font-size: 0.8125rem; color: var(--muted); overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .doing { font-weight: 560; }
      progress { appearance: none; display: block; width: 100%; height: 8px; margin: 0.75rem 0 0.5rem; border: 0; border-radius: 4px; background: var(--pressed); overflow: hidden; }
      progress::-webkit-progress-bar { background: var(--pressed); }
      progress::-webkit-progress-value { background: var(--accent); transition: width 180ms linear; }
      progress::-moz-progress-bar { background: var(--accent); }
      .figures { display: flex; justify-content: space-between; font-size: 0.8125rem; color: var(--muted); }
    `,
  ];

  override render() {
    const { fraction, framesDone, framesTotal } = this.progress;
    return html`
      <div class="row">
        <div style="min-width: 0">
          <p class="doing">${progressWords(this.progress, this.every)}</p>
          <p class="name">${this.name}</p>
        </div>
        <button data-testid="cancel" @click=${() => this.dispatchEvent(new CustomEvent('cancel'))}>Cancel</button>
      </div>
      <progress data-testid="progress" max="1" .value=${fraction} aria-label="Progress"></progress>
      <p class="figures numbers">
        <span>${Math.floor(fraction * 100)} %</span>
        <span>${framesTotal > 0 ? `frame ${framesDone} of ${framesTotal}` : ''}</span>
      </p>
    `;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-progress-card': ProgressCard;
  }
}
