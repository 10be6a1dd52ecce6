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

/** Pixels of the longer side of a video that shows nothing. */
const BLANK_SIDE = 64;

/**
 * A video of black pictures at these times: a recording without its picture can be played and scrubbed
 * like any other.
 * @param times seconds, from 0, increasing
 * @param aspect width by height
 */
export async function blankVideo(times: Float64Array, aspect: number): Promise<Blob> {
  const even = (length: number) => Math.max(2, 2 * Math.round(length / 2));
  const width = even(aspect >= 1 ? BLANK_SIDE : BLANK_SIDE * aspect);
  const height = even(aspect >= 1 ? BLANK_SIDE / aspect : BLANK_SIDE);
  const bunny = await import('mediabunny');
  const codec = await bunny.getFirstEncodableVideoCodec(['vp8', 'vp9', 'avc'], { width, height });
  if (!codec) {
    throw new DeciWatchError(
      'browser-unsupported',
      'This browser cannot encode video, so that a recording cannot be played here: use another browser.',
    );
  }
  const target = new bunny.BufferTarget();
  const format = codec === 'avc' ? new bunny.Mp4OutputFormat() : new bunny.WebMOutputFormat();
  const output = new bunny.Output({ format, target });
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  canvas.getContext('2d', { alpha: false });
  const source = new bunny.CanvasSource(canvas, { codec, bitrate: 20_000, keyFrameInterval: 1 });
  output.addVideoTrack(source);
  await output.start();
  for (const [i, time] of times.entries()) {
    await source.add(time, (times[i + 1] ?? time + 1 / 30) - time);
  }
  await output.finalize();
  return new Blob([target.buffer!], { type: format.mimeType });
}
