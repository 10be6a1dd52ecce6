import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { appStyles } from './app-styles.ts';
import './clip-bar.ts';
import type { ClipBar } from './clip-bar.ts';
import { ClipDesk } from './clip-desk.ts';
import './clip-view.ts';
import type { ClipView } from './clip-view.ts';
import './cost-panel.ts';
import { FileDrop } from './file-drop.ts';
import { icon } from './icons.ts';
import { pageState } from './page-state.ts';
import type { PlaybackState } from './playback.ts';
import './progress-card.ts';
import { type Settings, stepEvery } from './settings.ts';
import './settings-panel.ts';
import { keyTargetOf, type ShortcutAction, shortcutFor } from './shortcuts.ts';
import './shortcuts-dialog.ts';
import type { ShortcutsDialog } from './shortcuts-dialog.ts';
import './stage-view.ts';
import { sharedStyles } from './styles.ts';
import './timeline.ts';
import './transport-bar.ts';
import type { TransportAction } from './transport-bar.ts';

/** The demo page's one application element. */
@customElement('deciwatch-app')
export class DeciWatchApp extends LitElement {
  @state() private frame = 0;
  @state() private playing = false;
  @state() private muted = true;
  @state() private rate = 1;
  /** Width by height of the video. */
  @state() private aspect = 16 / 9;
  @state() private keysOn = true;
  @query('dw-clip-view') private view!: ClipView;
  @query('dw-clip-bar') private bar!: ClipBar;
  @query('dw-shortcuts-dialog') private keys!: ShortcutsDialog;
  private readonly desk = new ClipDesk(this, {
    isPlaying: () => this.playing,
    play: () => void this.view.playback?.play(),
    pause: () => this.view?.playback?.pause(),
    rewind: () => {
      this.frame = 0;
    },
  });
  private readonly drop = new FileDrop(this, (files) => this.desk.openFiles(files));

  static override styles = [sharedStyles, appStyles];

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener('keydown', this.keyed);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener('keydown', this.keyed);
  }

  override render() {
    const { desk, frame, playing, muted, rate } = this;
    const { clip, job } = desk;
    return html`
      <div class="stack">
        <dw-clip-bar
          .name=${desk.file?.name ?? ''}
          .info=${clip?.source ?? null}
          @files=${(event: CustomEvent<readonly File[]>) => desk.openFiles(event.detail)}
          @save=${() => desk.save()}
          @help=${() => this.keys.open()}
        ></dw-clip-bar>
        <div class="notices">
        <div role="alert">${renderNotice('error', desk.error, () => desk.dismissError())}</div>
        <div role="status">${renderNotice('note', desk.note, () => desk.dismissNote())}</div>
        </div>

        <section class="viewer card" aria-label="The clip and its poses">
          <div class="panes" style="--aspect: ${this.aspect}">
            <div class="pane ${job && clip ? 'dimmed' : ''}">
              <dw-clip-view
                .src=${desk.file?.url ?? null}
                .clip=${clip}
                .frame=${frame}
                .muted=${muted}
                .rate=${rate}
                @playback=${this.played}
                @picture=${(event: CustomEvent<number>) => {
                  this.aspect = event.detail;
                }}
                @unplayable=${() => desk.cannotPlay()}
              ></dw-clip-view>
            </div>
            <div class="pane ${job && clip ? 'dimmed' : ''}">
              <dw-stage-view .sequence=${clip?.poses3d ?? null} .frame=${frame}></dw-stage-view>
              ${this.renderWork()}
            </div>
          </div>
          <div class="deck">
            <dw-transport-bar
              .clip=${clip}
              .frame=${frame}
              .playing=${playing}
              .muted=${muted}
              .rate=${rate}
              @transport=${(event: CustomEvent<TransportAction>) => this.act(event.detail)}
              @muted-change=${(event: CustomEvent<boolean>) => {
                this.muted = event.detail;
              }}
              @rate-change=${(event: CustomEvent<number>) => {
                this.rate = event.detail;
              }}
            ></dw-transport-bar>
            <dw-timeline
              .clip=${clip}
              .frame=${this.view?.playback?.wantedFrame ?? 0}
              .playing=${playing}
              @seek=${(event: CustomEvent<number>) => this.scrub(event.detail)}
            ></dw-timeline>
          </div>
        </section>

        <div class="stack lower">
          <dw-settings-panel
            class="card"
            .settings=${desk.settings}
            .frameRate=${clip?.source.frameRate ?? 0}
            @settings-change=${(event: CustomEvent<Settings>) => desk.change(event.detail)}
          ></dw-settings-panel>
          <dw-cost-panel class="card" .clip=${clip} .frame=${frame}></dw-cost-panel>
        </div>
      </div>
      <p class="visually-hidden" role="status" data-testid="status">${desk.status}</p>
      <dw-shortcuts-dialog
        .enabled=${this.keysOn}
        @keys-change=${(event: CustomEvent<boolean>) => {
          this.keysOn = event.detail;
        }}
      ></dw-shortcuts-dialog>
      ${this.drop.active ? html`<div class="drop">Drop the video to open it</div>` : nothing}
    `;
  }

  /** The running job, or the button that starts one where it was cancelled. */
  private renderWork() {
    const { desk } = this;
    if (desk.job) {
      return html`<dw-progress-card
        .name=${desk.job.file.name}
        .every=${desk.job.settings.every}
        .progress=${desk.job.progress}
        @cancel=${() => desk.cancel()}
      ></dw-progress-card>`;
    }
    if (!desk.waiting) return nothing;
    return html`<div class="start card">
      <p>The poses of this video have not been recovered yet.</p>
      <button class="primary" @click=${() => desk.start()}>Recover them</button>
    </div>`;
  }

  protected override updated(_changes: PropertyValues<this>): void {
    const { dataset } = document.documentElement;
    const { clip, job, error } = this.desk;
    dataset.state = pageState(job?.progress ?? null, error !== '', clip !== null);
    if (!clip) return;
    dataset.frames = String(clip.source.frameCount);
    dataset.every = String(clip.interval);
  }

  private played(event: CustomEvent<PlaybackState>): void {
    this.frame = event.detail.frame;
    this.playing = event.detail.playing;
  }

  private scrub(frame: number): void {
    const playback = this.view.playback;
    playback?.pause();
    playback?.seek(frame);
    this.requestUpdate();
  }

  private act(action: TransportAction): void {
    const playback = this.view.playback;
    if (!playback || !this.desk.clip) return;
    switch (action) {
      case 'toggle':
        playback.toggle();
        break;
      case 'back':
        playback.step(-1);
        break;
      case 'forward':
        playback.step(1);
        break;
      case 'first':
        this.scrub(0);
        break;
      case 'last':
        this.scrub(Number.MAX_SAFE_INTEGER);
        break;
    }
  }

  private readonly keyed = (event: KeyboardEvent) => {
    if (event.defaultPrevented || !this.keysOn) return;
    const action = shortcutFor(event, keyTargetOf(event.composedPath()[0]));
    if (!action) return;
    event.preventDefault();
    this.obey(action);
  };

  private obey(action: ShortcutAction): void {
    switch (action) {
      case 'fewer':
        this.desk.change(stepEvery(this.desk.settings, -1));
        break;
      case 'more':
        this.desk.change(stepEvery(this.desk.settings, 1));
        break;
      case 'open':
        this.bar.choose();
        break;
      case 'save':
        this.desk.save();
        break;
      case 'help':
        this.keys.open();
        break;
      default:
        this.act(action);
        break;
    }
  }
}

function renderNotice(kind: 'error' | 'note', text: string, dismiss: () => void) {
  if (!text) return nothing;
  return html`<div class="notice ${kind}">
    <p data-testid=${kind}>${text}</p>
    <button class="bare" aria-label="Dismiss" @click=${dismiss}>${icon('close')}</button>
  </div>`;
}

declare global {
  interface HTMLElementTagNameMap {
    'deciwatch-app': DeciWatchApp;
  }
}
