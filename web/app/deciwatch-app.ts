import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import type { RecoveredClip } from '../engine/types.ts';
import { appStyles } from './app-styles.ts';
import './clip-bar.ts';
import type { ClipBar } from './clip-bar.ts';
import './clip-view.ts';
import type { ClipView } from './clip-view.ts';
import './cost-panel.ts';
import { costHeadline } from './cost-words.ts';
import { pickVideo } from './dropped-file.ts';
import { FileDrop } from './file-drop.ts';
import { formatCount } from './format.ts';
import { icon } from './icons.ts';
import { pageState } from './page-state.ts';
import type { PlaybackState } from './playback.ts';
import './progress-card.ts';
import { type ClipFile, RecoverJob } from './recover-job.ts';
import { fetchSample } from './sample.ts';
import { savePoses } from './save-poses.ts';
import { DEFAULT_SETTINGS, type Settings, stepEvery } from './settings.ts';
import './settings-panel.ts';
import { keyTargetOf, type ShortcutAction, shortcutFor } from './shortcuts.ts';
import './shortcuts-dialog.ts';
import type { ShortcutsDialog } from './shortcuts-dialog.ts';
import './stage-view.ts';
import { sharedStyles } from './styles.ts';
import './timeline.ts';
import './transport-bar.ts';
import type { TransportAction } from './transport-bar.ts';

/** Long enough for a slider to come to rest. */
const SETTLE_MS = 350;

/** A video with an address that the `<video>` can play. Whoever drops it revokes the address. */
interface OpenFile extends ClipFile {
  readonly url: string;
}

/** What the page shows: a video, and its poses once they are there. */
interface Shown {
  readonly file: OpenFile;
  readonly result: { readonly clip: RecoveredClip; readonly settings: Settings } | null;
}

/** The demo page's one application element. */
@customElement('deciwatch-app')
export class DeciWatchApp extends LitElement {
  @state() private shown: Shown | null = null;
  @state() private settings = DEFAULT_SETTINGS;
  @state() private error = '';
  @state() private note = '';
  @state() private status = '';
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
  /** Playback pauses while a job runs, so that the milliseconds measured are the job's own. */
  private resume = false;
  private readonly drop = new FileDrop(this, (files) => this.openFiles(files));
  private readonly work = new RecoverJob<OpenFile>(this, {
    done: (file, clip) => this.finish(file, clip),
    failed: (file, message) => this.fail(file, message),
  });

  static override styles = [sharedStyles, appStyles];

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener('keydown', this.keyed);
    void this.openSample();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener('keydown', this.keyed);
    if (this.shown) URL.revokeObjectURL(this.shown.file.url);
    this.shown = null;
  }

  override render() {
    const { shown, frame, playing, muted, rate, settings } = this;
    const clip = shown?.result?.clip ?? null;
    const { job } = this.work;
    return html`
      <div class="stack">
        <dw-clip-bar
          .name=${shown?.file.name ?? ''}
          .info=${clip?.source ?? null}
          @files=${(event: CustomEvent<readonly File[]>) => this.openFiles(event.detail)}
          @save=${this.save}
          @help=${() => this.keys.open()}
        ></dw-clip-bar>
        <div class="notices">
        <div role="alert">${this.renderNotice('error', this.error, () => {
          this.error = '';
        })}</div>
        <div role="status">${this.renderNotice('note', this.note, () => {
          this.note = '';
        })}</div>
        </div>

        <section class="viewer card" aria-label="The clip and its poses">
          <div class="panes" style="--aspect: ${this.aspect}">
            <div class="pane ${job && clip ? 'dimmed' : ''}">
              <dw-clip-view
                .src=${shown?.file.url ?? null}
                .clip=${clip}
                .frame=${frame}
                .muted=${muted}
                .rate=${rate}
                @playback=${this.played}
                @picture=${(event: CustomEvent<number>) => {
                  this.aspect = event.detail;
                }}
                @unplayable=${this.cannotPlay}
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
            .settings=${settings}
            .frameRate=${clip?.source.frameRate ?? 0}
            @settings-change=${(event: CustomEvent<Settings>) => this.change(event.detail)}
          ></dw-settings-panel>
          <dw-cost-panel class="card" .clip=${clip} .frame=${frame}></dw-cost-panel>
        </div>
      </div>
      <p class="visually-hidden" role="status" data-testid="status">${this.status}</p>
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
    const { job } = this.work;
    if (job) {
      return html`<dw-progress-card
        .name=${job.file.name}
        .every=${job.settings.every}
        .progress=${job.progress}
        @cancel=${this.cancel}
      ></dw-progress-card>`;
    }
    const { shown } = this;
    if (!shown || shown.result) return nothing;
    return html`<div class="start card">
      <p>The poses of this video have not been recovered yet.</p>
      <button class="primary" @click=${() => this.work.start(shown.file, this.settings)}>Recover them</button>
    </div>`;
  }

  private renderNotice(kind: 'error' | 'note', text: string, dismiss: () => void) {
    if (!text) return nothing;
    return html`<div class="notice ${kind}">
      <p data-testid=${kind}>${text}</p>
      <button class="bare" aria-label="Dismiss" @click=${dismiss}>${icon('close')}</button>
    </div>`;
  }

  protected override updated(_changes: PropertyValues<this>): void {
    const { dataset } = document.documentElement;
    const clip = this.shown?.result?.clip;
    dataset.state = pageState(
      this.work.job?.progress ?? null,
      this.error !== '',
      clip !== undefined,
    );
    if (!clip) return;
    dataset.frames = String(clip.source.frameCount);
    dataset.every = String(clip.interval);
  }

  private async openSample(): Promise<void> {
    try {
      const file = await fetchSample();
      // Somebody may have opened a video of their own meanwhile.
      if (!this.shown && !this.work.job) this.open(file);
    } catch (error) {
      this.error = (error as Error).message;
    }
  }

  private openFiles(files: readonly File[]): void {
    const { file, note } = pickVideo(files);
    this.error = file ? '' : (note ?? '');
    this.note = file ? (note ?? '') : '';
    if (file) this.open({ blob: file, name: file.name });
  }

  private open(clip: ClipFile): void {
    const file: OpenFile = { ...clip, url: URL.createObjectURL(clip.blob) };
    this.cancelJob();
    // A result stays on screen until the next one is ready; a video without one makes way.
    if (!this.shown?.result) this.show({ file, result: null });
    this.begin(file);
  }

  private begin(file: OpenFile, delayMs = 0): void {
    this.resume ||= this.playing;
    this.view?.playback?.pause();
    this.status = `Working on ${file.name}.`;
    this.work.start(file, this.settings, delayMs);
  }

  private change(settings: Settings): void {
    this.settings = settings;
    const file = this.work.job?.file ?? this.shown?.file;
    if (!file || (!this.work.job && !this.shown?.result)) return;
    this.error = '';
    this.begin(file, SETTLE_MS);
  }

  private finish(file: OpenFile, clip: RecoveredClip): void {
    const fresh = !this.shown?.result || this.shown.file !== file;
    this.show({ file, result: { clip, settings: this.settings } });
    const { figure, sentence } = costHeadline(clip.cost);
    this.status = `Done: ${formatCount(clip.cost.frames)} frames from ${formatCount(clip.cost.estimatorCalls)} looks, ${figure} ${sentence}.`;
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const play = fresh ? !still : this.resume;
    this.resume = false;
    if (play) void this.updateComplete.then(() => this.view.playback?.play());
  }

  private fail(file: OpenFile, message: string): void {
    this.error = message;
    this.status = '';
    this.forget(file);
  }

  private readonly cancel = () => {
    const file = this.cancelJob();
    this.status = 'Cancelled.';
    if (file) this.forget(file);
  };

  /** Ends the running job, whose file is then nobody's unless it is shown. */
  private cancelJob(): OpenFile | null {
    const file = this.work.job?.file ?? null;
    this.work.cancel();
    if (file && file !== this.shown?.file) URL.revokeObjectURL(file.url);
    return file;
  }

  /** After a job that came to nothing: back to what was shown, with the settings that it was made with. */
  private forget(file: OpenFile): void {
    if (file !== this.shown?.file) URL.revokeObjectURL(file.url);
    if (this.shown?.result) this.settings = this.shown.result.settings;
    if (this.resume) void this.view.playback?.play();
    this.resume = false;
  }

  private show(shown: Shown): void {
    const old = this.shown?.file;
    if (old && old !== shown.file) {
      URL.revokeObjectURL(old.url);
      this.frame = 0;
    }
    this.shown = shown;
  }

  private readonly save = () => {
    const clip = this.shown?.result?.clip;
    if (!clip) return;
    savePoses(clip);
    this.status = 'The pose file has been saved.';
  };

  private played(event: CustomEvent<PlaybackState>): void {
    this.frame = event.detail.frame;
    this.playing = event.detail.playing;
  }

  private cannotPlay(): void {
    if (!this.shown) return;
    this.note =
      'This browser cannot play this video; if its poses can be recovered, step through them frame by frame.';
  }

  private scrub(frame: number): void {
    const playback = this.view.playback;
    playback?.pause();
    playback?.seek(frame);
    this.requestUpdate();
  }

  private act(action: TransportAction): void {
    const playback = this.view.playback;
    if (!playback || !this.shown?.result) return;
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
        this.change(stepEvery(this.settings, -1));
        break;
      case 'more':
        this.change(stepEvery(this.settings, 1));
        break;
      case 'open':
        this.bar.choose();
        break;
      case 'save':
        this.save();
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
