import { css, html, LitElement, nothing } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { DEFAULT_ESTIMATOR, ESTIMATOR_NAMES, type EstimatorName } from '../../estimators/names.ts';
import { formatMegabytes } from '../../player/parts/format.ts';
import { sharedStyles } from '../../player/parts/styles.ts';
import { scopeOf } from './addresses.ts';
import { canKeep } from './offline-copy.ts';
import { type Keeping, OfflineDesk } from './offline-desk.ts';
import { estimatorWords, failureWords, progressWords, spokenProgress } from './offline-words.ts';

/** Offers to keep the page for offline use, says how far that is, and takes it back. */
@customElement('dw-keep-offline')
export class KeepOffline extends LitElement {
  /** The one that is chosen on the page, by the page's own word. */
  @state() private estimator: EstimatorName = DEFAULT_ESTIMATOR;
  @query('button') private button!: HTMLButtonElement | null;
  /** The button that had the focus makes way for another one. */
  #focused = false;
  /** A development server has no list of files and no service worker. */
  readonly #possible = import.meta.env.PROD && canKeep();
  private readonly desk = this.#possible
    ? new OfflineDesk(this, scopeOf(document.baseURI))
    : undefined;
  readonly #page = new MutationObserver(() => this.#readPage());

  static override styles = [
    sharedStyles,
    css`
      :host { display: block; margin-bottom: 1rem; }
      :host([hidden]) { display: none; }
      section {
        display: flex; flex-wrap: wrap; align-items: center; gap: 0.625rem 1rem; padding: 0.875rem 1.375rem;
        color: var(--muted); font-size: 0.875rem;
      }
      .words { flex: 1 1 20rem; min-width: 0; }
      h2 { color: var(--ink); }
      p { text-wrap: pretty; }
      .failure { color: var(--danger); }
      progress { appearance: none; display: block; width: 100%; height: 6px; margin-top: 0.5rem; border: 0; border-radius: 3px; background: var(--pressed); overflow: hidden; }
      progress::-webkit-progress-bar { background: var(--pressed); }
      progress::-webkit-progress-value { background: var(--accent); }
      progress::-moz-progress-bar { background: var(--accent); }
      button { color: var(--ink); font-size: 0.9375rem; }
      @media (max-width: 30rem) { button { width: 100%; } }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.#readPage();
    this.#page.observe(document.documentElement, {
      attributeFilter: ['data-estimator', 'data-state'],
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#page.disconnect();
  }

  protected override willUpdate(): void {
    this.#focused = this.renderRoot.contains(this.shadowRoot?.activeElement ?? null);
  }

  protected override updated(): void {
    if (this.#focused && !this.shadowRoot?.activeElement) this.button?.focus();
  }

  override render() {
    const { desk } = this;
    if (!desk?.known) return nothing;
    return html`<section class="card" aria-label="Offline use" data-testid="offline" data-state=${this.#stateName()}>
      ${desk.keeping ? this.#renderKeeping(desk.keeping) : desk.kept ? this.#renderKept(desk) : this.#renderOffer(desk)}
      <p class="visually-hidden" role="status" data-testid="offline-status">${this.#spoken(desk)}</p>
    </section>`;
  }

  #renderOffer(desk: OfflineDesk) {
    return html`
      <div class="words">
        <h2>Keep this page for offline use</h2>
        <p>
          Stores the page, ${estimatorWords([this.estimator])}, the nets and the sample video in this browser. Your
          videos are never stored.
        </p>
        ${this.#renderFailure(desk, 'Nothing was kept.')}
      </div>
      <button data-testid="keep-offline" @click=${() => this.#keep(desk)}>
        Keep it (${formatMegabytes(desk.bytes([this.estimator]))})
      </button>`;
  }

  #renderKeeping({ done, total, update }: Keeping) {
    return html`
      <div class="words">
        <h2>${update ? 'Bringing the kept page up to date' : 'Keeping this page'}</h2>
        <p class="numbers">${progressWords(done, total)}</p>
        <progress max=${total} .value=${done} aria-label="Progress"></progress>
      </div>
      <button data-testid="cancel-offline" @click=${() => this.desk?.cancel()}>Cancel</button>`;
  }

  #renderKept(desk: OfflineDesk) {
    const { estimators } = desk.kept!;
    return html`
      <div class="words">
        <h2>Ready for offline use</h2>
        <p>
          This page works without a connection, with ${estimatorWords(estimators)}
          (${formatMegabytes(desk.bytes(estimators))} in this browser).
          ${estimators.length < ESTIMATOR_NAMES.length ? 'Another one is kept once it has been used.' : nothing}
        </p>
        ${this.#renderFailure(desk, 'It could not be brought up to date and stays as it was.')}
      </div>
      <button data-testid="remove-offline" @click=${() => void desk.remove()}>Remove</button>`;
  }

  #renderFailure({ failure }: OfflineDesk, outcome: string) {
    return failure
      ? html`<p class="failure" data-testid="offline-failure">${outcome} ${failureWords(failure)}</p>`
      : nothing;
  }

  #stateName(): string {
    const { desk } = this;
    return desk?.keeping ? 'keeping' : desk?.kept ? 'kept' : 'offered';
  }

  /** What has changed, and nothing before something has. */
  #spoken(desk: OfflineDesk): string {
    if (desk.keeping) return spokenProgress(desk.keeping.done, desk.keeping.total);
    if (desk.failure) return `This page was not kept. ${failureWords(desk.failure)}`;
    if (desk.kept) return 'This page is ready for offline use.';
    return desk.removed ? 'Removed: nothing of this page is stored any more.' : '';
  }

  #keep(desk: OfflineDesk): void {
    // So that the browser does not clear it away when space gets short; some ask first.
    void navigator.storage.persist?.();
    void desk.keep([this.estimator]);
  }

  #readPage(): void {
    const { estimator } = document.documentElement.dataset;
    this.estimator = ESTIMATOR_NAMES.find((name) => name === estimator) ?? DEFAULT_ESTIMATOR;
    void this.desk?.look();
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-keep-offline': KeepOffline;
  }
}
