import { describe, expect, test, vi } from 'vitest';
import type { DeciWatchPlayer, PlayerErrorDetail } from '../../web/player/types.ts';
import { fixture } from './fixtures.ts';
import { mount, SECONDS, shownText, WALK, workers } from './mounted-player.ts';

describe('an error', () => {
  const odd = async () => {
    // The same file, said to be encoded as something that does not exist.
    const bytes = new Uint8Array(await (await fixture('barcode.webm')).arrayBuffer());
    const at = new TextDecoder('latin1').decode(bytes).indexOf('V_VP9');
    bytes.set(new TextEncoder().encode('V_XYZ'), at);
    return URL.createObjectURL(new Blob([bytes]));
  };

  test.each<[string, Record<string, string>, PlayerErrorDetail['type']]>([
    ['a missing clip', { src: '/tests/fixtures/nowhere.mp4' }, 'file-missing'],
    ['another host that does not answer', { src: 'http://127.0.0.1:1/a.mp4' }, 'file-missing'],
    ['a codec that the browser lacks', { src: 'odd' }, 'codec-unsupported'],
    ['a file that was cut off', { src: '/tests/fixtures/truncated.mp4' }, 'file-truncated'],
    ['a damaged file', { src: '/tests/fixtures/corrupt.mp4' }, 'file-unreadable'],
    ['a file without a picture', { src: '/tests/fixtures/audio-only.mp4' }, 'no-video-track'],
    ['missing models', { src: WALK, models: '/nowhere' }, 'model-missing'],
    [
      'models of something else',
      { src: WALK, models: '/tests/fixtures/foreign/' },
      'model-mismatch',
    ],
    ['an interval that is none', { src: WALK, every: '0' }, 'bad-option'],
    ['an estimator that is none', { src: WALK, estimator: 'huge' }, 'bad-option'],
    ['no address at all', { src: 'http://' }, 'bad-option'],
    ['no address of models', { src: WALK, models: 'http://[' }, 'bad-option'],
  ])('%s: one event of its type, and a sentence in the player', async (_, attributes, type) => {
    const src = attributes.src === 'odd' ? await odd() : attributes.src!;
    const { player, errors } = mount({ ...attributes, src, view: 'overlay', autoplay: '' });
    await vi.waitUntil(() => errors.length > 0, { timeout: 30 * SECONDS });
    expect(errors).toHaveLength(1);
    expect(errors[0]).toMatchObject({ type, fatal: true });
    expect(player.error).toBe(errors[0]);
    expect(player.paused).toBe(true);
    await (player as DeciWatchPlayer & { updateComplete: Promise<unknown> }).updateComplete;
    expect(shownText(player, 'error')).toContain(errors[0]!.message);
    // Whoever asks again is answered again, and not by an exception.
    await player.play();
    expect(errors).toHaveLength(2);
  });

  test('a clip whose download breaks off half way', async () => {
    const real = globalThis.fetch;
    vi.spyOn(globalThis, 'fetch').mockImplementation(async (url, init) => {
      const response = await real(url, init);
      if (!String(url).endsWith(WALK)) return response;
      const body = new ReadableStream({
        start(controller) {
          controller.enqueue(new Uint8Array(1000));
          controller.error(new TypeError('network error'));
        },
      });
      return new Response(body, { headers: { 'content-type': 'video/mp4' } });
    });
    const { player, errors } = mount({ src: WALK, view: 'overlay' });
    await player.load();
    expect(errors.map(({ type }) => type)).toEqual(['file-truncated']);
  });

  test('the 3D view refused: told once, and the rest plays', async () => {
    const real = HTMLCanvasElement.prototype.getContext;
    vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockImplementation(function (
      this: HTMLCanvasElement,
      ...args: unknown[]
    ) {
      if (String(args[0]).startsWith('webgl')) return null;
      return Reflect.apply(real, this, args);
    } as typeof real);
    const { player, errors, poses } = mount({ src: WALK, view: 'both' });
    await player.play();
    await vi.waitUntil(() => poses.length > 20, { timeout: 30 * SECONDS });
    expect(errors).toHaveLength(1);
    expect(errors[0]).toMatchObject({ type: 'webgl-unavailable', fatal: false });
    expect(shownText(player, 'notice')).toContain(errors[0]!.message);
  });

  test('a missing clip is told of before anybody asks for it, and costs nothing else', async () => {
    const { errors } = mount({ src: '/tests/fixtures/nowhere.mp4', view: 'overlay' });
    await vi.waitUntil(() => errors.length > 0, { timeout: 30 * SECONDS });
    expect(errors.map(({ type }) => type)).toEqual(['file-missing']);
    expect(workers.size).toBe(0);
  });

  test('what is no clip at all', async () => {
    const { player, errors } = mount({ view: 'overlay' });
    player.srcObject = new MediaStream() as unknown as Blob;
    await player.play();
    expect(errors.map(({ type }) => type)).toEqual(['bad-option']);
  });

  test('a camera refused once nobody waits for it any more is no error', async () => {
    const refusals: (() => void)[] = [];
    vi.spyOn(navigator.mediaDevices, 'getUserMedia').mockImplementation(
      () =>
        new Promise((_, reject) => {
          refusals.push(() => reject(new DOMException('no', 'NotAllowedError')));
        }),
    );
    const { player, errors } = mount({ camera: '', view: 'overlay' });
    void player.play();
    await vi.waitUntil(() => refusals.length === 1);
    player.pause();
    refusals[0]!();
    await new Promise((resolve) => setTimeout(resolve, 100));
    expect(errors).toEqual([]);
  });

  test('no camera', async () => {
    const { player, errors } = mount({ camera: '', view: 'overlay' });
    await player.play();
    expect(errors).toHaveLength(1);
    expect(errors[0]!.type).toMatch(/^camera-/);
    expect(shownText(player, 'error')).toContain(errors[0]!.message);
  });
});
