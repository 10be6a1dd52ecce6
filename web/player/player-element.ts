import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { property, query, state } from 'lit/decorators.js';
import type {
  LiveMode,
  LiveReport,
  LiveSettings,
  LiveView as Moment,
} from '../engine/live/types.ts';
import type { Engine, RecoveredClip, RecoverProgress } from '../engine/types.ts';
import { DeciWatchError } from '../errors.ts';
import type { PoseEstimator } from '../estimators/estimator.ts';
import { DEFAULT_ESTIMATOR, ESTIMATOR_NAMES, type EstimatorName } from '../estimators/names.ts';
import { frameAtTime, hasPose, type PoseSequence, poseAt } from '../pose/sequence.ts';
import { ClipWork } from './clip-work.ts';
import { CameraFollower } from './live/camera-follower.ts';
import './live/live-view.ts';
import type { LiveView, ShownFrame } from './live/live-view.ts';
import { delayWords, liveWords } from './live/live-words.ts';
import './parts/clip-view.ts';
import type { ClipView } from './parts/clip-view.ts';
import { costHeadline } from './parts/cost-words.ts';
import { element } from './parts/element.ts';
import { formatCount } from './parts/format.ts';
import { icon } from './parts/icons.ts';
import type { PlaybackState } from './parts/playback.ts';
import { NOT_STARTED, progressWords } from './parts/progress-words.ts';
import './parts/stage-view.ts';
import type { StageView } from './parts/stage-view.ts';
import { sharedStyles } from './parts/styles.ts';
import { tokens } from './parts/tokens.ts';
import './player-controls.ts';
import type { ControlAction } from './player-controls.ts';
import { playerStyles } from './player-styles.ts';
import { PoseTeller } from './pose-teller.ts';
import { shapeOf } from './shape.ts';
import { type BorrowedEngine, borrowEngine } from './shared-engine.ts';
import { SightController } from './sight.ts';
import type {
  DeciWatchPlayer,
  PlayerErrorDetail,
  PlayerEventMap,
  PlayerPreload,
  PlayerView,
} from './types.ts';

const DEFAULT_EVERY = 10;
const DEFAULT_ASPECT = 16 / 9;

const PLAYER_VIEWS: readonly PlayerView[] = ['overlay', 'stage', 'both'];

/** While the focus is in the player and not on a control that has a use for the key itself. */
const KEYS: Readonly<Record<string, ControlAction>> = {
  k: { kind: 'toggle' },
  m: { kind: 'mute' },
  f: { kind: 'fullscreen' },
  ',': { kind: 'back' },
  '.': { kind: 'forward' },
};

/** An estimator of the page's own has no place in an attribute. */
const ESTIMATOR = {
  fromAttribute: (name: string | null) => (name ?? DEFAULT_ESTIMATOR) as EstimatorName,
  toAttribute: (value: unknown) => (typeof value === 'string' ? value : null),
};

/** Attributes that say what is played, or how its poses are recovered. */
const SOURCE = ['src', 'srcObject', 'camera', 'models'] as const;
const SETTINGS = ['every', 'estimator', 'mode'] as const;

/** See {@link DeciWatchPlayer}, which is what its users see of it. */
@element('deciwatch-player')
export class PlayerElement extends LitElement implements DeciWatchPlayer {
  @property({ reflect: true, useDefault: true }) src = '';
  @property({ attribute: false }) srcObject: Blob | null = null;
  @property({ type: Boolean, reflect: true }) camera = false;
  @property({ type: Number, reflect: true, useDefault: true }) every = DEFAULT_EVERY;
  @property({ reflect: true, useDefault: true, converter: ESTIMATOR })
  estimator: EstimatorName | PoseEstimator = DEFAULT_ESTIMATOR;
  @property({ reflect: true, useDefault: true }) mode: LiveMode = 'smooth';
  @property({ reflect: true, useDefault: true }) view: PlayerView = 'both';
  @property({ type: Boolean, reflect: true }) controls = false;
  @property({ type: Boolean, reflect: true }) autoplay = false;
  @property({ type: Boolean, reflect: true }) loop = false;
  @property({ type: Boolean }) muted = false;
  @property({ attribute: false }) volume = 1;
  @property({ attribute: false }) playbackRate = 1;
  @property({ reflect: true, useDefault: true }) poster = '';
  @property({ type: Boolean, reflect: true }) mirror = false;
  @property({ reflect: true, useDefault: true }) preload: PlayerPreload = 'metadata';
  @property({ reflect: true, useDefault: true }) models = '';

  @state() private frame = 0;
  @state() private playing = false;
  /** Asked to play, and neither asked to stop nor at the end. */
  @state() private wanted = false;
  /** Has been played or gone through: the poster has done its duty. */
  @state() private started = false;
  @state() private aspect = DEFAULT_ASPECT;
  @state() private progress: RecoverProgress | null = null;
  @state() private videoUrl: string | null = null;
  @state() private recovered: RecoveredClip | null = null;
  @state() private problem: PlayerErrorDetail | null = null;
  @state() private notice: PlayerErrorDetail | null = null;
  @state() private status = '';
  @query('dw-clip-view') private clipView!: ClipView | null;
  @query('dw-live-view') private liveView!: LiveView | null;
  @query('dw-stage-view') private stageView!: StageView | null;

  private readonly teller = new PoseTeller();
  private readonly work = new ClipWork();
  private readonly sight = new SightController(this, (inSight) => this.seen(inSight));
  private readonly follower = new CameraFollower({
    engine: () => this.borrow(),
    draw: (moment, stage) => this.draw(moment, stage),
    isSlowToDraw: () => this.stageView?.isSoftware ?? false,
    changed: () => this.liveChanged(),
    failed: (error) => this.fail(error),
  });
  private borrowed: BorrowedEngine | null = null;
  private loading: Promise<void> | null = null;
  /** Loading or playing has been begun, by itself or by somebody: once for each source. */
  private begun = false;
  /** Paused since it was out of sight: goes on when it is seen again. */
  private resting = false;
  private unplayable = false;
  private toldReport: LiveReport | null = null;
  private toldFrame: number | null = null;
  /** Seconds to go to once the clip is there. */
  private seekTo: number | null = null;

  static override styles = [sharedStyles, tokens, playerStyles];

  get poses(): PoseSequence | null {
    return this.recovered?.poses2d ?? null;
  }

  get poses3d(): PoseSequence | null {
    return this.recovered?.poses3d ?? null;
  }

  get clip(): RecoveredClip | null {
    return this.recovered;
  }

  get error(): PlayerErrorDetail | null {
    return this.problem ?? this.notice;
  }

  get paused(): boolean {
    return !this.wanted;
  }

  get ended(): boolean {
    return this.recovered !== null && (this.clipView?.video.ended ?? false);
  }

  get duration(): number {
    return this.recovered?.source.duration ?? this.clipView?.video?.duration ?? Number.NaN;
  }

  get videoWidth(): number {
    const live = this.follower.session?.size?.width;
    return live ?? this.recovered?.source.width ?? this.clipView?.video?.videoWidth ?? 0;
  }

  get videoHeight(): number {
    const live = this.follower.session?.size?.height;
    return live ?? this.recovered?.source.height ?? this.clipView?.video?.videoHeight ?? 0;
  }

  get currentTime(): number {
    const times = this.recovered?.poses2d.times;
    if (!times) return this.seekTo ?? 0;
    const wanted = this.clipView?.playback?.wantedFrame ?? this.frame;
    return times[wanted]! - times[0]!;
  }

  set currentTime(seconds: number) {
    const times = this.recovered?.poses2d.times;
    if (times) this.seek(frameAtTime(times, times[0]! + seconds));
    else this.seekTo = seconds;
  }

  async play(): Promise<void> {
    await this.settled();
    this.wanted = true;
    if (this.camera) {
      this.problem = null;
      await this.follow();
    } else if (this.recovered) {
      await this.start();
    } else {
      // It starts once the poses are there.
      await this.load();
    }
  }

  pause(): void {
    this.wanted = false;
    this.resting = false;
    if (this.camera) this.follower.stop();
    else this.clipView?.playback?.pause();
  }

  async load(): Promise<void> {
    await this.settled();
    this.begun = true;
    if (this.camera || this.recovered) return;
    await (this.loading ?? this.recoverAnew());
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener('fullscreenchange', this.fullscreenChanged);
    this.addEventListener('keydown', this.keyed);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener('fullscreenchange', this.fullscreenChanged);
    this.removeEventListener('keydown', this.keyed);
    // A page that only moves the player has put it back by then.
    queueMicrotask(() => {
      if (!this.isConnected) this.reset();
    });
  }

  protected override willUpdate(changes: PropertyValues<this>): void {
    if (!this.hasUpdated) return;
    if (SOURCE.some((name) => changes.has(name))) this.reset();
    else if (SETTINGS.some((name) => changes.has(name))) this.changeSettings();
  }

  protected override updated(changes: PropertyValues<this>): void {
    const begins = [...SOURCE, 'autoplay', 'preload'] as const;
    if (begins.some((name) => changes.has(name))) this.begin();
  }

  override render() {
    const view = this.shownView;
    return html`<div class="player" part="player">
      <div class="panes ${view}" part="panes" .style=${shapeOf(view, this.aspect)}>
        ${this.camera ? this.renderCamera() : this.renderVideo()}
        ${view === 'overlay' ? nothing : this.renderStage()}
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

  private get shownView(): PlayerView {
    return PLAYER_VIEWS.find((view) => view === this.view) ?? 'both';
  }

  private renderVideo() {
    return html`<dw-clip-view
      part="video"
      class=${this.progress && this.recovered ? 'dimmed' : ''}
      .src=${this.videoUrl ?? this.previewUrl()}
      .preload=${this.videoUrl ? 'auto' : 'metadata'}
      .clip=${this.recovered}
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
      .stream=${this.follower.camera?.stream ?? null}
      .mirrored=${this.mirror}
      .delayed=${this.mode === 'smooth'}
      @camera-frame=${(event: CustomEvent<ShownFrame>) => this.follower.frame(event.detail)}
      @picture=${this.pictured}
    ></dw-live-view>`;
  }

  private renderStage() {
    return html`<dw-stage-view
      part="stage"
      .sequence=${this.recovered?.poses3d ?? null}
      .flat=${this.recovered !== null && this.recovered.poses3d === null}
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
      .clip=${this.recovered}
      .frame=${this.clipView?.playback?.wantedFrame ?? this.frame}
      .running=${this.wanted}
      .muted=${this.muted}
      .view=${this.shownView}
      .live=${this.camera ? this.liveText() : null}
      .fullscreen=${this.fullscreenState()}
      @control=${(event: CustomEvent<ControlAction>) => this.obey(event.detail)}
    ></dw-player-controls>`;
  }

  private renderCover() {
    if (this.problem) return this.renderProblem(this.problem);
    const posterShown = !this.started && !this.follower.on;
    return html`
      ${
        posterShown
          ? html`<slot name="poster">${
              this.poster
                ? html`<img class="poster" part="poster" src=${this.poster} alt="" />`
                : nothing
            }</slot>`
          : nothing
      }
      ${this.progress && !this.recovered ? this.renderProgress(this.progress) : this.renderStart()}
    `;
  }

  private renderProgress(progress: RecoverProgress) {
    const { fraction, framesDone, framesTotal } = progress;
    return html`<slot name="progress"><div class="card box" part="progress">
      <p class="doing">${progressWords(progress, this.every)}</p>
      <progress max="1" .value=${fraction} aria-label="Progress"></progress>
      <p class="figures numbers">
        <span>${Math.floor(fraction * 100)} %</span>
        <span>${framesTotal > 0 ? `frame ${framesDone} of ${framesTotal}` : ''}</span>
      </p>
    </div></slot>`;
  }

  /** The button in the middle; with a bar of controls it goes once it has been used. */
  private renderStart() {
    const running = this.wanted;
    if (this.controls && (running || this.started || this.follower.on)) return nothing;
    const label = this.camera
      ? running
        ? 'Stop the camera'
        : 'Start the camera'
      : running
        ? 'Pause'
        : 'Play';
    const name = this.camera ? (running ? 'stop' : 'camera') : running ? 'pause' : 'play';
    return html`<button
      class="start ${running ? 'quiet' : ''}"
      part="start"
      aria-label=${label}
      ?disabled=${!this.hasSource}
      @click=${() => this.toggle()}
    >${icon(name)}</button>`;
  }

  private renderProblem({ message }: PlayerErrorDetail) {
    return html`<div class="card box problem" part="error" role="alert">
      <p>${message}</p>
      <button @click=${() => void this.play()}>Try again</button>
    </div>`;
  }

  private get hasSource(): boolean {
    return this.camera || this.srcObject !== null || this.src !== '';
  }

  /** The clip's own address, for its first picture, until the clip has been fetched. */
  private previewUrl(): string | null {
    // What loads at once needs no picture before.
    const fetchesAtOnce = this.autoplay || this.preload === 'auto';
    if (this.preload === 'none' || fetchesAtOnce || !this.sight.inSight || this.problem)
      return null;
    if (this.poster || this.srcObject || !this.src) return null;
    return new URL(this.src, this.baseURI).href;
  }

  /** What begins by itself, once the player is in sight. */
  private begin(): void {
    if (this.begun || !this.sight.inSight || !this.hasSource) return;
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (this.autoplay && !still) {
      this.begun = true;
      void this.play();
    } else if (this.preload === 'auto' || this.autoplay) {
      void this.load();
    }
  }

  private borrow(): Engine {
    this.borrowed ??= borrowEngine(this.models);
    return this.borrowed.engine;
  }

  /** A source that was set a moment ago takes the place of the old one with the next update. */
  private async settled(): Promise<void> {
    if (this.hasUpdated && this.isUpdatePending) await this.updateComplete;
  }

  private recoverAnew(): Promise<void> {
    const run = this.recover().finally(() => {
      if (this.loading === run) this.loading = null;
    });
    this.loading = run;
    return run;
  }

  private async recover(): Promise<void> {
    this.problem = null;
    this.progress = NOT_STARTED;
    this.status = 'Loading.';
    try {
      const clip = await this.work.run({
        source: this.srcObject ?? this.address(),
        settings: { every: this.every, estimator: this.estimator },
        engine: () => this.borrow(),
        onFetched: ({ blob }) => this.setVideo(URL.createObjectURL(blob)),
        onProgress: (progress) => this.progressed(progress),
      });
      // Null: another one has taken its place, whose progress it now is.
      if (!clip) return;
      this.progress = null;
      await this.finish(clip);
    } catch (error) {
      this.progress = null;
      this.fail(error);
    }
  }

  /** @throws DeciWatchError `bad-option` */
  private address(): URL {
    if (!this.src) throw new DeciWatchError('bad-option', 'This player has no clip: set its src.');
    try {
      return new URL(this.src, this.baseURI);
    } catch {
      throw new DeciWatchError('bad-option', `${this.src} is not the address of a clip: mend src.`);
    }
  }

  private progressed(progress: RecoverProgress): void {
    if (progress.stage !== this.progress?.stage || this.status === 'Loading.') {
      this.status = `${progressWords(progress, this.every)}.`;
    }
    this.progress = progress;
    this.tell('progress', progress);
  }

  private async finish(clip: RecoveredClip): Promise<void> {
    this.recovered = clip;
    this.teller.reset();
    this.aspect = clip.source.width / clip.source.height;
    const { frames, estimatorCalls } = clip.cost;
    const { figure, sentence } = costHeadline(clip.cost);
    this.status = `Ready: ${formatCount(frames)} frames from ${formatCount(estimatorCalls)} looks, ${figure} ${sentence}.`;
    this.tell('load', clip);
    this.tell('cost', clip.cost);
    await this.updateComplete;
    if (this.unplayable) this.cannotPlay();
    if (this.seekTo !== null) this.currentTime = this.seekTo;
    this.seekTo = null;
    if (this.wanted) await this.start();
  }

  private async start(): Promise<void> {
    this.started = true;
    if (!this.sight.inSight) {
      this.resting = true;
      return;
    }
    const playback = this.clipView?.playback;
    await playback?.play();
    // Refused: sound without a click, or power saving.
    if (playback && !playback.playing && !this.resting) this.wanted = false;
  }

  private async follow(): Promise<void> {
    if (this.follower.on) return;
    this.begun = true;
    this.status = 'Asking for the camera.';
    const camera = await this.follower.start(() => this.liveSettings());
    if (camera) this.status = 'The camera is on.';
  }

  /** @throws DeciWatchError `bad-option` */
  private liveSettings(): LiveSettings {
    const { every, estimator, mode } = this;
    if (typeof estimator === 'string') return { every, estimator, mode, load: 'adapt' };
    throw new DeciWatchError(
      'bad-option',
      `The camera cannot be followed by ${estimator.name}: set estimator to ${ESTIMATOR_NAMES.join(', ')}.`,
    );
  }

  private changeSettings(): void {
    try {
      this.follower.change(this.liveSettings());
    } catch (error) {
      this.follower.stop();
      this.fail(error);
    }
    if (this.recovered || this.loading) void this.recoverAnew();
  }

  /** Lets go of all that belongs to the source, and of the engine. */
  private reset(): void {
    this.wanted = false;
    this.resting = false;
    this.begun = false;
    this.started = false;
    this.unplayable = false;
    this.follower.stop();
    this.work.forget();
    this.loading = null;
    this.progress = null;
    this.problem = null;
    this.notice = null;
    this.recovered = null;
    this.frame = 0;
    this.setVideo(null);
    this.teller.reset();
    this.borrowed?.release();
    this.borrowed = null;
  }

  private setVideo(url: string | null): void {
    if (this.videoUrl) URL.revokeObjectURL(this.videoUrl);
    this.videoUrl = url;
    this.unplayable = false;
  }

  private seen(inSight: boolean): void {
    if (!inSight && this.wanted) {
      this.resting = true;
      this.clipView?.playback?.pause();
      this.liveView?.rest(true);
    } else if (inSight && this.resting) {
      this.resting = false;
      this.liveView?.rest(false);
      if (this.recovered) void this.start();
    }
    if (inSight) this.begin();
    this.requestUpdate();
  }

  private played({ frame, playing }: PlaybackState): void {
    this.frame = frame;
    this.playing = playing;
    if (!this.recovered) return;
    const landed = !this.clipView?.video.seeking;
    const frames = this.recovered.poses2d.times.length;
    for (const told of this.teller.shown(frame, frames, landed)) this.tellPose(told);
  }

  private media(type: string): void {
    const { video } = this.clipView!;
    if (this.recovered) {
      if (type === 'play') this.wanted = true;
      if (type === 'pause' && !this.resting) this.wanted = false;
      if (type === 'ended') {
        const frames = this.recovered.poses2d.times.length;
        for (const told of this.teller.ended(frames)) this.tellPose(told);
      }
    } else if (!video.paused) {
      // Nobody plays a picture without its skeleton.
      video.pause();
    }
    this.dispatchEvent(new Event(type));
  }

  private pictured(event: CustomEvent<number>): void {
    this.aspect = event.detail;
  }

  private cannotPlay(): void {
    this.unplayable = true;
    if (!this.recovered) {
      // What is wrong with it the engine can say, unless it is at it already.
      if (!this.begun) void this.load();
      return;
    }
    this.warn(
      new DeciWatchError(
        'codec-unsupported',
        'This browser cannot play this video; step through its poses frame by frame.',
      ),
    );
  }

  private toggle(): void {
    if (this.wanted) this.pause();
    else void this.play();
  }

  private seek(frame: number): void {
    this.started = true;
    this.teller.jump();
    this.clipView?.playback?.seek(frame);
    this.requestUpdate();
  }

  private obey(action: ControlAction): void {
    const playback = this.clipView?.playback;
    switch (action.kind) {
      case 'toggle':
        this.toggle();
        break;
      case 'back':
      case 'forward':
        this.pause();
        if (playback) this.seek(playback.wantedFrame + (action.kind === 'back' ? -1 : 1));
        break;
      case 'seek':
        this.pause();
        this.seek(action.frame);
        break;
      case 'mute':
        this.muted = !this.muted;
        break;
      case 'view':
        this.view = action.view;
        break;
      case 'fullscreen':
        if (this.fullscreenState() === 'on') void document.exitFullscreen();
        else void this.requestFullscreen().catch(() => {});
        break;
    }
  }

  private readonly keyed = (event: KeyboardEvent) => {
    if (!this.controls || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey)
      return;
    const action = KEYS[event.key];
    if (!action || (this.camera && action.kind !== 'toggle' && action.kind !== 'fullscreen'))
      return;
    event.preventDefault();
    this.obey(action);
  };

  private fullscreenState(): 'on' | 'off' | 'unavailable' {
    if (!document.fullscreenEnabled) return 'unavailable';
    return this.matches(':fullscreen') ? 'on' : 'off';
  }

  private readonly fullscreenChanged = () => this.requestUpdate();

  private liveText(): string {
    const { opening, status, report } = this.follower;
    if (opening) return 'Asking for the camera: allow it for this page.';
    if (!status) return 'The camera is off.';
    const words = liveWords(status.state);
    if (!report || report.shown === 0) return words;
    return `${words} ${delayWords(this.mode, report.delayMs.median)}`;
  }

  private liveChanged(): void {
    const { report } = this.follower;
    if (report && report !== this.toldReport && report.estimatorCalls > 0) {
      this.toldReport = report;
      this.tell('cost', report);
    }
    this.requestUpdate();
  }

  private draw({ time, frame, watched, pose }: Moment, stage: boolean): void {
    this.liveView?.paint({ time, pose });
    if (stage) {
      this.stageView?.showPose(
        pose && { values: pose.values3d, scores: pose.scores, presence: pose.presence, time },
      );
    }
    if (frame === null || frame === this.toldFrame) return;
    this.toldFrame = frame;
    this.tell('pose', {
      time: frame,
      frame: null,
      watched,
      keypoints: pose?.values2d.slice() ?? null,
      keypoints3d: pose?.values3d.slice() ?? null,
      scores: pose?.scores.slice() ?? null,
    });
  }

  private tellPose(frame: number): void {
    const { poses2d, poses3d } = this.recovered!;
    const joints = poses2d.skeleton.joints.length;
    const seen = hasPose(poses2d, frame);
    this.tell('pose', {
      time: poses2d.times[frame]!,
      frame,
      watched: poses2d.watched[frame] === 1,
      keypoints: seen ? poseAt(poses2d, frame).slice() : null,
      keypoints3d: seen && poses3d ? poseAt(poses3d, frame).slice() : null,
      scores: seen ? poses2d.scores.slice(frame * joints, (frame + 1) * joints) : null,
    });
  }

  private fail(error: unknown): void {
    this.wanted = false;
    this.problem = detailOf(error, true);
    this.status = '';
    this.tell('error', this.problem);
  }

  /** Something is amiss, but the rest goes on. */
  private warn(error: DeciWatchError): void {
    this.notice = detailOf(error, false);
    this.tell('error', this.notice);
  }

  private tell<K extends keyof PlayerEventMap>(type: K, detail: PlayerEventMap[K]['detail']): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}

function detailOf(error: unknown, fatal: boolean): PlayerErrorDetail {
  if (error instanceof DeciWatchError) {
    return { type: error.code, message: error.message, cause: error.cause ?? error, fatal };
  }
  const words = error instanceof Error ? error.message : String(error);
  return {
    type: 'engine-crashed',
    message: `Something failed that should not have (${words}): try again, or reload the page.`,
    cause: error,
    fatal,
  };
}
