import { html, nothing, type TemplateResult } from 'lit';
import type { RecoverProgress } from '../engine/types.ts';
import { icon } from './parts/icons.ts';
import type { PlayerErrorDetail } from './types.ts';

/** What went wrong, and a way to try again. */
export function renderProblem({ message }: PlayerErrorDetail, retry: () => void): TemplateResult {
  return html`<div class="card box problem" part="error" role="alert">
    <p>${message}</p>
    <button @click=${retry}>Try again</button>
  </div>`;
}

/** The page's own poster, or the attribute's. */
export function renderPoster(address: string): TemplateResult {
  return html`<slot name="poster">${
    address ? html`<img class="poster" part="poster" src=${address} alt="" />` : nothing
  }</slot>`;
}

/** The page's own progress, or ours. */
export function renderProgress(progress: RecoverProgress, words: string): TemplateResult {
  const { fraction, framesDone, framesTotal } = progress;
  return html`<slot name="progress"><div class="card box" part="progress">
    <p class="doing">${words}</p>
    <progress max="1" .value=${fraction} aria-label="Progress"></progress>
    <p class="figures numbers">
      <span>${Math.floor(fraction * 100)} %</span>
      <span>${framesTotal > 0 ? `frame ${framesDone} of ${framesTotal}` : ''}</span>
    </p>
  </div></slot>`;
}

/** What the button in the middle does. */
export interface StartButton {
  readonly camera: boolean;
  /** It stops what runs: seen only while it has the focus. */
  readonly running: boolean;
  readonly disabled: boolean;
  readonly press: () => void;
}

/** The button in the middle of the picture. */
export function renderStart({ camera, running, disabled, press }: StartButton): TemplateResult {
  const [label, name] = camera
    ? running
      ? (['Stop the camera', 'stop'] as const)
      : (['Start the camera', 'camera'] as const)
    : running
      ? (['Pause', 'pause'] as const)
      : (['Play', 'play'] as const);
  return html`<button
    class="start ${running ? 'quiet' : ''}"
    part="start"
    aria-label=${label}
    ?disabled=${disabled}
    @click=${press}
  >${icon(name)}</button>`;
}
