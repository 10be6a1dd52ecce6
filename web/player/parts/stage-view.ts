import { css, html, LitElement, nothing, type PropertyValues } from 'lit';
import { property, query, state } from 'lit/decorators.js';
import { DeciWatchError } from '../../errors.ts';
import { BLAZEPOSE_33 } from '../../pose/blazepose33.ts';
import { hasPose, type PoseSequence } from '../../pose/sequence.ts';
import type { CameraPlace, StageView as View } from '../../stage/camera-rig.ts';
import { ContextShare, type Drawer } from '../../stage/context-share.ts';
import type { Stage, StagePose } from '../../stage/stage.ts';
import { element } from './element.ts';
import { icon } from './icons.ts';
import { sharedStyles } from './styles.ts';
import { ThemeController, themeStyles } from './theme.ts';

const VIEWS: readonly { view: View; label: string }[] = [
  { view: 'angle', label: 'Angle' },
  { view: 'front', label: 'Front' },
  { view: 'side', label: 'Side' },
  { view: 'top', label: 'Top' },
];
const LOST = 'The graphics card dropped the 3D view; it comes back by itself.';
const NOT_LOADED = 'The 3D view could not be loaded; reload the page to try again.';
/** Phones have eight, and the page may draw by WebGL itself. */
const contexts = new ContextShare(6);
/** Half a window beyond its edge: it is there again before it is seen. */
const SIGHT_MARGIN = '50%';
const TURN_DEG = 15;
const ZOOM = 1.2;

/**
 * The 3D view of the poses, with its camera's buttons and keys. On a page with many of them, those out of sight
 * rest without a WebGL context, and come back as they were.
 *
 * @fires unavailable with a DeciWatchError as detail, where there is no 3D view
 */
@element('dw-stage-view')
export class StageView extends LitElement implements Drawer {
  @property({ attribute: false }) sequence: PoseSequence | null = null;
  @property({ attribute: false }) frame = 0;
  /** The sequence is shown as in a mirror. */
  @property({ attribute: false }) mirrored = false;
  /** There is a clip, but its poses have no third dimension. */
  @property({ attribute: false }) flat = false;
  /** Poses come one by one by {@link showPose}; as in a mirror, or as the camera sees them. */
  @property({ attribute: false }) live: 'mirrored' | 'plain' | null = null;
  @state() private view: View | null = 'angle';
  @state() private trails = true;
  @state() private message = '';
  @query('.canvas') private container!: HTMLElement;
  private stage: Stage | null = null;
  private place: CameraPlace | null = null;
  private resting = false;
  private seen = false;
  private readonly sight = new IntersectionObserver(
    (entries) => this.looked(entries.at(-1)!.isIntersecting),
    { rootMargin: SIGHT_MARGIN },
  );
  private readonly themes = new ThemeController(this);

  static override styles = [
    sharedStyles,
    themeStyles,
    css`
      :host { display: block; position: relative; background: var(--sunken); overflow: hidden; container-type: inline-size; }
      .canvas { position: absolute; inset: 0; cursor: grab; }
      .canvas:active { cursor: grabbing; }
      .canvas:focus-visible { outline-offset: -3px; border-radius: var(--round); }
      .bar { position: absolute; left: 10px; right: 10px; display: flex; justify-content: space-between; pointer-events: none; }
      .top { top: 10px; }
      .bottom { bottom: 10px; align-items: end; }
      .group { display: flex; gap: 2px; pointer-events: auto; }
      .group button {
        min-height: 34px; min-width: 34px; padding: 0 8px; font-size: 13px; border-color: transparent;
        background: transparent; color: var(--muted);
      }
      .group button:hover { background: var(--hover); color: var(--ink); }
      .group button[aria-pressed='true'] { color: var(--ink); background: var(--pressed); font-weight: 560; }
      @container (max-width: 288px) {
        .bar { left: 4px; right: 4px; }
        .group button { padding: 0 4px; min-width: 28px; font-size: 12px; }
        .hint, .trails { display: none; }
      }
      .hint { font-size: 12px; color: var(--muted); padding: 0 6px 6px; }
      .message, .nobody { position: absolute; inset: 0; display: grid; place-content: center; padding: 56px 32px; text-align: center; color: var(--muted); }
      .message { background: var(--sunken); }
      .nobody { pointer-events: none; opacity: 0; }
      .nobody.shown { opacity: 1; transition: opacity 250ms; }
    `,
  ];

  override render() {
    const nobody = !this.live && this.sequence !== null && !hasPose(this.sequence, this.frame);
    return html`<div data-testid="stage">
      <div
        class="canvas"
        tabindex="0"
        role="img"
        aria-label="The skeleton in 3D. Arrow keys turn it, plus and minus zoom, 0 goes back."
        @keydown=${this.keyed}
        @pointerdown=${this.taken}
      ></div>
      <p class="nobody ${(nobody || this.flat) && !this.message ? 'shown' : ''}" aria-hidden=${!nobody && !this.flat}>
        ${this.flat ? 'This estimator gives no 3D' : 'Nobody seen in this frame'}
      </p>
      ${this.message ? html`<p class="message" role="status">${this.message}</p>` : this.renderBars()}
    </div>`;
  }

  private renderBars() {
    const button = (label: string, name: Parameters<typeof icon>[0], act: () => void) =>
      html`<button aria-label=${label} title=${label} @click=${act}>${icon(name)}</button>`;
    return html`
      <div class="bar top">
        <div class="group" role="group" aria-label="Viewpoint">
          ${VIEWS.map(
            ({ view, label }) => html`<button
              aria-pressed=${this.view === view}
              @click=${() => this.look(view)}
            >${label}</button>`,
          )}
        </div>
        <div class="group trails" ?hidden=${this.live !== null}>
          <button
            aria-pressed=${this.trails}
            title="Paths of wrists and ankles: large dots were watched, small ones recovered"
            @click=${this.toggleTrails}
          >Trails</button>
        </div>
      </div>
      <div class="bar bottom">
        <span class="hint">${this.sequence || this.live ? 'Grid: 1 m' : nothing}</span>
        <div class="group" role="group" aria-label="Camera">
          ${button('Turn left', 'left', () => this.turn(-TURN_DEG, 0))}
          ${button('Turn right', 'right', () => this.turn(TURN_DEG, 0))}
          ${button('Zoom out', 'minus', () => this.zoom(1 / ZOOM))}
          ${button('Zoom in', 'plus', () => this.zoom(ZOOM))}
        </div>
      </div>
    `;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.sight.observe(this);
    void this.start();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sight.disconnect();
    contexts.leave(this);
    this.rest();
    this.resting = false;
    this.seen = false;
  }

  get inSight(): boolean {
    return this.seen;
  }

  rest(): void {
    this.resting = true;
    this.place = this.stage?.camera.place ?? this.place;
    this.stage?.dispose();
    this.stage = null;
  }

  private looked(inSight: boolean): void {
    this.seen = inSight;
    if (!inSight) return;
    if (this.stage) contexts.join(this);
    else if (this.resting) void this.start();
  }

  protected override updated(changes: PropertyValues<this>): void {
    if (!this.stage) return;
    if (this.themes.theme !== this.shownTheme) {
      this.shownTheme = this.themes.theme;
      this.stage.setTheme(this.shownTheme);
    }
    const refill = ['sequence', 'live', 'mirrored'] as const;
    if (refill.some((name) => changes.has(name))) this.fill();
    else if (changes.has('frame')) this.stage.showFrame(this.frame);
  }

  private shownTheme = this.themes.theme;

  /** three.js is most of the page's code: it is fetched while the models are. */
  private async start(): Promise<void> {
    try {
      const { Stage } = await import('../../stage/stage.ts');
      await this.updateComplete;
      if (!this.isConnected || this.stage || !contexts.join(this)) return;
      this.resting = false;
      this.message = '';
      this.shownTheme = this.themes.theme;
      this.stage = new Stage(this.container, {
        theme: this.shownTheme,
        onContext: (context) => {
          this.message = context === 'lost' ? LOST : '';
        },
      });
      this.fill();
      this.stage.setTrails(this.trails);
      if (this.place) this.stage.camera.put(this.place);
    } catch (error) {
      contexts.leave(this);
      const detail =
        error instanceof DeciWatchError
          ? error
          : new DeciWatchError('webgl-unavailable', NOT_LOADED, { cause: error });
      this.message = detail.message;
      this.dispatchEvent(new CustomEvent<DeciWatchError>('unavailable', { detail }));
    }
  }

  /** Shows a moment of live playback, or nobody. */
  showPose(pose: StagePose | null): void {
    this.stage?.showPose(pose);
  }

  /** Whether pictures are drawn by the processor, so that each costs much. */
  get isSoftware(): boolean {
    return this.stage?.isSoftware ?? false;
  }

  private fill(): void {
    if (this.live) {
      this.stage?.setLive(BLAZEPOSE_33, this.live === 'mirrored');
    } else {
      this.stage?.setSequence(this.sequence, this.mirrored);
      this.stage?.showFrame(this.frame);
    }
  }

  private look(view: View): void {
    this.view = view;
    this.stage?.view(view);
  }

  private turn(azimuth: number, elevation: number): void {
    this.view = null;
    this.stage?.camera.rotate(azimuth, elevation);
  }

  private zoom(factor: number): void {
    this.stage?.camera.zoom(factor);
  }

  private toggleTrails(): void {
    this.trails = !this.trails;
    this.stage?.setTrails(this.trails);
  }

  private taken(): void {
    this.view = null;
  }

  private keyed(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const acts: Readonly<Record<string, () => void>> = {
      ArrowLeft: () => this.turn(-TURN_DEG, 0),
      ArrowRight: () => this.turn(TURN_DEG, 0),
      ArrowUp: () => this.turn(0, TURN_DEG / 2),
      ArrowDown: () => this.turn(0, -TURN_DEG / 2),
      '+': () => this.zoom(ZOOM),
      '=': () => this.zoom(ZOOM),
      '-': () => this.zoom(1 / ZOOM),
      '0': () => this.look('angle'),
    };
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'dw-stage-view': StageView;
  }
}
