import { html, nothing, type PropertyValues } from 'lit';
import { query } from 'lit/decorators.js';
import type { DeciWatchError } from '../errors.ts';
import { renderPoster, renderProblem, renderProgress, renderStart } from './cover.ts';
import { FullscreenController } from './fullscreen.ts';
import { PlayerKeys } from './keys.ts';
import './live/live-view.ts';
import type { ShownFrame } from './live/live-view.ts';
import './parts/clip-view.ts';
import { element } from './parts/element.ts';
import type { PlaybackState } from './parts/playback.ts';
import './parts/stage-view.ts';
import { sharedStyles } from './parts/styles.ts';
import { tokens } from './parts/tokens.ts';
import { PlayerBehaviour } from './player-behaviour.ts';
import './player-controls.ts';
import type { ControlAction, PlayerControls } from './player-controls.ts';
import { playerStyles } from './player-styles.ts';
import { shapeOf } from './shape.ts';
import type { DeciWatchPlayer, PlayerView } from './types.ts';

const PLAYER_VIEWS: readonly PlayerView[] = ['overlay', 'stage', 'both'];

/** See {@link DeciWatchPlayer}, which is what its users see of it. */
@element('deciwatch-player')
export class PlayerElement extends PlayerBehaviour implements DeciWatchPlayer {
  @query('dw-player-controls') protected controlBar!: PlayerControls | null;
  private readonly fullscreen = new FullscreenController(this);
  /** The focus was in the cover before the update under way. */
  private coverFocused = false;

  constructor() {
    super();
    new PlayerKeys(this, (action) => this.obey(action));
  }

  static override styles = [sharedStyles, tokens, playerStyles];

  protected override willUpdate(changes: PropertyValues<this>): void {
    this.coverFocused = this.shadowRoot?.activeElement?.closest('.cover') != null;
    super.willUpdate(changes);
  }

  protected override updated(changes: PropertyValues<this>): void {
    super.updated(changes);
    this.keepFocus();
  }

  override render() {
    const view = this.shownView;
    return html`<div class="player" part="player" tabindex="-1">
      <div class="panes ${view}" part="panes" .style=${shapeOf(view, this.aspect)}>
        ${this.camera ? this.renderCamera() : this.renderVideo()}
        ${view === 'overlay' ? nothing : this.renderStage()}
        <div class="cover over-picture">${this.renderOverPicture()}</div>
        <div class="cover">${this.renderCover()}</div>
      </div>
      ${
        this.notice
          ? html`<p class="notice" part="notice" role="alert">${this.notice.message}</p>`
          : nothing
      }
      ${this.controls ? this.renderControls() : nothing}
      <p class="visually-hidden" role="status">${this.status}</p>
    </div>`;
  }

  /** A button in the middle that has been used goes, and must not take the keyboard's place with it. */
  private keepFocus(): void {
    const { shadowRoot } = this;
    if (!this.coverFocused || shadowRoot?.activeElement) return;
    const next = shadowRoot?.querySelector<HTMLElement>('.cover button:not(:disabled)');
    if (next) next.focus();
    else if (this.controls) void this.controlBar?.focusFirst();
    else shadowRoot?.querySelector<HTMLElement>('.player')?.focus();
  }

  private get shownView(): PlayerView {
    return PLAYER_VIEWS.find((view) => view === this.view) ?? 'both';
  }

  private renderVideo() {
    return html`<dw-clip-view
      part="video"
      class=${this.clipSide.progress && this.clip ? 'dimmed' : ''}
      .src=${this.clipSide.url ?? this.previewUrl()}
      .preload=${this.clipSide.url ? 'auto' : 'metadata'}
      .clip=${this.clip}
      .frame=${this.frame}
      .muted=${this.muted}
      .volume=${this.volume}
      .rate=${this.playbackRate}
      .loop=${this.loop}
      .mirrored=${this.mirror}
      @playback=${(event: CustomEvent<PlaybackState>) => this.played(event.detail)}
      @picture=${this.pictured}
      @media=${(event: CustomEvent<string>) => this.media(event.detail)}
      @toggle=${() => this.toggle()}
      @unplayable=${() => this.cannotPlay()}
    ></dw-clip-view>`;
  }

  private renderCamera() {
    return html`<dw-live-view
      part="video"
      .stream=${this.cameraSide.stream}
      .mirrored=${this.mirror}
      .delayed=${this.mode === 'smooth'}
      @camera-frame=${(event: CustomEvent<ShownFrame>) => this.cameraSide.frame(event.detail)}
      @picture=${this.pictured}
    ></dw-live-view>`;
  }

  private renderStage() {
    // A page may have many players, but a browser has few WebGL contexts: none before it is needed.
    this.staged ||= this.clip !== null || this.clipSide.progress !== null || this.cameraSide.on;
    if (!this.staged)
      return html`<div class="unstaged" part="stage"><p>The skeleton in 3D comes here</p></div>`;
    return html`<dw-stage-view
      part="stage"
      .sequence=${this.clip?.poses3d ?? null}
      .flat=${this.clip !== null && this.clip.poses3d === null}
      .frame=${this.frame}
      .mirrored=${this.mirror}
      .live=${this.camera ? (this.mirror ? 'mirrored' : 'plain') : null}
      @unavailable=${(event: CustomEvent<DeciWatchError>) => this.warn(event.detail)}
    ></dw-stage-view>`;
  }

  private renderControls() {
    return html`<dw-player-controls
      part="controls"
      exportparts="timeline, cost"
      .clip=${this.clip}
      .frame=${this.clipView?.playback?.wantedFrame ?? this.frame}
      .running=${this.wanted}
      .muted=${this.muted}
      .view=${this.shownView}
      .live=${this.camera ? this.cameraSide.words : null}
      .fullscreen=${this.fullscreen.state}
      @control=${(event: CustomEvent<ControlAction>) => this.obey(event.detail)}
    ></dw-player-controls>`;
  }

  /** What must be read, or is being done. */
  private renderCover() {
    if (this.problem) return renderProblem(this.problem, () => void this.play());
    const { progress } = this.clipSide;
    return progress && !this.clip
      ? renderProgress(progress, this.progressWords(progress))
      : nothing;
  }

  private renderOverPicture() {
    return html`
      ${this.started || this.cameraSide.on ? nothing : renderPoster(this.poster)}
      ${this.problem || (this.clipSide.progress && !this.clip) ? nothing : this.renderStart()}
    `;
  }

  /** With a bar of controls the button goes once it has been used. */
  private renderStart() {
    const running = this.wanted;
    if (this.controls && (running || this.started || this.cameraSide.on)) return nothing;
    return renderStart({
      camera: this.camera,
      running,
      disabled: !this.hasSource,
      press: () => this.toggle(),
    });
  }

  /** The clip's own address, for its first picture, until the clip has been fetched. */
  private previewUrl(): string | null {
    // What loads at once needs no picture before.
    const fetchesAtOnce = this.autoplay || this.preload === 'auto';
    if (this.preload === 'none' || fetchesAtOnce || !this.sight.inSight || this.problem)
      return null;
    if (this.poster || this.srcObject || !this.src) return null;
    return URL.canParse(this.src, this.baseURI) ? new URL(this.src, this.baseURI).href : null;
  }

  private obey(action: ControlAction): void {
    const playback = this.clipView?.playback;
    switch (action.kind) {
      case 'toggle':
        this.toggle();
        break;
      case 'back':
      case 'forward':
      case 'seek':
        // Keys come also while there is nothing to go through.
        if (!this.clip || !playback) break;
        this.pause();
        this.seek(
          action.kind === 'seek'
            ? action.frame
            : playback.wantedFrame + (action.kind === 'back' ? -1 : 1),
        );
        break;
      case 'mute':
        this.muted = !this.muted;
        break;
      case 'view':
        this.view = action.view;
        break;
      case 'fullscreen':
        this.fullscreen.toggle();
        break;
    }
  }
}
