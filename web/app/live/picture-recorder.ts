import { DeciWatchError } from '../../errors.ts';

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
    private readonly bunny: typeof import('mediabunny'),
    private readonly output: import('mediabunny').Output,
    private readonly source: import('mediabunny').VideoSampleSource,
    private readonly target: import('mediabunny').BufferTarget,
    readonly mimeType: string,
  ) {}

  /**
   * @param width and height, pixels of the pictures
   * @throws DeciWatchError `browser-unsupported`
   */
  static async start(width: number, height: number): Promise<PictureRecorder> {
    const bunny = await import('mediabunny');
    const codec = await bunny.getFirstEncodableVideoCodec([...CODECS], { width, height });
    if (!codec) {
      throw new DeciWatchError(
        'browser-unsupported',
        'This browser cannot encode video: record without the picture, or use another browser.',
      );
    }
    const target = new bunny.BufferTarget();
    const format = codec === 'avc' ? new bunny.Mp4OutputFormat() : new bunny.WebMOutputFormat();
    const output = new bunny.Output({ format, target });
    const bitrate = Math.max(100_000, width * height * BITS_PER_PIXEL);
    const source = new bunny.VideoSampleSource({ codec, bitrate, keyFrameInterval: 1 });
    output.addVideoTrack(source);
    await output.start();
    return new PictureRecorder(bunny, output, source, target, format.mimeType);
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

  /** The whole video. */
  async finish(): Promise<Blob> {
    await this.output.finalize();
    return new Blob([this.target.buffer!], { type: this.mimeType });
  }

  async cancel(): Promise<void> {
    await this.output.cancel();
  }

  async #encode(frame: VideoFrame): Promise<void> {
    const sample = new this.bunny.VideoSample(frame);
    this.#waiting++;
    try {
      await this.source.add(sample);
    } catch {
      // The encoder gave up: what it has so far is the video, and the poses are whole.
    } finally {
      sample.close();
      this.#waiting--;
    }
  }
}
