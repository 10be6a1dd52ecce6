import type { BufferTarget, Output, VideoCodec } from 'mediabunny';
import { DeciWatchError } from '../../errors.ts';

/** A video that is being written to memory. */
export interface VideoOutput {
  /** mediabunny, which is loaded for this alone. */
  readonly bunny: typeof import('mediabunny');
  readonly output: Output;
  readonly target: BufferTarget;
  readonly codec: VideoCodec;
  readonly mimeType: string;
}

/**
 * A video of the first of these codecs that the browser can encode at a size, in the container that goes
 * with it. Tracks are the caller's to add.
 * @throws DeciWatchError `browser-unsupported`
 */
export async function openVideoOutput(
  codecs: readonly VideoCodec[],
  width: number,
  height: number,
): Promise<VideoOutput> {
  const bunny = await import('mediabunny');
  const codec = await bunny.getFirstEncodableVideoCodec([...codecs], { width, height });
  if (!codec) {
    throw new DeciWatchError(
      'browser-unsupported',
      'This browser cannot encode video, so that nothing can be recorded: use another browser.',
    );
  }
  const target = new bunny.BufferTarget();
  const format = codec === 'avc' ? new bunny.Mp4OutputFormat() : new bunny.WebMOutputFormat();
  const output = new bunny.Output({ format, target });
  return { bunny, output, target, codec, mimeType: format.mimeType };
}

/** Closes the video. */
export async function finishVideo({ output, target, mimeType }: VideoOutput): Promise<Blob> {
  await output.finalize();
  return new Blob([target.buffer!], { type: mimeType });
}
