import { css, html, LitElement, nothing } from 'lit';
import { property } from 'lit/decorators.js';
import type { RecoveredClip } from '../engine/types.ts';
import type { FullscreenState } from './fullscreen.ts';
import { costHeadline } from './parts/cost-words.ts';
import { element } from './parts/element.ts';
import { formatTime } from './parts/format.ts';
import { icon } from './parts/icons.ts';
import { sharedStyles } from './parts/styles.ts';
import './parts/timeline.ts';
import type { PlayerView } from './types.ts';

/** What the bar's controls ask for. */
export type ControlAction =
  | { readonly kind: 'toggle' | 'back' | 'forward' | 'mute' | 'fullscreen' }
  | { readonly kind: 'seek'; readonly frame: number }
  | { readonly kind: 'view'; readonly view: PlayerView };

const VIEWS: readonly { view: PlayerView; label: string; title: string }[] = [
  { view: 'overlay', label: '2D', title: 'the video with its skeleton' },
  { view: 'stage', label: '3D', title: 'the skeleton alone' },
  { view: 'both', label: 'Both', title: 'the video and the 3D view' },
];

/**
 * The player's bar: the frames, play, sound, views, fullscreen, and what it costs.
 *
 * @fires control with a {@link ControlAction} as detail
 */
@element('dw-player-controls')
export class PlayerControls extends LitElement {
  @property({ attribute: false }) clip: RecoveredClip | null = null;
  @property({ attribute: false }) frame = 0;
  /** Runs, or will as soon as it can. */
  @property({ attribute: false }) running = false;
  @property({ attribute: false }) muted = false;
  @property({ attribute: false }) view: PlayerView = 'both';
  /** Words on a camera instead of a clip's frames. */
  @property({ attribute: false }) live: string | null = null;
  @property({ attribute: false }) fullscreen: FullscreenState = 'unavailable';

  static override styles = [
    sharedStyles,
    css`
      :host { display: block; container-type: inline-size; padding: 8px 10px; border-top: 1px solid var(--line); }
      dw-timeline { margin-bottom: 4px; }
      .row { direction: ltr; display: flex; flex-wrap: wrap; align-items: center; gap: 4px 8px; }
      .row button { min-height: 36px; min-width: 36px; }
      .buttons, .views { display: flex; }
      .where { font-size: 13px; white-space: nowrap; }
      .cost { flex: 1 1 96px; min-width: 0; font-size: 13px; color: var(--muted); overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .views button { font-size: 13px; padding: 0 8px; }
      @container (max-width: 544px) {
        .extra { margin-left: auto; }
        .cost { order: 1; flex: 1 1 max(144px, 100% - 150px); white-space: normal; }
        .views { order: 2; }
      }
    `,
  ];

  /** Gives the focus to the button that plays and pauses. */
  async focusFirst(): Promise<void> {
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>('.buttons button:not(:disabled)')?.focus();
  }

  override render() {
    const { clip, live, running } = this;
    return html`
      ${
        live === null
          ? html`<dw-timeline
              part="timeline"
              compact
              .clip=${clip}
              .frame=${this.frame}
              .playing=${running}
              @seek=${(event: CustomEvent<number>) => this.ask({ kind: 'seek', frame: event.detail })}
            ></dw-timeline>`
          : nothing
      }
      <div class="row">
        <div class="buttons" role="group" aria-label="Playback">
          ${
            live === null
              ? html`
                ${this.button('toggle', running ? 'Pause' : 'Play', running ? 'pause' : 'play')}
                ${this.button('back', 'One frame back', 'previous', !clip)}
                ${this.button('forward', 'One frame on', 'next', !clip)}`
              : this.button(
                  'toggle',
                  running ? 'Stop the camera' : 'Start the camera',
                  running ? 'stop' : 'camera',
                )
          }
        </div>
        ${clip && live === null ? this.renderPlace(clip) : nothing}
        <span class="cost" part="cost">${live ?? this.costWords()}</span>
        <div class="views" role="group" aria-label="View">
          ${VIEWS.map(
            ({ view, label, title }) => html`<button
              class="bare"
              title=${`${label}: ${title}`}
              aria-label=${`${label}: ${title}`}
              aria-pressed=${this.view === view}
              @click=${() => this.ask({ kind: 'view', view })}
            >${label}</button>`,
          )}
        </div>
        <div class="buttons extra">
          ${
            live === null
              ? this.button(
                  'mute',
                  this.muted ? 'Sound on' : 'Sound off',
                  this.muted ? 'muted' : 'sound',
                )
              : nothing
          }
          ${
            this.fullscreen === 'unavailable'
              ? nothing
              : this.button(
                  'fullscreen',
                  this.fullscreen === 'on' ? 'Leave fullscreen' : 'Fullscreen',
                  this.fullscreen === 'on' ? 'shrink' : 'grow',
                )
          }
        </div>
      </div>
    `;
  }

  private renderPlace(clip: RecoveredClip) {
    const { times } = clip.poses2d;
    const frame = Math.min(this.frame, times.length - 1);
    return html`<span class="where numbers">
      ${formatTime(times[frame]! - times[0]!).replace(/\s?s$/, '')} <span class="muted">/ ${formatTime(clip.source.duration)}</span>
    </span>`;
  }

  private costWords(): string {
    if (!this.clip) return '';
    const { estimatorCalls, frames } = this.clip.cost;
    const looks = `${estimatorCalls} of ${frames} frames watched`;
    if (this.clip.cost.flopsRatio === null) return looks;
    return `${looks} · ${costHeadline(this.clip.cost).figure} of the FLOPs`;
  }

  private button(
    kind: 'toggle' | 'back' | 'forward' | 'mute' | 'fullscreen',
    label: string,
    name: Parameters<typeof icon>[0],
    disabled = false,
  ) {
    return html`<button
      class="bare"
      aria-label=${label}
      title=${label}
      ?disabled=${disabled}
      @click=${() => this.ask({ kind })}
    >${icon(name)}</button>`;
  }

  private ask(detail: ControlAction): void {
    this.dispatchEvent(new CustomEvent<ControlAction>('control', { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-player-controls': PlayerControls;
  }
}
