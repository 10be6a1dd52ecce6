import { css, html, LitElement, nothing } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { icon } from '../../player/parts/icons.ts';
import { sharedStyles } from '../../player/parts/styles.ts';
import type { CameraChoice } from '../../sources/camera.ts';
import type { LiveChoices } from './live-desk.ts';

/** What the live bar's buttons ask for. */
export type LiveAction = 'stop' | 'record' | 'stop-recording';

/**
 * The camera's controls: which one, mirrored or not, how it is shown, recording.
 *
 * @fires live with a {@link LiveAction} as detail
 * @fires camera with the id of the chosen camera as detail
 * @fires choices with the new {@link LiveChoices} as detail
 */
@customElement('dw-live-bar')
export class LiveBar extends LitElement {
  @property({ attribute: false }) choices!: LiveChoices;
  @property({ attribute: false }) cameras: readonly CameraChoice[] = [];
  @property() camera = '';
  /** Somebody can be recorded: frames come and the models are there. */
  @property({ type: Boolean }) ready = false;
  @property({ type: Boolean }) recording = false;
  @property({ type: Boolean }) recovering = false;

  static override styles = [
    sharedStyles,
    css`
      :host { display: flex; flex-wrap: wrap; align-items: center; gap: 0.625rem 1rem; }
      .buttons { display: flex; flex-wrap: wrap; gap: 0.5rem; }
      .record { color: var(--danger); }
      .modes { display: flex; border: 1px solid var(--line); border-radius: var(--round-small); overflow: hidden; background: var(--sunken); }
      .modes label { position: relative; padding: 0.4375rem 0.875rem; cursor: pointer; font-size: 0.9375rem; border-left: 1px solid var(--line); }
      .modes label:first-of-type { border-left: 0; }
      .modes label:has(:checked) { background: var(--surface); box-shadow: inset 0 -3px 0 var(--accent); font-weight: 560; }
      .modes label:has(:focus-visible) { outline: 2px solid var(--focus); outline-offset: -3px; }
      .modes input { position: absolute; opacity: 0; inset: 0; margin: 0; width: 100%; height: 100%; cursor: pointer; }
      .check { display: flex; align-items: center; gap: 0.4375rem; font-size: 0.875rem; cursor: pointer; min-height: 2.5rem; }
      .check input { width: 1.0625rem; height: 1.0625rem; accent-color: var(--ink); margin: 0; }
      .which { display: flex; align-items: center; gap: 0.5rem; font-size: 0.875rem; color: var(--muted); min-width: 0; }
      .which select { max-width: 14rem; color: var(--ink); font-size: 0.875rem; }
    `,
  ];

  override render() {
    const { choices, recording, recovering } = this;
    return html`
      <div class="buttons">
        <button data-testid="stop-camera" @click=${() => this.ask('stop')}>${icon('close')}Stop camera</button>
        ${
          recording
            ? html`<button class="primary" data-testid="stop-recording" @click=${() => this.ask('stop-recording')}>
                ${icon('stop')}Stop recording
              </button>`
            : html`<button
                data-testid="record"
                ?disabled=${!this.ready || recovering}
                @click=${() => this.ask('record')}
              ><span class="record">${icon('record')}</span>${recovering ? 'Recovering …' : 'Record'}</button>`
        }
      </div>
      <fieldset class="modes">
        <legend class="visually-hidden">When the skeleton is shown</legend>
        ${this.mode('smooth', 'Smooth', 'One interval late, recovered between two looks')}
        ${this.mode('now', 'Now', 'At once; what comes after the last look is foreseen')}
      </fieldset>
      ${this.check('mirrored', 'Mirror')}
      ${this.check('keepPicture', 'Record the picture too', recording)}
      <label class="check" title="Watch less often when the estimator is too slow, rather than leave samples out">
        <input
          type="checkbox"
          data-testid="adapt"
          .checked=${choices.load === 'adapt'}
          @change=${(event: Event) =>
            this.change({ load: (event.target as HTMLInputElement).checked ? 'adapt' : 'skip' })}
        />Watch less often if slow
      </label>
      ${
        this.cameras.length > 1
          ? html`<label class="which">Camera
              <select data-testid="which-camera" ?disabled=${recording} @change=${this.chosen}>
                ${this.cameras.map(
                  ({ id, label }) =>
                    html`<option value=${id} ?selected=${id === this.camera}>${label}</option>`,
                )}
              </select>
            </label>`
          : nothing
      }
    `;
  }

  private mode(mode: LiveChoices['mode'], label: string, title: string) {
    return html`<label title=${title}>
      <input
        type="radio"
        name="mode"
        data-testid="mode-${mode}"
        .checked=${this.choices.mode === mode}
        @change=${() => this.change({ mode })}
      />${label}
    </label>`;
  }

  private check(name: 'mirrored' | 'keepPicture', label: string, disabled = false) {
    return html`<label class="check">
      <input
        type="checkbox"
        data-testid=${name === 'mirrored' ? 'mirror' : 'keep-picture'}
        ?disabled=${disabled}
        .checked=${this.choices[name]}
        @change=${(event: Event) =>
          this.change({ [name]: (event.target as HTMLInputElement).checked })}
      />${label}
    </label>`;
  }

  private change(changed: Partial<LiveChoices>): void {
    const detail: LiveChoices = { ...this.choices, ...changed };
    this.dispatchEvent(new CustomEvent<LiveChoices>('choices', { detail }));
  }

  private chosen(event: Event): void {
    const detail = (event.target as HTMLSelectElement).value;
    this.dispatchEvent(new CustomEvent<string>('camera', { detail }));
  }

  private ask(detail: LiveAction): void {
    this.dispatchEvent(new CustomEvent<LiveAction>('live', { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-live-bar': LiveBar;
  }
}
