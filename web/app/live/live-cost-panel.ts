import { css, html, LitElement } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { LiveMode, LiveReport } from '../../engine/live/types.ts';
import { delayWords } from '../../player/live/live-words.ts';
import { costHeadline } from '../../player/parts/cost-words.ts';
import { formatCount, formatFlops, formatMs } from '../../player/parts/format.ts';
import { sharedStyles } from '../../player/parts/styles.ts';

/** The counter of live playback: the last ten seconds. */
@customElement('dw-live-cost-panel')
export class LiveCostPanel extends LitElement {
  @property({ attribute: false }) report: LiveReport | null = null;
  @property({ attribute: false }) mode: LiveMode = 'smooth';

  static override styles = [
    sharedStyles,
    css`
      :host { display: block; padding: 1.25rem 1.5rem 1.375rem; container-type: inline-size; }
      .headline { display: flex; flex-wrap: wrap; align-items: center; gap: 0 0.875rem; }
      .figure { font-size: clamp(2.75rem, 8cqw, 4rem); line-height: 1.05; font-weight: 680; letter-spacing: -0.04em; color: var(--accent); white-space: nowrap; }
      .sentence { flex: 1 1 12rem; max-width: 24rem; text-wrap: balance; }
      dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: 0.75rem 1.5rem; margin-top: 1.25rem; padding-top: 1rem; border-top: 1px solid var(--line); }
      dt { font-size: 0.8125rem; color: var(--muted); }
      dd { font-weight: 600; }
      dd span { font-weight: 400; color: var(--muted); }
      .honest { margin-top: 0.875rem; font-size: 0.8125rem; color: var(--muted); text-wrap: pretty; }
      .empty { display: grid; place-content: center; min-height: 12rem; text-align: center; color: var(--muted); }
    `,
  ];

  override render() {
    const { report, mode } = this;
    if (!report || report.estimatorCalls === 0) {
      return html`<div data-testid="live-counter">
        <h2>What it costs</h2>
        <p class="empty">The count begins with the first look at the camera’s picture.</p>
      </div>`;
    }
    const { figure, sentence } = costHeadline(report);
    return html`<div data-testid="live-counter">
      <h2 class="visually-hidden">What it costs</h2>
      <p class="headline">
        <span class="figure numbers">${figure}</span>
        <span class="sentence">${sentence}</span>
      </p>
      <dl class="numbers">
        ${this.fact('Looks by the estimator', formatCount(report.estimatorCalls), `at ${formatCount(report.frames)} frames`)}
        ${this.fact('FLOPs for one frame', formatFlops(report.flopsPerFrame.total), `instead of ${formatFlops(report.everyFrameFlopsPerFrame)}`)}
        ${this.fact('Work for one frame', formatMs(report.msPerFrame.total), `nets: ${formatMs(report.msPerFrame.denoise + report.msPerFrame.recover)}`)}
        ${this.fact('One look takes', formatMs(report.msPerEstimatorCall), '')}
        ${this.fact('Delay, camera to screen', formatMs(report.delayMs.median), `at most ${formatMs(report.delayMs.p95)} for 95 %`)}
        ${this.fact('Camera', `${report.frameRate.toFixed(1)} a second`, report.missed ? `${formatCount(report.missed)} not seen` : '')}
      </dl>
      <p class="honest">
        ${delayWords(mode, report.delayMs.median)} Figures are of the last ten seconds, measured here, on this device.
      </p>
    </div>`;
  }

  private fact(term: string, figure: string, rest: string) {
    return html`<div><dt>${term}</dt><dd>${figure} <span>${rest}</span></dd></div>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-live-cost-panel': LiveCostPanel;
  }
}
