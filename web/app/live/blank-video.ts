import { finishVideo, openVideoOutput } from './video-output.ts';

/** Pixels of the longer side of a video that shows nothing. */
const BLANK_SIDE = 64;

/**
 * A video of black pictures at these times: a recording without its picture can be played and scrubbed
 * like any other.
 * @param times seconds, from 0, increasing
 * @param aspect width by height
 * @throws DeciWatchError `browser-unsupported`
 */
export async function blankVideo(times: Float64Array, aspect: number): Promise<Blob> {
  const even = (length: number) => Math.max(2, 2 * Math.round(length / 2));
  const width = even(aspect >= 1 ? BLANK_SIDE : BLANK_SIDE * aspect);
  const height = even(aspect >= 1 ? BLANK_SIDE / aspect : BLANK_SIDE);
  const video = await openVideoOutput(['vp8', 'vp9', 'avc'], width, height);
  const { bunny, output, codec } = video;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  canvas.getContext('2d', { alpha: false });
  const source = new bunny.CanvasSource(canvas, { codec, bitrate: 20_000, keyFrameInterval: 1 });
  output.addVideoTrack(source);
  await output.start();
  for (const [i, time] of times.entries()) {
    await source.add(time, (times[i + 1] ?? time + 1 / 30) - time);
  }
  return finishVideo(video);
}
