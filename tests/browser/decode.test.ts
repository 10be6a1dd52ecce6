import {
  BlobSource,
  BufferTarget,
  Conversion,
  Input,
  MP4,
  MpegTsOutputFormat,
  Output,
} from 'mediabunny';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import type { DeciWatchErrorCode } from '../../web/errors.ts';
import type { Clip, ClipFrame } from '../../web/sources/clip.ts';
import { openFile } from '../../web/sources/file.ts';
import { type ClipName, fixture, known } from './fixtures.ts';
import { OpenFrames } from './open-frames.ts';

const BITS = 8;
const TS_PACKET = 188;

/** The number that a frame carries: one column (one row, once turned) for each bit, white is 1. */
function barcode({ image }: ClipFrame): number {
  const { width, height } = image as OffscreenCanvas;
  const context = (image as OffscreenCanvas).getContext('2d')!;
  let number = 0;
  for (let bit = 0; bit < BITS; bit++) {
    const along = (bit + 0.5) / BITS;
    const [x, y] = width > height ? [along * width, height / 2] : [width / 2, along * height];
    number = 2 * number + (context.getImageData(x, y, 1, 1).data[0]! > 127 ? 1 : 0);
  }
  return number;
}

async function open(name: ClipName): Promise<Clip> {
  return openFile(await fixture(name), name);
}

async function read(clip: Clip, indices: number[]) {
  const frames: { index: number; time: number; number: number }[] = [];
  for await (const frame of clip.frames(indices)) {
    frames.push({ index: frame.index, time: frame.time, number: barcode(frame) });
  }
  return frames;
}

let openFrames: OpenFrames;
beforeEach(() => {
  openFrames = new OpenFrames();
});
afterEach(() => openFrames.restore());

describe.each<ClipName>(['barcode.mp4', 'barcode.webm', 'vfr.mp4', 'rotated.mp4'])('%s', (name) => {
  test.each([1, 10])('every frame in %i is the right one, at its own time', async (every) => {
    const { times } = known(name);
    const clip = await open(name);
    expect(clip.times.length).toBe(times.length);
    for (const [k, time] of times.entries()) expect(clip.times[k]).toBeCloseTo(time, 6);

    const indices = times.map((_, k) => k).filter((k) => k % every === 0);
    const frames = await read(clip, indices);
    clip.close();
    expect(frames.map((frame) => frame.number)).toEqual(indices);
    expect(frames.map((frame) => frame.index)).toEqual(indices);
    expect(frames.map((frame) => frame.time)).toEqual(indices.map((k) => clip.times[k]));
    expect(openFrames.seen).toBeGreaterThanOrEqual(indices.length);
    expect(openFrames.count).toBe(0);
  });
});

test('a clip is described as it is displayed: turned, its rate from its own times', async () => {
  const rotated = await open('rotated.mp4');
  expect(rotated.info).toMatchObject({ width: 96, height: 160, frameCount: 12 });
  expect(rotated.info.frameRate).toBeCloseTo(30, 3);
  expect(rotated.info.duration).toBeCloseTo(0.4, 3);
  rotated.close();
});

test('leaving in the middle closes every frame that was decoded ahead', async () => {
  const clip = await open('barcode.mp4');
  for await (const { index } of clip.frames([...clip.times.keys()])) if (index === 5) break;
  clip.close();
  await expect.poll(() => openFrames.count).toBe(0);
  expect(openFrames.seen).toBeGreaterThan(5);
});

test.each<[ClipName, DeciWatchErrorCode, RegExp]>([
  ['corrupt.mp4', 'file-unreadable', /cannot be read as a video/],
  ['audio-only.mp4', 'no-video-track', /no video track/],
  ['truncated.mp4', 'file-truncated', /stop at second 0\.7, although it lists 60 frames/],
])('%s is refused as %s', async (name, code, sentence) => {
  const refusal = open(name);
  await expect(refusal).rejects.toMatchObject({ name: 'DeciWatchError', code });
  await expect(refusal).rejects.toThrow(sentence);
});

test('an empty file, and one that is no video, are refused as unreadable', async () => {
  for (const bytes of [[], ['%PDF-1.7 and so on'.repeat(100)]]) {
    await expect(openFile(new Blob(bytes), 'a.mp4')).rejects.toMatchObject({
      code: 'file-unreadable',
    });
  }
});

test('a codec that the browser lacks is named', async () => {
  // The same file, said to be encoded as something that does not exist.
  const bytes = new Uint8Array(await (await fixture('barcode.webm')).arrayBuffer());
  const at = new TextDecoder('latin1').decode(bytes).indexOf('V_VP9');
  bytes.set(new TextEncoder().encode('V_XYZ'), at);
  const refusal = openFile(new Blob([bytes]), 'odd.webm');
  await expect(refusal).rejects.toMatchObject({ code: 'codec-unsupported' });
  await expect(refusal).rejects.toThrow(/H\.264/);
});

test('damaged pictures are told of, and leave nothing open', async () => {
  const bytes = new Uint8Array(await (await fixture('barcode.mp4')).arrayBuffer());
  const at = new TextDecoder('latin1').decode(bytes).indexOf('mdat') + 8;
  bytes.fill(0xff, at, at + 3000);
  const clip = await openFile(new Blob([bytes]), 'damaged.mp4');
  await expect(read(clip, [...clip.times.keys()])).rejects.toMatchObject({
    code: 'file-unreadable',
  });
  clip.close();
  await expect.poll(() => openFrames.count).toBe(0);
});

/** The same pictures as an MPEG transport stream, whose parts can be cut off anywhere. */
async function transportStream(name: ClipName): Promise<Uint8Array<ArrayBuffer>> {
  const input = new Input({ source: new BlobSource(await fixture(name)), formats: [MP4] });
  const output = new Output({ format: new MpegTsOutputFormat(), target: new BufferTarget() });
  await (await Conversion.init({ input, output })).execute();
  return new Uint8Array(output.target.buffer!);
}

test('a recording that begins between two key frames is played from the first one on', async () => {
  const bytes = await transportStream('barcode.mp4');
  // Its tables stay; some of its first pictures go.
  const cut = new Blob([bytes.slice(0, 2 * TS_PACKET), bytes.slice(22 * TS_PACKET)]);
  const clip = await openFile(cut, 'cut.ts');
  const { times } = known('barcode.mp4');
  expect(clip.times.length).toBeGreaterThan(10);
  expect(clip.times.length).toBeLessThan(times.length);
  const frames = await read(clip, [...clip.times.keys()]);
  clip.close();
  const first = times.length - clip.times.length;
  expect(frames.map(({ number }) => number)).toEqual([...clip.times.keys()].map((k) => k + first));
});

test('reading a file can be ended', async () => {
  const bytes = await transportStream('barcode.mp4');
  const signal = AbortSignal.abort(new DOMException('enough', 'AbortError'));
  await expect(openFile(new Blob([bytes]), 'long.ts', signal)).rejects.toMatchObject({
    name: 'AbortError',
  });
});
