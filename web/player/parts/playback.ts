import { FrameClock } from './frame-clock.ts';

/** What a page needs to know of a playing clip. */
export interface PlaybackState {
  /** The frame on screen, from 0. */
  readonly frame: number;
  readonly playing: boolean;
}

/** The element's own time of its first frame, for the file in it: known only while that is on screen. */
const firstMediaTimes = new WeakMap<
  HTMLVideoElement,
  { readonly src: string; readonly time: number }
>();

/**
 * Plays a clip in a `<video>` and tells which of its frames is on screen. It listens to the element and
 * does not own it; {@link dispose} lets go of it.
 */
export class Playback {
  readonly #video: HTMLVideoElement;
  readonly #onChange: (state: PlaybackState) => void;
  #clock: FrameClock | null = null;
  #times: Float64Array | null = null;
  #frame = 0;
  /** The frame asked for last; null while playing, or before any was asked for. */
  #wanted: number | null = null;
  /** The frame that the newest seek leads to. */
  #target: number | null = null;
  #callback = 0;

  constructor(video: HTMLVideoElement, onChange: (state: PlaybackState) => void) {
    this.#video = video;
    this.#onChange = onChange;
    video.addEventListener('play', this.#started);
    video.addEventListener('pause', this.#tell);
    video.addEventListener('seeked', this.#seeked);
    video.addEventListener('loadstart', this.#reset);
    this.#watch();
  }

  /** The frame times of the clip in the element, once they are known: T seconds. */
  setTimes(times: Float64Array | null): void {
    this.#times = times;
    this.#clock = times && times.length > 0 ? new FrameClock(times, this.#firstMediaTime) : null;
    if (this.#clock) this.#show(this.#clock.frameAt(this.#video.currentTime));
  }

  get playing(): boolean {
    return !this.#video.paused && !this.#video.ended;
  }

  /** The frame asked for last, even if it is not on screen yet. */
  get wantedFrame(): number {
    return this.#wanted ?? this.#frame;
  }

  async play(): Promise<void> {
    try {
      await this.#video.play();
    } catch {
      // Refused (power saving) or overtaken by a pause: the play button still shows the truth.
    }
  }

  pause(): void {
    this.#video.pause();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else void this.play();
  }

  /** Shows one frame; out of range, the nearest that there is. */
  seek(frame: number): void {
    if (!this.#clock) return;
    const wanted = Math.min(Math.max(frame, 0), this.#clock.frameCount - 1);
    this.#wanted = wanted;
    if (this.#video.readyState < HTMLMediaElement.HAVE_METADATA) {
      // The browser cannot play this file: the poses can still be stepped through.
      this.#show(wanted);
    } else if (!this.#video.seeking) {
      // Otherwise the running seek comes first; only the newest of those that wait for it counts.
      this.#target = wanted;
      this.#video.currentTime = this.#clock.seekTarget(wanted);
    }
  }

  /** Pauses, and goes some frames on or back. */
  step(frames: number): void {
    this.pause();
    this.seek(this.wantedFrame + frames);
  }

  dispose(): void {
    this.#video.removeEventListener('play', this.#started);
    this.#video.removeEventListener('pause', this.#tell);
    this.#video.removeEventListener('seeked', this.#seeked);
    this.#video.removeEventListener('loadstart', this.#reset);
    if ('cancelVideoFrameCallback' in this.#video)
      this.#video.cancelVideoFrameCallback(this.#callback);
    else cancelAnimationFrame(this.#callback);
  }

  /** Seconds. Of the element: it may have been played by another playback before. */
  get #firstMediaTime(): number | null {
    const known = firstMediaTimes.get(this.#video);
    return known?.src === this.#video.src ? known.time : null;
  }

  #show(frame: number): void {
    this.#frame = frame;
    this.#tell();
  }

  #watch(): void {
    if ('requestVideoFrameCallback' in this.#video) {
      this.#callback = this.#video.requestVideoFrameCallback((_, { mediaTime }) => {
        this.#watch();
        this.#presented(mediaTime);
      });
    } else {
      this.#callback = requestAnimationFrame(() => {
        this.#watch();
        if (!this.#clock || !this.playing) return;
        const frame = this.#clock.frameAt(this.#video.currentTime);
        if (frame !== this.#frame) this.#show(frame);
      });
    }
  }

  #presented(mediaTime: number): void {
    if (this.#firstMediaTime === null && this.#video.currentTime === 0) {
      firstMediaTimes.set(this.#video, { src: this.#video.src, time: mediaTime });
      if (this.#times) this.setTimes(this.#times);
    }
    if (this.#clock) this.#show(this.#clock.frameAt(mediaTime));
  }

  readonly #seeked = () => {
    if (this.#wanted !== null && this.#wanted !== this.#target) {
      this.seek(this.#wanted);
      return;
    }
    // It is there, and plays on from there.
    if (this.playing) this.#wanted = null;
    if (this.#clock) this.#show(this.#clock.frameAt(this.#video.currentTime));
  };

  readonly #reset = () => {
    firstMediaTimes.delete(this.#video);
    this.#wanted = null;
    this.#target = null;
    this.#frame = 0;
  };

  readonly #started = () => {
    this.#wanted = null;
    this.#tell();
  };

  readonly #tell = () => this.#onChange({ frame: this.#frame, playing: this.playing });
}
