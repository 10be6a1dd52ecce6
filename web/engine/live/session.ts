import type { Remote } from 'comlink';
import * as Comlink from 'comlink';
import { LiveMeter } from '../../cost/live-meter.ts';
import { DeciWatchError } from '../../errors.ts';
import { FramePeriod } from '../../sampling/frame-period.ts';
import { LiveSampler } from '../../sampling/live-sampler.ts';
import { MAX_GAP_SECONDS } from '../../sampling/segments.ts';
import type { CameraFrame } from '../../sources/camera-frames.ts';
import type { EngineWorker } from '../messages.ts';
import type { ModelUrls } from '../models.ts';
import type { RecoveredClip } from '../types.ts';
import { SmoothDelay } from './delay.ts';
import type { Failure, WatchAnswer } from './messages.ts';
import { Recording } from './recording.ts';
import { LiveTrack } from './track.ts';
import type { LiveSession, LiveSettings, LiveState, LiveStatus, LiveView } from './types.ts';

/** Frames are taken not to come any more after so many seconds. */
const SILENT_S = 1;

/** Somebody who is not seen any more is called lost for so long, then looked for. */
const LOST_S = 3;

/** Looks ahead so much further than the next answer is due. */
const SPARE_S = 0.15;
const FURTHEST_S = 1;

/** Camera frames that are remembered, in seconds: longer than any delay. */
const REMEMBERED_S = 4;

/** How much the newest frame counts in the mean delay of the camera. */
const NEWEST = 0.1;

/** What the session needs of the engine that it runs on. */
export interface LiveHost {
  readonly remote: Remote<EngineWorker>;
  /** Rejects when the worker dies. */
  readonly death: Promise<never>;
  readonly urls: ModelUrls;
  /** The session has ended. */
  onClose(): void;
}

/** {@link LiveSession} on a worker: at most one frame is with it at any time. */
export class WorkerLiveSession implements LiveSession {
  onStatus: (() => void) | null = null;
  onError: ((error: DeciWatchError) => void) | null = null;
  #settings: LiveSettings;
  #sampler: LiveSampler;
  #meter = new LiveMeter(1);
  #ready = false;
  #closed = false;
  #busy = false;
  #afresh = true;
  #index = -1;
  #size: { readonly width: number; readonly height: number } | null = null;
  readonly #period = new FramePeriod();
  readonly #track = new LiveTrack();
  readonly #delay = new SmoothDelay();
  #cameraLag = 0;
  #callSeconds = 0.1;
  #shownTime = 0;
  /** Capture times of the last camera frames; those since the last look. */
  #frames: number[] = [];
  #sinceLook: number[] = [];
  #countedTime = Number.NEGATIVE_INFINITY;
  #lastSeen: number | null = null;
  #lastAnswerSeen = false;
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
    host.death.catch((error) => this.#fail(error));
    void this.#prepare();
  }

  get settings(): LiveSettings {
    return this.#settings;
  }

  get status(): LiveStatus {
    const frameRate = this.#frames.length > 1 ? 1 / this.#period.seconds : 0;
    return { state: this.#state, every: this.#sampler.every, frameRate };
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

  change(settings: LiveSettings): void {
    const before = this.#settings;
    this.#sampler.choose(settings.every, settings.load);
    this.#settings = settings;
    // The old index counts multiples of the old N.
    this.#index = -1;
    this.#delay.reset();
    const more = settings.mode === 'now' && before.mode !== 'now';
    if (settings.estimator !== before.estimator || more) void this.#prepare();
    this.#tell();
  }

  frame(video: HTMLVideoElement, { time, told, missed }: CameraFrame): void {
    if (this.#closed) return;
    const last = this.#frames.at(-1);
    if (last !== undefined && time <= last) return;
    if (last !== undefined && time - last > MAX_GAP_SECONDS) this.#startAfresh();
    this.#frames = this.#frames.filter((past) => past > time - REMEMBERED_S);
    this.#frames.push(time);
    this.#sinceLook.push(time);
    this.#period.add(time, 1 + missed);
    this.#cameraLag += NEWEST * (told - time - this.#cameraLag);
    this.#index += 1 + (this.#index < 0 ? 0 : missed);
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
      this.#sampler.offer(this.#index, this.#busy, this.#period.seconds);
    this.#recording?.addFrame(time, watched);
    if (watched) void this.#look(video, time);
    this.#updateState(told);
  }

  view(now: number): LiveView {
    const { mode } = this.#settings;
    const interval = this.#sampler.every * this.#period.seconds;
    const late =
      mode === 'now'
        ? this.#cameraLag
        : this.#delay.at(now, interval + this.#callSeconds + this.#cameraLag);
    const time = now - late;
    this.#shownTime = time;
    this.#updateState(now);
    const pose = this.#track.at(time);
    const frame = this.#frames.findLast((captured) => captured <= time) ?? null;
    if (pose && pose.presence > 0 && frame !== null) this.#count(frame, now);
    return { time, frame, pose };
  }

  startRecording(): void {
    this.#recording = new Recording();
  }

  async stopRecording(name: string): Promise<RecoveredClip | null> {
    const { width, height } = this.#size ?? { width: 0, height: 0 };
    const found = this.#recording?.finish(name, width, height) ?? null;
    this.#recording = null;
    if (!found) return null;
    const outcome = await Promise.race([
      this.host.remote.recoverStretch({
        ...found,
        every: this.#sampler.every,
        estimator: {
          name: this.#settings.estimator,
          flops: this.#meter.estimatorFlops,
        },
        urls: this.host.urls,
      }),
      this.host.death,
    ]);
    if (outcome.kind === 'done') return outcome.clip;
    throw errorOf(outcome);
  }

  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.onStatus = null;
    this.onError = null;
    this.#recording = null;
    this.#track.clear();
    void this.host.remote.stopLive();
    this.host.onClose();
  }

  /** Loads what the settings need; frames are not watched before it is there. */
  async #prepare(): Promise<void> {
    this.#ready = false;
    this.#setState('loading');
    const { estimator, mode } = this.#settings;
    const needs = { estimator, forecast: mode === 'now', urls: this.host.urls };
    try {
      const answer = await Promise.race([this.host.remote.prepareLive(needs), this.host.death]);
      if (this.#closed) return;
      if (answer.kind !== 'ready') throw errorOf(answer);
      // Somebody may have chosen another one meanwhile, which is being loaded.
      if (estimator !== this.#settings.estimator) return;
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
    const { estimator, mode } = this.#settings;
    this.#busy = true;
    const sent = performance.now();
    const frameTimes = Float64Array.from(this.#sinceLook);
    this.#sinceLook = [];
    const afresh = this.#afresh;
    this.#afresh = false;
    const ahead = mode === 'now' ? this.#ahead(time) : new Float64Array();
    const recording = this.#recording;
    try {
      const image = new VideoFrame(video, { timestamp: Math.round(time * 1e6) });
      const request = { estimator, time, frameTimes, ahead, afresh };
      const answer = await Promise.race([
        this.host.remote.watch(Comlink.transfer(image, [image]), request),
        this.host.death,
      ]);
      if (this.#closed) return;
      if (answer.kind !== 'watched') throw errorOf(answer);
      const now = performance.now() / 1000;
      this.#callSeconds = now - sent / 1000;
      this.#sampler.answered(this.#callSeconds, this.#period.seconds);
      recording?.addWatched(time, answer.estimate, answer.estimatorMs);
      this.#take(answer, time, now);
    } catch (error) {
      this.#fail(error);
    } finally {
      this.#busy = false;
    }
  }

  #take(answer: Extract<WatchAnswer, { kind: 'watched' }>, time: number, now: number): void {
    const { mode } = this.#settings;
    this.#meter.addWatched({ at: now, ...answer });
    this.#lastAnswerSeen = answer.estimate !== null;
    if (answer.estimate) this.#lastSeen = time;
    const chunk = mode === 'now' ? answer.forecast : answer.recovered;
    if (answer.recovered) {
      const first = answer.recovered.times[0]!;
      const usual = 1.3 * this.#sampler.every * this.#period.seconds;
      // A stretch over a missing sample is late by nature.
      if (time - first <= Math.max(usual, 0.05)) this.#delay.arrived(first, now);
    }
    if (chunk) this.#track.append(chunk, this.#shownTime);
    this.#updateState(now);
  }

  /** Times to look ahead to from a watched frame: until the answer to the next one may be there. */
  #ahead(time: number): Float64Array {
    const period = this.#period.seconds;
    const span = this.#sampler.every * period + 2 * this.#callSeconds + SPARE_S;
    const count = Math.ceil(Math.min(span, FURTHEST_S) / period);
    return Float64Array.from({ length: count + 1 }, (_, i) => time + i * period);
  }

  #startAfresh(): void {
    this.#afresh = true;
    this.#sinceLook = [];
    this.#delay.reset();
  }

  #count(frame: number, now: number): void {
    if (frame <= this.#countedTime) return;
    this.#countedTime = frame;
    this.#meter.addShown(now, 1000 * (now - frame));
  }

  #updateState(now: number): void {
    if (!this.#ready) return;
    const last = this.#frames.at(-1);
    if (last === undefined || now - last > SILENT_S) this.#setState('waiting');
    else if (this.#lastAnswerSeen) this.#setState('following');
    else if (this.#lastSeen !== null && now - this.#lastSeen < LOST_S) this.#setState('lost');
    else this.#setState('looking');
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

  #fail(error: unknown): void {
    if (this.#closed) return;
    const told =
      error instanceof DeciWatchError
        ? error
        : new DeciWatchError(
            'engine-crashed',
            `Live playback stopped (${error instanceof Error ? error.message : String(error)}): start the camera again.`,
          );
    const listener = this.onError;
    this.close();
    listener?.(told);
  }
}

function errorOf(failure: Failure | { readonly kind: 'aborted' }): DeciWatchError {
  if (failure.kind === 'failed') return new DeciWatchError(failure.code, failure.message);
  const detail = failure.kind === 'crashed' ? failure.message : 'it was stopped';
  return new DeciWatchError(
    'engine-crashed',
    `The engine stopped working (${detail}): start the camera again, and reload the page if it happens twice.`,
  );
}
