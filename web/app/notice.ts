import { html, nothing } from 'lit';
import { icon } from '../player/parts/icons.ts';

/** A sentence that can be dismissed, or nothing. */
export function renderNotice(kind: 'error' | 'note', text: string, dismiss: () => void) {
  if (!text) return nothing;
  return html`<div class="notice ${kind}">
    <p data-testid=${kind}>${text}</p>
    <button class="bare" aria-label="Dismiss" @click=${dismiss}>${icon('close')}</button>
  </div>`;
}
