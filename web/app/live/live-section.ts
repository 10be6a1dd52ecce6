import { css, html, LitElement, nothing } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { LiveView as Moment } from '../../engine/live/types.ts';
import { appStyles } from '../app-styles.ts';
import type { Settings } from '../settings.ts';
import '../../player/parts/stage-view.ts';
import type { StageView } from '../../player/parts/stage-view.ts';
import { sharedStyles } from '../../player/parts/styles.ts';
import './live-bar.ts';
import type { LiveAction } from './live-bar.ts';
import type { LiveChoices, LiveDesk } from './live-desk.ts';
import '../../player/live/live-view.ts';
import type { LiveView, ShownFrame } from '../../player/live/live-view.ts';
import { liveWords, loadWords } from '../../player/live/live-words.ts';

/**
 * The camera's picture, the 3D view beside it, what is going on, and the controls.
 *
 * @fires picture with width by height of the camera's picture as detail
 */
@customElement('dw-live-section')
export class LiveSection extends LitElement {
  /** The same object every time, and never the same state. */
  @property({ attribute: false, hasChanged: () => true }) desk!: LiveDesk;
  @property({ attribute: false }) settings!: Settings;
  /** Width by height of the picture. */
  @property({ attribute: false }) aspect = 16 / 9;
  @query('dw-live-view') private view!: LiveView | null;
  @query('dw-stage-view') private stage!: StageView | null;

  static override styles = [
    sharedStyles,
    appStyles,
    css`
      .state { display: flex; align-items: baseline; gap: 0.625rem; font-size: 0.9375rem; min-height: 1.5rem; }
      .state i { flex: none; width: 0.625rem; height: 0.625rem; border-radius: 50%; background: var(--line-strong); }
      .state i.following { background: var(--accent); }
      .state i.recording { background: var(--danger); }
    `,
  ];

  /** Draws one moment, in the 3D view too where `stage` says so. */
  draw({ time, pose }: Pick<Moment, 'time' | 'pose'>, stage: boolean): void {
    this.view?.paint({ time, pose });
    if (!stage) return;
    this.stage?.showPose(
      pose && { values: pose.values3d, scores: pose.scores, presence: pose.presence, time },
    );
  }

  /** Each picture of the 3D view is drawn by the processor. */
  get isSlowToDraw(): boolean {
    return this.stage?.isSoftware ?? false;
  }

  override render() {
    const { desk } = this;
    const { choices, status, camera } = desk;
    return html`<section class="viewer card" aria-label="The camera and its poses">
      <div class="panes" style="--aspect: ${this.aspect}">
        <div class="pane">
          <dw-live-view
            .stream=${camera?.stream ?? null}
            .mirrored=${choices.mirrored}
            .delayed=${choices.mode === 'smooth'}
            @camera-frame=${(event: CustomEvent<ShownFrame>) => desk.frame(event.detail)}
            @picture=${(event: CustomEvent<number>) =>
              this.dispatchEvent(new CustomEvent<number>('picture', { detail: event.detail }))}
          ></dw-live-view>
        </div>
        <div class="pane">
          <dw-stage-view .live=${choices.mirrored ? 'mirrored' : 'plain'}></dw-stage-view>
        </div>
      </div>
      <div class="deck">
        ${this.renderState()}
        <dw-live-bar
          .choices=${choices}
          .cameras=${desk.cameras}
          .camera=${camera?.id ?? ''}
          .ready=${status !== null && status.state !== 'loading' && status.state !== 'waiting'}
          .recording=${desk.recording}
          .recovering=${desk.recovering}
          @live=${(event: CustomEvent<LiveAction>) => this.act(event.detail)}
          @camera=${(event: CustomEvent<string>) => void desk.start(this.settings, event.detail)}
          @choices=${(event: CustomEvent<LiveChoices>) => desk.choose(event.detail)}
        ></dw-live-bar>
      </div>
    </section>`;
  }

  private renderState() {
    const { desk } = this;
    const { status } = desk;
    const words = desk.opening
      ? 'Asking for the camera: allow it for this page.'
      : desk.recovering
        ? 'Recovering every frame of the recording …'
        : liveWords(status?.state ?? 'loading');
    const load = status ? loadWords(status, { ...this.settings, ...desk.choices }) : '';
    const rate = status?.frameRate ? ` ${Math.round(status.frameRate)} frames a second.` : '';
    return html`<p
      class="state"
      role="status"
      data-testid="live-state"
      data-state=${status?.state ?? 'asking'}
    >
      <i class=${desk.recording ? 'recording' : (status?.state ?? '')}></i>
      <span>${desk.recording ? 'Recording. ' : nothing}${words}${rate} ${load}</span>
    </p>`;
  }

  private act(action: LiveAction): void {
    switch (action) {
      case 'stop':
        this.desk.putAway();
        break;
      case 'record':
        this.desk.startRecording();
        break;
      case 'stop-recording':
        void this.desk.stopRecording();
        break;
    }
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-live-section': LiveSection;
  }
}
