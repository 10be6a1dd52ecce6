import { css, html, LitElement, nothing, type PropertyValues } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { RecoveredClip } from '../engine/types.ts';
import { ESTIMATOR_NAMES } from '../estimators/names.ts';
import { compareMs, costHeadline } from '../player/parts/cost-words.ts';
import { formatCount, formatFlops, formatSeconds } from '../player/parts/format.ts';
import { type CumulativeFlops, cumulativeFlops } from './cumulative-cost.ts';
import './ms-bars.ts';
import { sharedStyles } from '../player/parts/styles.ts';

/** The counter: what this clip cost, against watching every frame of it. */
@customElement('dw-cost-panel')
export class CostPanel extends LitElement {
  @property({ attribute: false }) clip: RecoveredClip | null = null;
  @property({ attribute: false }) frame = 0;
  private upTo: ((frame: number) => CumulativeFlops) | null = null;

  static override styles = [
    sharedStyles,
    css`
      :host { display: block; padding: 1.25rem 1.5rem 1.375rem; container-type: inline-size; }
      .columns { display: grid; gap: 1.5rem 2.5rem; }
      @container (min-width: 44rem) { .columns { grid-template-columns: minmax(0, 1.05fr) minmax(0, 1fr); } }
      .headline { display: flex; flex-wrap: wrap; align-items: center; gap: 0 0.875rem; }
      .figure { font-size: clamp(2.75rem, 8cqw, 4rem); line-height: 1.05; font-weight: 680; letter-spacing: -0.04em; color: var(--accent); white-space: nowrap; }
      .sentence { flex: 1 1 12rem; max-width: 22rem; text-wrap: balance; }
      .live { margin-top: 1rem; }
      .live-row { display: flex; flex-wrap: wrap; justify-content: space-between; gap: 0 1rem; font-size: 0.875rem; }
      .live-row strong { font-weight: 620; }
      .meter { position: relative; height: 12px; margin: 0.375rem 0; border-radius: 6px; background: var(--pressed); overflow: hidden; }
      .meter div { position: absolute; inset: 0; transform-origin: left; }
      .saved { background: var(--accent-soft); }
      .spent { background: var(--ink); }
      dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); gap: 0.75rem 1.5rem; margin-top: 1.25rem; padding-top: 1rem; border-top: 1px solid var(--line); }
      dt { font-size: 0.8125rem; color: var(--muted); }
      dd { font-weight: 600; }
      dd span { font-weight: 400; color: var(--muted); }
      .honest { margin-top: 0.875rem; font-size: 0.8125rem; color: var(--muted); text-wrap: pretty; }
      .empty { display: grid; place-content: center; min-height: 12rem; text-align: center; color: var(--muted); }
    `,
  ];

  protected override willUpdate(changes: PropertyValues<this>): void {
    if (changes.has('clip')) this.upTo = this.clip && cumulativeFlops(this.clip);
  }

  override render() {
    const { clip, upTo } = this;
    if (!clip || !upTo) {
      return html`<div data-testid="counter">
        <h2>What it cost</h2>
        <p class="empty">The count appears here once the clip has been worked through.</p>
      </div>`;
    }
    const { cost } = clip;
    const { figure, sentence } = costHeadline(cost);
    return html`<div data-testid="counter">
      <h2 class="visually-hidden">What it cost</h2>
      <div class="columns">
        <div>
          <p class="headline">
            <span class="figure numbers">${figure}</span>
            <span class="sentence">${sentence}</span>
          </p>
          ${cost.flopsRatio === null ? nothing : this.renderLive(upTo)}
        </div>
        <dw-ms-bars .comparison=${compareMs(cost, clip.recovery)}></dw-ms-bars>
      </div>
      <dl class="numbers">
        ${this.fact('Looks by the estimator', formatCount(cost.estimatorCalls), `for ${formatCount(cost.frames)} frames`)}
        ${
          cost.flopsRatio === null
            ? nothing
            : this.fact(
                'FLOPs for one frame',
                formatFlops(cost.flopsPerFrame.total),
                `instead of ${formatFlops(cost.everyFrameFlopsPerFrame)}`,
              )
        }
        ${this.fact('Time for the whole clip', formatSeconds(cost.wallMs / 1000), `for ${formatSeconds(clip.source.duration)} of video`)}
      </dl>
      <p class="honest">
        FLOPs are 2 × multiply-accumulates, counted from the nets’ own graphs. Milliseconds were measured
        here, on this device, for this clip. “Every frame” means ${callWords(clip.estimator.name)},
        on each frame.
      </p>
    </div>`;
  }

  private fact(term: string, figure: string, rest: string) {
    return html`<div><dt>${term}</dt><dd>${figure} <span>${rest}</span></dd></div>`;
  }

  private renderLive(upTo: (frame: number) => CumulativeFlops) {
    const last = this.clip!.cost.frames - 1;
    const now = upTo(this.frame);
    const whole = Math.max(upTo(last).everyFrame, upTo(last).spent);
    const saved = now.everyFrame - now.spent;
    return html`
      <div class="live numbers" aria-hidden="true">
        <div class="live-row"><span>Up to this frame</span><span class="muted">frame ${formatCount(Math.min(this.frame, last) + 1)}</span></div>
        <div class="meter">
          <div class="saved" style="transform: scaleX(${now.everyFrame / whole})"></div>
          <div class="spent" style="transform: scaleX(${now.spent / whole})"></div>
        </div>
        <div class="live-row">
          <span><strong>${formatFlops(now.spent)}</strong> spent</span>
          <span><strong>${formatFlops(Math.abs(saved))}</strong> ${saved >= 0 ? 'saved' : 'more than watching every frame'}</span>
        </div>
      </div>
    `;
  }
}

function callWords(estimator: string): string {
  const isOurs = ESTIMATOR_NAMES.some((name) => name === estimator);
  return isOurs
    ? 'the same MediaPipe call, detector and landmarks'
    : 'the same call of the estimator';
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-cost-panel': CostPanel;
  }
}
