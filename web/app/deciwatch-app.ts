import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import type { LiveSession } from '../engine/live/types.ts';
import { appStyles } from './app-styles.ts';
import './clip-bar.ts';
import type { ClipBar } from './clip-bar.ts';
import { ClipDesk } from './clip-desk.ts';
import '../player/parts/clip-view.ts';
import type { ClipView } from '../player/parts/clip-view.ts';
import './cost-panel.ts';
import { FileDrop } from './file-drop.ts';
import './live/live-cost-panel.ts';
import { LiveDesk } from './live/live-desk.ts';
import './live/live-section.ts';
import type { PlaybackState } from '../player/parts/playback.ts';
import type { LiveSection } from './live/live-section.ts';
import { renderNotice } from './notice.ts';
import { PageEngine } from './page-engine.ts';
import { pageState } from './page-state.ts';
import './progress-card.ts';
import { type Settings, stepEvery } from './settings.ts';
import './settings-panel.ts';
import { keyTargetOf, type ShortcutAction, shortcutFor } from './shortcuts.ts';
import './shortcuts-dialog.ts';
import type { ShortcutsDialog } from './shortcuts-dialog.ts';
import '../player/parts/stage-view.ts';
import { sharedStyles } from '../player/parts/styles.ts';
import '../player/parts/timeline.ts';
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
  @query('dw-clip-view') private view!: ClipView | null;
  @query('dw-live-section') private liveSection!: LiveSection | null;
  @query('dw-clip-bar') private bar!: ClipBar;
  @query('dw-shortcuts-dialog') private keys!: ShortcutsDialog;
  private readonly engine = new PageEngine(this);
  private readonly desk = new ClipDesk(this, this.engine, {
    isPlaying: () => this.playing,
    play: () => void this.view?.playback?.play(),
    pause: () => this.view?.playback?.pause(),
    rewind: () => {
      this.frame = 0;
    },
  });
  private readonly live = new LiveDesk(this, this.engine, {
    draw: (moment, stage) => this.liveSection?.draw(moment, stage),
    isSlowToDraw: () => this.liveSection?.isSlowToDraw ?? false,
    recorded: (file, clip, settings) => this.desk.showRecording(file, clip, settings),
    stopped: () => this.desk.resume(),
    say: (words) => this.desk.say(words),
  });
  private readonly drop = new FileDrop(this, (files) => this.openFiles(files));

  static override styles = [sharedStyles, appStyles];

  /** Live playback's own figures, for measurements; null while no camera is on. */
  get liveSession(): LiveSession | null {
    return this.live.session;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener('keydown', this.keyed);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener('keydown', this.keyed);
  }

  override render() {
    const { desk, live } = this;
    return html`
      <div class="stack">
        <dw-clip-bar
          .name=${live.on ? live.camera?.label || 'Camera' : (desk.file?.name ?? '')}
          .info=${live.on ? null : (desk.clip?.source ?? null)}
          .live=${live.on}
          @files=${(event: CustomEvent<readonly File[]>) => this.openFiles(event.detail)}
          @save=${() => desk.save()}
          @camera=${() => this.startCamera()}
          @help=${() => this.keys.open()}
        ></dw-clip-bar>
        <div class="notices">
        <div role="alert">${renderNotice('error', desk.error, () => desk.dismissError())}</div>
        <div role="status">${renderNotice('note', desk.note, () => desk.dismissNote())}</div>
        </div>
        ${
          live.on
            ? html`<dw-live-section
                .desk=${live}
                .settings=${desk.settings}
                .aspect=${this.aspect}
                @picture=${(event: CustomEvent<number>) => {
                  this.aspect = event.detail;
                }}
              ></dw-live-section>`
            : this.renderClip()
        }
        <div class="stack lower">
          <dw-settings-panel
            class="card"
            .settings=${desk.settings}
            .frameRate=${(live.on ? live.status?.frameRate : desk.clip?.source.frameRate) ?? 0}
            @settings-change=${(event: CustomEvent<Settings>) => this.changeSettings(event.detail)}
          ></dw-settings-panel>
          ${
            live.on
              ? html`<dw-live-cost-panel
                  class="card"
                  .report=${live.report}
                  .mode=${live.choices.mode}
                ></dw-live-cost-panel>`
              : html`<dw-cost-panel class="card" .clip=${desk.clip} .frame=${this.frame}></dw-cost-panel>`
          }
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

  private renderClip() {
    const { desk, frame, playing, muted, rate } = this;
    const { clip, job } = desk;
    return html`<section class="viewer card" aria-label="The clip and its poses">
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
            @toggle=${() => this.view?.playback?.toggle()}
            @unplayable=${() => desk.cannotPlay()}
          ></dw-clip-view>
        </div>
        <div class="pane ${job && clip ? 'dimmed' : ''}">
          <dw-stage-view
            .sequence=${clip?.poses3d ?? null}
            .flat=${clip !== null && clip.poses3d === null}
            .frame=${frame}
          ></dw-stage-view>
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
    </section>`;
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
    const { clip, job, error, settings } = this.desk;
    dataset.estimator = settings.estimator;
    dataset.state = this.live.on
      ? 'live'
      : pageState(job?.progress ?? null, error !== '', clip !== null);
    if (!clip) return;
    dataset.frames = String(clip.source.frameCount);
    dataset.every = String(clip.interval);
  }

  private openFiles(files: readonly File[]): void {
    // What is no video leaves the camera, and what it records, alone.
    if (this.desk.openFiles(files)) this.live.stop();
  }

  private startCamera(): void {
    this.desk.rest();
    void this.live.start(this.desk.settings);
  }

  private changeSettings(settings: Settings): void {
    if (this.live.on) {
      this.desk.adopt(settings);
      this.live.change(settings);
    } else {
      this.desk.change(settings);
    }
  }

  private played(event: CustomEvent<PlaybackState>): void {
    this.frame = event.detail.frame;
    this.playing = event.detail.playing;
  }

  private scrub(frame: number): void {
    const playback = this.view?.playback;
    playback?.pause();
    playback?.seek(frame);
    this.requestUpdate();
  }

  private act(action: TransportAction): void {
    const playback = this.view?.playback;
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
        this.changeSettings(stepEvery(this.desk.settings, -1));
        break;
      case 'more':
        this.changeSettings(stepEvery(this.desk.settings, 1));
        break;
      case 'open':
        this.bar.choose();
        break;
      case 'save':
        if (!this.live.on) this.desk.save();
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

declare global {
  interface HTMLElementTagNameMap {
    'deciwatch-app': DeciWatchApp;
  }
}
