import type { VideoSampleSource } from 'mediabunny';
import { finishVideo, openVideoOutput, type VideoOutput } from './video-output.ts';

/** Encodings in the order of preference; all play in every current browser's <video>. */
const CODECS = ['avc', 'vp9', 'vp8'] as const;

/** Pictures that may wait for the encoder; more are left out rather than queued. */
const MOST_WAITING = 4;

const BITS_PER_PIXEL = 3;

/** Encodes a recording's pictures with their own times, frame by frame. */
export class PictureRecorder {
  #waiting = 0;
  #first: number | null = null;
  #last = -1;

  private constructor(
    private readonly video: VideoOutput,
    private readonly source: VideoSampleSource,
  ) {}

  /**
   * @param width and height, pixels of the pictures
   * @throws DeciWatchError `browser-unsupported`
   */
  static async start(width: number, height: number): Promise<PictureRecorder> {
    const video = await openVideoOutput(CODECS, width, height);
    const { bunny, output, codec } = video;
    const bitrate = Math.max(100_000, width * height * BITS_PER_PIXEL);
    const source = new bunny.VideoSampleSource({ codec, bitrate, keyFrameInterval: 1 });
    output.addVideoTrack(source);
    await output.start();
    return new PictureRecorder(video, source);
  }

  get mimeType(): string {
    return this.video.mimeType;
  }

  /**
   * A picture; one too many for the encoder is left out.
   * @param time seconds, increasing; the first one's is the recording's zero
   */
  add(image: HTMLVideoElement | HTMLCanvasElement, time: number): void {
    this.#first ??= time;
    const timestamp = time - this.#first;
    if (this.#waiting >= MOST_WAITING || timestamp <= this.#last) return;
    this.#last = timestamp;
    const frame = new VideoFrame(image, { timestamp: Math.round(timestamp * 1e6) });
    void this.#encode(frame);
  }

  /** The whole video. Rejects where the encoder gave up. */
  finish(): Promise<Blob> {
    return finishVideo(this.video);
  }

  async cancel(): Promise<void> {
    await this.video.output.cancel();
  }

  async #encode(frame: VideoFrame): Promise<void> {
    const sample = new this.video.bunny.VideoSample(frame);
    this.#waiting++;
    try {
      await this.source.add(sample);
    } catch {
      // The encoder gave up, which the end will tell.
    } finally {
      sample.close();
      this.#waiting--;
    }
  }
}
