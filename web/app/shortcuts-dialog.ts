import { css, html, LitElement } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { icon } from '../player/parts/icons.ts';
import { sharedStyles } from '../player/parts/styles.ts';
import { SHORTCUTS } from './shortcuts.ts';

const KEY_NAMES: Readonly<Record<string, string>> = { ' ': 'Space' };

/**
 * The list of keys, and the switch that turns them off for people whose speech input or shaky hands
 * would press them by mistake (WCAG 2.1.4).
 *
 * @fires keys-change with the switch's new state as detail
 */
@customElement('dw-shortcuts-dialog')
export class ShortcutsDialog extends LitElement {
  @property({ type: Boolean }) enabled = true;
  @query('dialog') private dialog!: HTMLDialogElement;

  static override styles = [
    sharedStyles,
    css`
      dialog {
        width: min(26rem, calc(100vw - 2rem)); padding: 1.25rem 1.5rem 1.5rem; border: 1px solid var(--line);
        border-radius: var(--round); background: var(--surface); color: var(--ink);
      }
      dialog::backdrop { background: rgb(5 8 12 / 0.45); }
      header { display: flex; align-items: center; justify-content: space-between; margin-bottom: 0.5rem; }
      h2 { font-size: 1.0625rem; }
      dl { display: grid; grid-template-columns: 1fr auto; gap: 0.5rem 1rem; align-items: center; }
      dd { text-align: right; }
      kbd {
        font: inherit; font-size: 0.8125rem; padding: 0.125rem 0.5rem; border: 1px solid var(--line-strong);
        border-bottom-width: 2px; border-radius: 6px; background: var(--sunken);
      }
      label { display: flex; gap: 0.625rem; align-items: center; margin-top: 1.25rem; cursor: pointer; }
      input { width: 1.125rem; height: 1.125rem; margin: 0; accent-color: var(--accent); }
    `,
  ];

  open(): void {
    this.dialog.showModal();
  }

  override render() {
    return html`
      <dialog aria-labelledby="title" @click=${this.closeOutside}>
        <header>
          <h2 id="title">Keys</h2>
          <button class="bare" aria-label="Close" @click=${() => this.dialog.close()}>${icon('close')}</button>
        </header>
        <dl>
          ${SHORTCUTS.map(
            ({ keys, label }) => html`<dt>${label}</dt>
              <dd>${keys.map((key) => html`<kbd>${KEY_NAMES[key] ?? key}</kbd> `)}</dd>`,
          )}
        </dl>
        <label>
          <input type="checkbox" .checked=${this.enabled} @change=${this.changed} />
          Use these keys on this page
        </label>
      </dialog>
    `;
  }

  private changed(event: Event): void {
    const detail = (event.target as HTMLInputElement).checked;
    this.dispatchEvent(new CustomEvent<boolean>('keys-change', { detail }));
  }

  private closeOutside(event: MouseEvent): void {
    if (event.target === this.dialog) this.dialog.close();
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-shortcuts-dialog': ShortcutsDialog;
  }
}
