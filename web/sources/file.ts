import {
  BlobSource,
  EncodedPacketSink,
  Input,
  type InputVideoTrack,
  MATROSKA,
  MP4,
  MPEG_TS,
  QTFF,
  VideoSampleSink,
  WEBM,
} from 'mediabunny';
import { DeciWatchError } from '../errors.ts';
import type { Clip, ClipFrame, ClipInfo } from './clip.ts';
import { truncation } from './truncation.ts';

/** Those that hold pictures; each adds its reader's code to the worker. */
const FORMATS = [MP4, QTFF, WEBM, MATROSKA, MPEG_TS];

/** Decoders and mediabunny round timestamps to microseconds; no two frames are this close. */
const SAME_TIME_S = 1e-4;

/**
 * Opens a video file: reads which frames it has and when each is shown, decodes nothing yet.
 * @param signal ends the reading: some formats have no index, and are read to their end
 * @throws DeciWatchError `file-unreadable`, `file-truncated`, `no-video-track` or `codec-unsupported`; the signal's reason
 */
export async function openFile(file: Blob, name: string, signal?: AbortSignal): Promise<Clip> {
  const input = new Input({ source: new BlobSource(file), formats: FORMATS });
  try {
    if (!(await input.canRead())) throw notAVideo(name);
    const track = await videoTrack(input, name);
    const { times, end } = await frameTimes(track, signal);
    const first = times[0];
    if (first === undefined) {
      throw new DeciWatchError(
        'no-video-track',
        `${name} has a video track, but not a single frame in it: choose another file.`,
      );
    }
    const cutOff = await truncation(track, times, name);
    if (cutOff) throw cutOff;
    const duration = end - first;
    const info: ClipInfo = {
      name,
      width: await track.getDisplayWidth(),
      height: await track.getDisplayHeight(),
      frameCount: times.length,
      frameRate: duration > 0 ? times.length / duration : 0,
      duration,
    };
    return new FileClip(info, times, track, input);
  } catch (error) {
    input.dispose();
    signal?.throwIfAborted();
    if (error instanceof DeciWatchError) throw error;
    throw notAVideo(name, error);
  }
}

function notAVideo(name: string, cause?: unknown): DeciWatchError {
  return new DeciWatchError(
    'file-unreadable',
    `${name} cannot be read as a video: choose an MP4, MOV, WebM or MKV file that other players open.`,
    { cause },
  );
}

async function videoTrack(input: Input, name: string): Promise<InputVideoTrack> {
  // An MP4 that lost its end has lost its index with it, and seems to hold nothing at all.
  if ((await input.getTracks()).length === 0) throw notAVideo(name);
  const track = await input.getPrimaryVideoTrack();
  if (!track) {
    throw new DeciWatchError(
      'no-video-track',
      `${name} holds no video track: choose a file with a picture.`,
    );
  }
  if (!(await track.canDecode())) {
    const codec = (await track.getCodecParameterString()) ?? (await track.getCodec());
    throw new DeciWatchError(
      'codec-unsupported',
      `This browser cannot decode the video of ${name} (codec ${codec ?? 'unknown'}): ` +
        're-encode it as H.264, or open it in another browser.',
    );
  }
  return track;
}

/** When each frame is shown, from the packets' metadata alone, and when the last one's time ends. */
async function frameTimes(
  track: InputVideoTrack,
  signal?: AbortSignal,
): Promise<{ times: Float64Array; end: number }> {
  const starts: number[] = [];
  let end = Number.NEGATIVE_INFINITY;
  let firstKey = Number.POSITIVE_INFINITY;
  const packets = new EncodedPacketSink(track).packets(undefined, undefined, {
    metadataOnly: true,
  });
  for await (const { timestamp, duration, type } of packets) {
    signal?.throwIfAborted();
    if (type === 'key') firstKey = Math.min(firstKey, timestamp);
    // What an edit list cuts off at the start lies before time zero, and is never shown.
    if (timestamp < 0 && timestamp + duration <= 0) continue;
    starts.push(timestamp);
    end = Math.max(end, timestamp + duration);
  }
  // Packets come in the order of decoding, which B-frames make another one.
  starts.sort((a, b) => a - b);
  // A recording that begins within a group of pictures: what comes before its first key frame cannot be decoded.
  const isFrame = (t: number, i: number) => t !== starts[i - 1] && t >= firstKey;
  return { times: Float64Array.from(starts.filter(isFrame)), end };
}

class FileClip implements Clip {
  constructor(
    readonly info: ClipInfo,
    readonly times: Float64Array,
    private readonly track: InputVideoTrack,
    private readonly input: Input,
  ) {}

  async *frames(indices: Iterable<number>): AsyncGenerator<ClipFrame, void, undefined> {
    const wanted = Array.from(indices);
    const { width, height } = this.info;
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d', { alpha: false });
    if (!context) {
      throw new DeciWatchError(
        'browser-unsupported',
        `This browser gave no canvas of ${width} × ${height} pixels: close other pages, or use a smaller video.`,
      );
    }
    let position = 0;
    try {
      const samples = new VideoSampleSink(this.track).samplesAtTimestamps(
        wanted.map((index) => this.times[index]!),
      );
      for await (const sample of samples) {
        const index = wanted[position++]!;
        const time = this.times[index]!;
        if (!sample) throw new Error('No sample');
        // A packet may hold no picture of its own (VP8's hidden frames): it is passed over.
        const isShown = Math.abs(sample.timestamp - time) < SAME_TIME_S;
        if (isShown) {
          // Some videos are transparent.
          context.clearRect(0, 0, width, height);
          sample.draw(context, 0, 0, width, height);
        }
        // Closed at once: the decoder stalls when frames are kept from it.
        sample.close();
        if (isShown) yield { index, time, image: canvas };
      }
    } catch (error) {
      if (error instanceof DeciWatchError || this.input.disposed) throw error;
      throw await this.damage(wanted[position - 1] ?? 0, error);
    }
  }

  /** What to tell when decoding fails after the frame `last`. */
  private async damage(last: number, cause: unknown): Promise<DeciWatchError> {
    const { name } = this.info;
    const second = (this.times[last]! - this.times[0]!).toFixed(1);
    return (
      (await truncation(this.track, this.times, name)) ??
      new DeciWatchError(
        'file-unreadable',
        `${name} is damaged: it cannot be decoded after second ${second}; copy or export it again.`,
        { cause },
      )
    );
  }

  close(): void {
    this.input.dispose();
  }
}
