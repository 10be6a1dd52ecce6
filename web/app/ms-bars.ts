import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { MsComparison, MsPart } from '../player/parts/cost-words.ts';
import { formatMs } from '../player/parts/format.ts';
import { sharedStyles } from '../player/parts/styles.ts';

/** Two stacked bars on one scale: milliseconds per frame as measured, and as every frame watched. */
@customElement('dw-ms-bars')
export class MsBars extends LitElement {
  @property({ attribute: false }) comparison!: MsComparison;

  static override styles = [
    sharedStyles,
    css`
      :host { display: block; }
      .bar { margin-top: 0.75rem; }
      .label { display: flex; justify-content: space-between; gap: 1rem; font-size: 0.875rem; }
      .label strong { font-weight: 620; }
      .track { display: flex; gap: 1px; height: 18px; margin-top: 0.25rem; border-radius: 4px; overflow: hidden; }
      .track i { display: block; height: 100%; min-width: 1px; }
      .decode { background: var(--decode); }
      .estimator { background: var(--ink); }
      .denoise { background: var(--accent-soft); }
      .recover { background: var(--accent); }
      ul { list-style: none; display: grid; grid-template-columns: repeat(auto-fit, minmax(8.5rem, 1fr)); gap: 0.25rem 1.25rem; margin: 0.875rem 0 0; padding: 0; font-size: 0.8125rem; }
      li { display: flex; align-items: center; gap: 0.4375rem; }
      li i { flex: none; width: 10px; height: 10px; border-radius: 3px; }
      li span:last-child { margin-left: auto; }
    `,
  ];

  override render() {
    const { measured, everyFrame, measuredTotal, everyFrameTotal } = this.comparison;
    const scale = Math.max(measuredTotal, everyFrameTotal);
    return html`
      <h3 class="visually-hidden">Milliseconds per frame</h3>
      ${this.bar('Measured, per frame', measured, measuredTotal, scale)}
      ${this.bar('Watching every frame would take', everyFrame, everyFrameTotal, scale)}
      <ul class="numbers">
        ${measured.map(
          ({ name, kind, ms }) => html`<li>
            <i class=${kind}></i><span>${name}</span><span class="muted">${formatMs(ms)}</span>
          </li>`,
        )}
      </ul>
    `;
  }

  private bar(label: string, parts: readonly MsPart[], total: number, scale: number) {
    return html`
      <div class="bar">
        <div class="label"><span>${label}</span><strong class="numbers">${formatMs(total)}</strong></div>
        <div class="track" aria-hidden="true">
          ${parts.map(({ kind, ms }) => html`<i class=${kind} style="width: ${(100 * ms) / scale}%"></i>`)}
        </div>
      </div>
    `;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-ms-bars': MsBars;
  }
}
