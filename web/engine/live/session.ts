import type { Remote } from 'comlink';
import * as Comlink from 'comlink';
import { LiveMeter } from '../../cost/live-meter.ts';
import { DeciWatchError } from '../../errors.ts';
import { LiveSampler } from '../../sampling/live-sampler.ts';
import { MAX_GAP_SECONDS } from '../../sampling/segments.ts';
import type { CameraFrame } from '../../sources/camera-frames.ts';
import { checkEstimator } from '../check-estimator.ts';
import type { EngineFiles } from '../files.ts';
import type { EngineWorker } from '../messages.ts';
import { crash, errorOf } from '../outcome.ts';
import type { RecoveredClip } from '../types.ts';
import type { WorkerLife } from '../worker-life.ts';
import { CameraClock } from './camera-clock.ts';
import { SmoothDelay } from './delay.ts';
import type { Failure, WatchAnswer } from './messages.ts';
import { Recording } from './recording.ts';
import { LiveStateWatch } from './state.ts';
import { LiveTrack } from './track.ts';
import type { LiveSession, LiveSettings, LiveState, LiveStatus, LiveView } from './types.ts';

/** Looks ahead so much further than the next answer is due. */
const SPARE_S = 0.15;
const FURTHEST_S = 1;

/** At N = 1 and 60 frames a second, a second's worth. */
const LOOKS_KEPT = 64;

/** What the session needs of the engine that it runs on. */
export interface LiveHost {
  readonly remote: Remote<EngineWorker>;
  readonly life: WorkerLife;
  readonly files: EngineFiles;
  /** The session has ended. */
  onClose(): void;
}

/** {@link LiveSession} on a worker: at most one frame is with it at any time. */
export class WorkerLiveSession implements LiveSession {
  onStatus: (() => void) | null = null;
  onError: ((error: DeciWatchError) => void) | null = null;
  readonly #forgetDeath: () => void;
  #settings: LiveSettings;
  #sampler: LiveSampler;
  #meter = new LiveMeter(1);
  #ready = false;
  /** Counts them: the last one's answer is the one that is waited for. */
  #preparations = 0;
  #closed = false;
  #busy = false;
  #afresh = true;
  #size: { readonly width: number; readonly height: number } | null = null;
  readonly #track = new LiveTrack();
  readonly #delay = new SmoothDelay();
  /** Times of the last looks, as long ago as anything is shown. */
  #looks: number[] = [];
  #callSeconds = 0.1;
  #shownTime = 0;
  readonly #clock = new CameraClock();
  #countedTime = Number.NEGATIVE_INFINITY;
  readonly #watch = new LiveStateWatch();
  #state: LiveState = 'loading';
  /** N when the status was last told. */
  #every = 0;
  #recording: Recording | null = null;

  constructor(
    private readonly host: LiveHost,
    settings: LiveSettings,
  ) {
    this.#settings = settings;
    this.#sampler = new LiveSampler(settings.every, settings.load);
    this.#forgetDeath = host.life.onDeath((error) => this.#fail(error));
    void this.#prepare();
  }

  get settings(): LiveSettings {
    return this.#settings;
  }

  get status(): LiveStatus {
    return { state: this.#state, every: this.#sampler.every, frameRate: this.#clock.rate };
  }

  get report() {
    return this.#meter.report();
  }

  get totals() {
    return this.#meter.totals;
  }

  get size() {
    return this.#size;
  }

  get recordingSince(): number | null {
    return this.#recording?.since ?? null;
  }

  get recordingUntil(): number | null {
    return this.#recording?.until ?? null;
  }

  change(settings: LiveSettings): void {
    const before = this.#settings;
    checkEstimator(settings.estimator);
    this.#sampler.choose(settings.every, settings.load);
    this.#settings = settings;
    // The old index counts multiples of the old N.
    this.#clock.restart();
    this.#delay.reset();
    const more = settings.mode === 'now' && before.mode !== 'now';
    if (settings.estimator !== before.estimator || more) void this.#prepare();
    this.#tell();
  }

  frame(video: HTMLVideoElement, frame: CameraFrame): void {
    if (this.#closed) return;
    const { time, told, missed } = frame;
    const gap = this.#clock.add(frame);
    if (gap === null) return;
    if (gap > MAX_GAP_SECONDS) this.#startAfresh();
    this.#meter.addFrame(told, missed, 1000 * (told - time));
    const { videoWidth: width, videoHeight: height } = video;
    // A camera that was turned, or replaced by another.
    if (this.#size?.width !== width || this.#size.height !== height) {
      this.#size = { width, height };
      this.#startAfresh();
    }
    const watched =
      this.#ready &&
      width > 0 &&
      this.#sampler.offer(this.#clock.index, this.#busy, this.#clock.period);
    this.#recording?.addFrame(time, watched, this.#size);
    if (watched) void this.#look(video, time);
    this.#watch.frame(told);
    this.#updateState(told);
  }

  view(now: number): LiveView {
    const { mode } = this.#settings;
    const interval = this.#sampler.every * this.#clock.period;
    const late =
      mode === 'now'
        ? this.#clock.lag
        : this.#delay.at(now, interval + this.#callSeconds + this.#clock.lag);
    const time = now - late;
    this.#shownTime = time;
    this.#updateState(now);
    const pose = this.#track.at(time);
    const frame = this.#clock.frameAt(time);
    if (pose && pose.presence > 0 && frame !== null) this.#count(frame, now);
    return { time, frame, watched: this.#looks.includes(frame ?? Number.NaN), pose };
  }

  startRecording(): void {
    this.#recording = new Recording();
  }

  async stopRecording(name: string): Promise<RecoveredClip | null> {
    const recording = this.#recording;
    await recording?.end();
    const found = recording?.finish(name) ?? null;
    this.#recording = null;
    if (!found) return null;
    const outcome = await this.host.life.whileAlive(
      this.host.remote.recoverStretch({
        ...found,
        every: this.#sampler.every,
        estimator: {
          name: this.#settings.estimator,
          flops: this.#meter.estimatorFlops,
        },
        files: this.host.files,
      }),
    );
    if (outcome.kind === 'done') return outcome.clip;
    throw outcome.kind === 'aborted' ? crash('it was stopped') : this.#failed(outcome);
  }

  /** Closes it, and tells why. */
  end(error: DeciWatchError): void {
    this.#fail(error);
  }

  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.#forgetDeath();
    this.onStatus = null;
    this.onError = null;
    this.#recording = null;
    this.#track.clear();
    void this.host.remote.stopLive();
    this.host.onClose();
  }

  /** Loads what the settings need; frames are not watched before it is there. */
  async #prepare(): Promise<void> {
    const preparation = ++this.#preparations;
    this.#ready = false;
    this.#setState('loading');
    const { estimator, mode } = this.#settings;
    const needs = { estimator, forecast: mode === 'now', files: this.host.files };
    try {
      const answer = await this.host.life.whileAlive(this.host.remote.prepareLive(needs));
      // Somebody may have chosen another one meanwhile, which is being loaded.
      const wanted = !this.#closed && preparation === this.#preparations;
      if (answer.kind === 'crashed' || (wanted && answer.kind === 'failed'))
        throw this.#failed(answer);
      if (!wanted || answer.kind !== 'ready') return;
      if (answer.estimatorFlops !== this.#meter.estimatorFlops) {
        this.#meter = new LiveMeter(answer.estimatorFlops);
      }
      this.#ready = true;
      this.#startAfresh();
      this.#setState('waiting');
    } catch (error) {
      this.#fail(error);
    }
  }

  async #look(video: HTMLVideoElement, time: number): Promise<void> {
    const image = pictureOf(video, time);
    if (!image) return;
    const { estimator, mode } = this.#settings;
    this.#busy = true;
    this.#looks = [...this.#looks.slice(-LOOKS_KEPT), time];
    const sent = performance.now();
    const frameTimes = this.#clock.takeFrames();
    const afresh = this.#afresh;
    this.#afresh = false;
    const ahead = mode === 'now' ? this.#ahead(time) : new Float64Array();
    const recording = this.#recording;
    try {
      const request = { estimator, time, frameTimes, ahead, afresh };
      const answer = await this.host.life.whileAlive(
        this.host.remote.watch(Comlink.transfer(image, [image]), request),
      );
      if (answer.kind !== 'watched') throw this.#failed(answer);
      if (this.#closed) return;
      const now = performance.now() / 1000;
      this.#callSeconds = now - sent / 1000;
      this.#sampler.answered(this.#callSeconds, this.#clock.period);
      recording?.addWatched(time, answer.estimate, answer.estimatorMs);
      this.#take(answer, time, now);
    } catch (error) {
      this.#fail(error);
    } finally {
      this.#busy = false;
    }
  }

  #take(answer: Extract<WatchAnswer, { kind: 'watched' }>, time: number, now: number): void {
    this.#meter.addWatched({ at: now, ...answer });
    this.#watch.answered(now, answer.estimate !== null);
    const { chunk } = answer;
    if (chunk) {
      const first = chunk.times[0]!;
      const usual = 1.3 * this.#sampler.every * this.#clock.period;
      // A stretch over a missing sample is late by nature.
      if (time - first <= Math.max(usual, 0.05)) this.#delay.arrived(first, now);
      this.#track.append(chunk, this.#shownTime);
    }
    this.#updateState(now);
  }

  /** Times to look ahead to from a watched frame: until the answer to the next one may be there. */
  #ahead(time: number): Float64Array {
    const period = this.#clock.period;
    const span = this.#sampler.every * period + 2 * this.#callSeconds + SPARE_S;
    const count = Math.ceil(Math.min(span, FURTHEST_S) / period);
    return Float64Array.from({ length: count + 1 }, (_, i) => time + i * period);
  }

  #startAfresh(): void {
    this.#afresh = true;
    this.#delay.reset();
  }

  #count(frame: number, now: number): void {
    if (frame <= this.#countedTime) return;
    this.#countedTime = frame;
    this.#meter.addShown(now, 1000 * (now - frame));
  }

  #updateState(now: number): void {
    if (this.#ready) this.#setState(this.#watch.at(now));
  }

  #setState(state: LiveState): void {
    if (state === this.#state && this.#every === this.#sampler.every) return;
    this.#state = state;
    this.#every = this.#sampler.every;
    this.#tell();
  }

  #tell(): void {
    this.onStatus?.();
  }

  /** What an answer stands for. After a crash the worker's state is unknown: nobody is to go on with it. */
  #failed(failure: Failure): DeciWatchError {
    const error = errorOf(failure);
    if (failure.kind === 'crashed') this.host.life.end(error);
    return error;
  }

  #fail(error: unknown): void {
    if (this.#closed) return;
    const told =
      error instanceof DeciWatchError
        ? error
        : crash(error instanceof Error ? error.message : String(error));
    const listener = this.onError;
    this.close();
    listener?.(told);
  }
}

/** Null where the element has lost its picture meanwhile, as when another camera is chosen. */
function pictureOf(video: HTMLVideoElement, time: number): VideoFrame | null {
  try {
    return new VideoFrame(video, { timestamp: Math.round(time * 1e6) });
  } catch {
    return null;
  }
}
