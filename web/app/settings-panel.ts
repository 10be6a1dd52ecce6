import { css, html, LitElement, nothing } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';
import { formatFlops, formatMegabytes, formatOrdinal } from '../player/parts/format.ts';
import { sharedStyles } from '../player/parts/styles.ts';
import { MAX_INTERVAL, MIN_INTERVAL } from '../sampling/watched.ts';
import { ESTIMATOR_WORDS, fetchEstimatorFigures } from './estimator-words.ts';
import type { Settings } from './settings.ts';

type Figures = Awaited<ReturnType<typeof fetchEstimatorFigures>>;

/**
 * How often to watch, and with which estimator.
 * @fires settings-change with the new {@link Settings} as detail
 */
@customElement('dw-settings-panel')
export class SettingsPanel extends LitElement {
  @property({ attribute: false }) settings!: Settings;
  /** Frames per second of the clip, or 0 while there is none. */
  @property({ type: Number }) frameRate = 0;
  @state() private figures: Figures | null = null;

  static override styles = [
    sharedStyles,
    css`
      :host { display: grid; align-content: start; gap: 1.5rem; padding: 1.25rem 1.375rem 1.375rem; }
      .row { display: flex; align-items: baseline; justify-content: space-between; gap: 1rem; }
      output { font-size: 1.5rem; font-weight: 640; letter-spacing: -0.02em; }
      input[type='range'] { width: 100%; margin: 0.375rem 0 0.25rem; height: 1.75rem; accent-color: var(--ink); cursor: pointer; display: block; }
      .ends { display: flex; justify-content: space-between; font-size: 0.75rem; color: var(--muted); }
      .note { margin-top: 0.625rem; font-size: 0.875rem; color: var(--muted); text-wrap: pretty; }
      legend { font-size: 0.9375rem; font-weight: 620; margin-bottom: 0.625rem; }
      .choices { display: grid; grid-template-columns: repeat(3, 1fr); border: 1px solid var(--line); border-radius: var(--round-small); overflow: hidden; background: var(--sunken); }
      .choices label { position: relative; padding: 0.5rem 0.375rem 0.5625rem; text-align: center; cursor: pointer; line-height: 1.3; border-left: 1px solid var(--line); }
      .choices label:first-child { border-left: 0; }
      .choices label:hover { background: var(--hover); }
      .choices label:has(:checked) { background: var(--surface); box-shadow: inset 0 -3px 0 var(--accent); }
      .choices label:has(:focus-visible) { outline: 2px solid var(--focus); outline-offset: -3px; border-radius: var(--round-small); }
      .choices input { position: absolute; opacity: 0; inset: 0; margin: 0; width: 100%; height: 100%; cursor: pointer; }
      .choices strong { display: block; font-weight: 600; }
      .choices small { display: block; font-size: 0.75rem; color: var(--muted); }
    `,
  ];

  override async connectedCallback(): Promise<void> {
    super.connectedCallback();
    try {
      this.figures ??= await fetchEstimatorFigures();
    } catch {
      // Only sizes are missing; the engine reads the same file and says what is wrong with it.
    }
  }

  override render() {
    const { every, estimator } = this.settings;
    const spacing = this.frameRate > 0 ? every / this.frameRate : 0;
    return html`
      <section>
        <div class="row">
          <h2 id="every-label">Watch one frame in</h2>
          <output class="numbers" for="every">${every}</output>
        </div>
        <input
          id="every"
          data-testid="every"
          type="range"
          min=${MIN_INTERVAL}
          max=${MAX_INTERVAL}
          step="1"
          aria-labelledby="every-label"
          aria-valuetext="one frame in ${every}"
          .value=${live(String(every))}
          @input=${this.setEvery}
        />
        <div class="ends" aria-hidden="true"><span>every frame</span><span>one in ${MAX_INTERVAL}</span></div>
        <p class="note">
          ${
            every === 1
              ? 'The estimator looks at every frame; the two nets only smooth.'
              : html`The estimator looks at every ${formatOrdinal(every)} frame${
                  spacing ? `, ${spacing.toFixed(2)} s apart` : nothing
                }; the frames between are recovered.`
          }
        </p>
      </section>
      <fieldset>
        <legend>Estimator: MediaPipe Pose</legend>
        <div class="choices">
          ${ESTIMATOR_NAMES.map(
            (name) => html`<label>
              <input
                type="radio"
                name="estimator"
                data-testid="estimator-${name}"
                .checked=${live(name === estimator)}
                @change=${() => this.change({ every, estimator: name })}
              />
              <strong>${ESTIMATOR_WORDS[name].label}</strong>
              <small>${ESTIMATOR_WORDS[name].meaning}</small>
              <small class="numbers">${this.figures ? formatMegabytes(this.figures[name].bytes) : nothing}</small>
            </label>`,
          )}
        </div>
        ${this.renderCallNote(estimator)}
      </fieldset>
    `;
  }

  private renderCallNote(estimator: EstimatorName) {
    if (!this.figures) return nothing;
    const { perCall } = this.figures[estimator].flops;
    return html`<p class="note">
      One look costs ${formatFlops(perCall)}: its detector and its landmarks.
    </p>`;
  }

  private setEvery(event: Event): void {
    const every = Number((event.target as HTMLInputElement).value);
    this.change({ every, estimator: this.settings.estimator });
  }

  private change(detail: Settings): void {
    this.dispatchEvent(new CustomEvent<Settings>('settings-change', { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-settings-panel': SettingsPanel;
  }
}
