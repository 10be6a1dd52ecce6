import type { PropertyValues } from 'lit';
import { query, state } from 'lit/decorators.js';
import type { LiveSettings, LiveView as Moment } from '../engine/live/types.ts';
import type { Engine, RecoveredClip, RecoverProgress } from '../engine/types.ts';
import { DeciWatchError } from '../errors.ts';
import { ESTIMATOR_NAMES } from '../estimators/names.ts';
import { frameAtTime, type PoseSequence } from '../pose/sequence.ts';
import { CameraSide } from './camera-side.ts';
import { ClipSide } from './clip-side.ts';
import { errorDetail } from './details.ts';
import { checkClip } from './fetch-clip.ts';
import type { LiveView } from './live/live-view.ts';
import type { ClipView } from './parts/clip-view.ts';
import { costHeadline } from './parts/cost-words.ts';
import { formatCount } from './parts/format.ts';
import type { PlaybackState } from './parts/playback.ts';
import { progressWords } from './parts/progress-words.ts';
import type { StageView } from './parts/stage-view.ts';
import { LIVE_SETTINGS, PlayerProperties, SETTINGS, SOURCE } from './player-properties.ts';
import { type BorrowedEngine, borrowEngine } from './shared-engine.ts';
import { SightController } from './sight.ts';
import type { PlayerErrorDetail, PlayerEventMap } from './types.ts';

const DEFAULT_ASPECT = 16 / 9;

/**
 * What a player does, and knows of itself: loading, playing, following, telling. What it looks like is its
 * subclass's, which renders the views that are asked for here.
 */
export abstract class PlayerBehaviour extends PlayerProperties {
  @state() protected frame = 0;
  @state() private wantedNow = false;
  /** Has been played or gone through: the poster has done its duty. */
  @state() protected started = false;
  @state() protected aspect = DEFAULT_ASPECT;
  @state() protected problem: PlayerErrorDetail | null = null;
  @state() protected notice: PlayerErrorDetail | null = null;
  @state() protected status = '';
  @query('dw-clip-view') protected clipView!: ClipView | null;
  @query('dw-live-view') private liveView!: LiveView | null;
  @query('dw-stage-view') protected stageView!: StageView | null;

  /** Asked to play, and neither asked to stop nor at the end. */
  protected get wanted(): boolean {
    return this.wantedNow;
  }

  protected set wanted(wanted: boolean) {
    if (wanted === this.wantedNow) return;
    this.wantedNow = wanted;
    this.dispatchEvent(new Event(wanted ? 'play' : 'pause'));
  }

  protected readonly clipSide = new ClipSide({
    source: () => this.source(),
    settings: () => ({ every: this.every, estimator: this.estimator }),
    engine: () => this.borrow(),
    changed: () => this.requestUpdate(),
    progressed: (progress) => this.progressed(progress),
    recovered: (clip) => this.finish(clip),
    failed: (error) => this.fail(error),
    pose: (detail) => this.tell('pose', detail),
  });
  protected readonly cameraSide = new CameraSide({
    settings: () => this.liveSettings(),
    engine: () => this.borrow(),
    draw: (moment, stage) => this.draw(moment, stage),
    isSlowToDraw: () => this.stageView?.isSoftware ?? false,
    changed: () => this.requestUpdate(),
    failed: (error) => this.fail(error),
    pose: (detail) => this.tell('pose', detail),
    cost: (report) => this.tell('cost', report),
  });
  protected readonly sight = new SightController(this, (inSight) => this.seen(inSight));
  private borrowed: BorrowedEngine | null = null;
  /** Loading or playing has been begun, by itself or by somebody: once for each source. */
  private begun = false;
  /** Paused since it was out of sight: goes on when it is seen again. */
  private resting = false;
  /** There has been something for the 3D view to show. */
  protected staged = false;
  /** Counts plays and pauses: a play that waits is overtaken by what is asked after it. */
  private asked = 0;
  /** Plays that wait for a source that was set a moment ago. */
  private waiting = 0;
  /** The browser's `<video>` cannot show the clip. */
  private unplayable = false;
  /** Seconds to go to once the clip is there. */
  private seekTo: number | null = null;

  get poses(): PoseSequence | null {
    return this.clip?.poses2d ?? null;
  }

  get poses3d(): PoseSequence | null {
    return this.clip?.poses3d ?? null;
  }

  get clip(): RecoveredClip | null {
    return this.clipSide.clip;
  }

  get error(): PlayerErrorDetail | null {
    return this.problem ?? this.notice;
  }

  get paused(): boolean {
    return !this.wanted;
  }

  get ended(): boolean {
    return this.clip !== null && (this.clipView?.video.ended ?? false);
  }

  get duration(): number {
    return this.clip?.source.duration ?? this.clipView?.video?.duration ?? Number.NaN;
  }

  get videoWidth(): number {
    const live = this.cameraSide.size?.width;
    return live ?? this.clip?.source.width ?? this.clipView?.video?.videoWidth ?? 0;
  }

  get videoHeight(): number {
    const live = this.cameraSide.size?.height;
    return live ?? this.clip?.source.height ?? this.clipView?.video?.videoHeight ?? 0;
  }

  get currentTime(): number {
    const times = this.clip?.poses2d.times;
    if (!times) return this.seekTo ?? 0;
    if (this.ended) return this.duration;
    const wanted = this.clipView?.playback?.wantedFrame ?? this.frame;
    return times[wanted]! - times[0]!;
  }

  set currentTime(seconds: number) {
    if (!Number.isFinite(seconds)) throw new TypeError(`currentTime cannot be ${seconds}.`);
    const times = this.clip?.poses2d.times;
    if (times) this.seek(frameAtTime(times, times[0]! + seconds));
    else this.seekTo = seconds;
  }

  async play(): Promise<void> {
    const asked = ++this.asked;
    this.wanted = true;
    if (this.notice?.type === 'play-refused') this.notice = null;
    this.waiting++;
    await this.settled();
    this.waiting--;
    if (asked !== this.asked) return;
    if (this.camera) {
      this.problem = null;
      await this.follow();
    } else if (this.clip && !this.problem) {
      await this.start();
    } else {
      // It starts once the poses are there.
      await this.load();
    }
  }

  pause(): void {
    this.asked++;
    this.wanted = false;
    this.resting = false;
    if (this.camera) this.cameraSide.stop();
    else this.clipView?.playback?.pause();
  }

  async load(): Promise<void> {
    await this.settled();
    this.begun = true;
    if (this.camera || (this.clip && !this.problem)) return;
    this.problem = null;
    this.status = 'Loading.';
    await (this.clip ? this.clipSide.again() : this.clipSide.load());
    // Nobody would take the worker from a player that is not on the page.
    if (!this.isConnected) this.giveBack();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    // A page that only moves the player has put it back by then.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.asked++;
      this.wanted = false;
      this.reset();
    });
  }

  protected override willUpdate(changes: PropertyValues<this>): void {
    if (!this.hasUpdated) return;
    const settings = this.camera ? LIVE_SETTINGS : SETTINGS;
    if (SOURCE.some((name) => changes.has(name))) {
      // Whoever has asked for the new one to be played has not asked for a pause.
      if (this.waiting === 0) this.wanted = false;
      this.reset();
    } else if (settings.some((name) => changes.has(name))) {
      this.changeSettings();
    }
  }

  protected override updated(changes: PropertyValues<this>): void {
    const begins = [...SOURCE, ...LIVE_SETTINGS, 'autoplay', 'preload'] as const;
    if (begins.some((name) => changes.has(name))) this.begin();
  }

  protected progressWords(progress: RecoverProgress): string {
    return this.clipSide.url ? progressWords(progress, this.every) : 'Loading the clip';
  }

  protected get hasSource(): boolean {
    return this.camera || this.srcObject !== null || this.src !== '';
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

  /** @throws DeciWatchError `bad-option` */
  private source(): Blob | URL {
    const { srcObject } = this;
    if (srcObject instanceof Blob) return srcObject;
    if (srcObject) {
      throw new DeciWatchError(
        'bad-option',
        'srcObject takes a File or Blob; for the camera, set camera.',
      );
    }
    if (!this.src) throw new DeciWatchError('bad-option', 'This player has no clip: set its src.');
    try {
      return new URL(this.src, this.baseURI);
    } catch {
      throw new DeciWatchError('bad-option', `${this.src} is not the address of a clip: mend src.`);
    }
  }

  private progressed(progress: RecoverProgress): void {
    const words = `${this.progressWords(progress)}.`;
    if (words !== this.status) this.status = words;
    this.tell('progress', progress);
  }

  private async finish(clip: RecoveredClip): Promise<void> {
    this.aspect = clip.source.width / clip.source.height;
    const { frames, estimatorCalls } = clip.cost;
    const { figure, sentence } = costHeadline(clip.cost);
    this.status = `Ready: ${formatCount(frames)} frames from ${formatCount(estimatorCalls)} looks, ${figure} ${sentence}.`;
    // What was never on the page has no picture yet, and its first update waits for one.
    if (this.hasUpdated) await this.updateComplete;
    if (this.clip !== clip) return;
    this.tell('load', clip);
    this.tell('cost', clip.cost);
    if (this.clip !== clip) return;
    this.clipSide.announced(this.frame);
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
    const { clip } = this;
    const playback = this.clipView?.playback;
    await playback?.play();
    if (this.clip !== clip || !this.wanted) return;
    // Refused: sound without a click, or power saving.
    if (!playback || playback.playing || this.resting) return;
    this.wanted = false;
    if (!this.ended && !this.unplayable) {
      this.warn(
        new DeciWatchError(
          'play-refused',
          'The browser does not play sound before a click: press play, or set muted.',
        ),
      );
    }
  }

  private async follow(): Promise<void> {
    if (this.cameraSide.on) return;
    if (!this.isConnected) {
      this.resting = true;
      return;
    }
    this.begun = true;
    this.status = 'Asking for the camera.';
    if (await this.cameraSide.start()) this.status = 'The camera is on.';
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
    if (this.problem) {
      // Perhaps that was what was wrong.
      this.problem = null;
      this.begun = false;
    }
    try {
      if (this.camera) this.cameraSide.changeSettings();
      else void this.clipSide.again();
    } catch (error) {
      this.cameraSide.stop();
      this.fail(error);
    }
  }

  /** Lets go of all that belongs to the source, and of the engine. */
  private reset(): void {
    this.resting = false;
    this.begun = false;
    this.started = false;
    this.staged = false;
    this.unplayable = false;
    this.cameraSide.stop();
    this.clipSide.reset();
    this.problem = null;
    this.notice = null;
    this.status = '';
    this.frame = 0;
    this.giveBack();
  }

  private giveBack(): void {
    this.borrowed?.release();
    this.borrowed = null;
  }

  private seen(inSight: boolean): void {
    if (!inSight && this.wanted) {
      this.resting = true;
      this.clipView?.playback?.pause();
      this.liveView?.rest(true);
    } else if (inSight && this.resting) {
      this.resting = false;
      this.liveView?.rest(false);
      if (this.camera) void this.follow();
      else if (this.clip) void this.start();
    }
    if (inSight) this.begin();
    this.requestUpdate();
  }

  protected played({ frame }: PlaybackState): void {
    this.frame = frame;
    this.clipSide.shown(frame, !this.clipView?.video.seeking);
  }

  protected media(type: string): void {
    const { video } = this.clipView!;
    if (!this.clip) {
      // Nobody plays a picture without its skeleton.
      if (!video.paused) video.pause();
    } else if (type === 'play') {
      this.wanted = true;
    } else if (type === 'pause') {
      if (!this.resting) this.wanted = false;
    } else if (type === 'ended') {
      this.clipSide.ended();
    }
    // Of the first picture alone, before the clip has been fetched, nothing is told.
    const ofPlayer = type === 'play' || type === 'pause';
    if (this.clipSide.url && !ofPlayer) this.dispatchEvent(new Event(type));
  }

  protected pictured(event: CustomEvent<number>): void {
    this.aspect = event.detail;
  }

  protected cannotPlay(): void {
    if (!this.clipSide.url) {
      // Of the first picture. What else may be wrong with the clip shows when it is played.
      if (!this.begun) void this.checkSource();
      return;
    }
    this.unplayable = true;
    if (!this.clip) return;
    this.warn(
      new DeciWatchError(
        'codec-unsupported',
        'This browser cannot play this video; step through its poses frame by frame.',
      ),
    );
  }

  private async checkSource(): Promise<void> {
    const { src } = this;
    try {
      const source = this.source();
      if (source instanceof URL) await checkClip(source);
    } catch (error) {
      if (src === this.src && !this.begun) this.fail(error);
    }
  }

  protected toggle(): void {
    if (this.wanted) this.pause();
    else void this.play();
  }

  protected seek(frame: number): void {
    this.started = true;
    this.clipSide.jump();
    this.clipView?.playback?.seek(frame);
    this.requestUpdate();
  }

  private draw({ time, pose }: Moment, stage: boolean): void {
    this.liveView?.paint({ time, pose });
    if (!stage) return;
    this.stageView?.showPose(
      pose && { values: pose.values3d, scores: pose.scores, presence: pose.presence, time },
    );
  }

  private fail(error: unknown): void {
    this.wanted = false;
    this.resting = false;
    this.clipView?.playback?.pause();
    this.problem = errorDetail(error, true);
    this.status = '';
    this.tell('error', this.problem);
  }

  /** Something is amiss, but the rest goes on. */
  protected warn(error: DeciWatchError): void {
    this.notice = errorDetail(error, false);
    this.tell('error', this.notice);
  }

  private tell<K extends keyof PlayerEventMap>(type: K, detail: PlayerEventMap[K]['detail']): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
