import { describe, expect, test, vi } from 'vitest';
import { hasPose } from '../../web/pose/sequence.ts';
import { walk } from './fixtures.ts';
import { mount, SECONDS, WALK, when, workers } from './mounted-player.ts';

describe('a clip', () => {
  test('is played with a pose event for every frame, in order, once', async () => {
    const { player, errors, poses } = mount({ src: WALK, view: 'overlay' });
    const stages: string[] = [];
    player.addEventListener('progress', ({ detail }) => stages.push(detail.stage));
    const loaded = when(player, 'load');
    const cost = when(player, 'cost');
    expect(player.paused).toBe(true);
    void player.play();
    const clip = await loaded;
    expect(clip.interval).toBe(10);
    expect(player.poses).toBe(clip.poses2d);
    expect(player.poses3d).toBe(clip.poses3d);
    expect(await cost).toBe(clip.cost);
    expect(new Set(stages)).toEqual(new Set(['loading', 'watching', 'recovering']));
    expect(player.duration).toBeCloseTo(4.2, 1);
    // The end comes a moment before its events.
    const { times, watched } = clip.poses2d;
    const over = () => player.ended && player.paused && poses.length === times.length;
    await vi.waitUntil(over, { timeout: 40 * SECONDS });

    expect(poses.map(({ frame }) => frame)).toEqual([...times.keys()]);
    expect(poses.map(({ time }) => time)).toEqual([...times]);
    expect(poses.map((pose) => pose.watched)).toEqual(Array.from(watched, Boolean));
    expect(poses.every(({ keypoints }) => keypoints?.length === 66)).toBe(true);
    expect(poses.every(({ keypoints3d }) => keypoints3d?.length === 99)).toBe(true);
    expect(errors).toEqual([]);

    // Another N: recovered again, without the clip being fetched again.
    const fetched = vi.spyOn(globalThis, 'fetch');
    const again = when(player, 'load');
    player.every = 5;
    expect((await again).interval).toBe(5);
    expect(player.getAttribute('every')).toBe('5');
    expect(
      fetched.mock.calls.map(([url]) => String(url)).filter((url) => /walk/.test(url)),
    ).toEqual([]);
  });

  test('that is in the page already is played too, from where currentTime says', async () => {
    const { player, poses } = mount({ view: 'overlay' });
    player.srcObject = await walk();
    player.currentTime = 2;
    await player.load();
    await vi.waitUntil(() => poses.some(({ frame }) => frame === 60), { timeout: 30 * SECONDS });
    expect(player.currentTime).toBeCloseTo(2, 2);
    expect(player.paused).toBe(true);
  });

  test('obeys what was asked last, whatever was under way', async () => {
    const { player, errors, poses } = mount({ src: WALK, view: 'overlay' });
    const told: string[] = [];
    for (const type of ['play', 'pause']) player.addEventListener(type, () => told.push(type));
    await player.load();
    void player.play();
    expect(player.paused).toBe(false);
    player.pause();
    expect(player.paused).toBe(true);
    await new Promise((resolve) => setTimeout(resolve, 500));
    expect(player.paused).toBe(true);
    expect(player.currentTime).toBe(0);
    expect(told).toEqual(['play', 'pause']);

    // Another clip while this one begins to play.
    void player.play();
    player.src = '/tests/fixtures/gap.mp4';
    const loaded = when(player, 'load');
    void player.play();
    await loaded;
    poses.length = 0;
    await vi.waitUntil(() => poses.length > 5, { timeout: 30 * SECONDS });
    expect(errors).toEqual([]);
  });

  test('can be gone through as soon as it is there', async () => {
    const { player, poses } = mount({ src: WALK, view: 'overlay' });
    const order: string[] = [];
    player.addEventListener('pose', () => order.push('pose'));
    player.addEventListener('load', () => {
      order.push('load');
      player.currentTime = 2;
    });
    await player.load();
    await vi.waitUntil(() => poses.some(({ frame }) => frame === 60), { timeout: 30 * SECONDS });
    expect(order[0]).toBe('load');
    expect(() => {
      player.currentTime = Number.NaN;
    }).toThrow(TypeError);
    expect(() => {
      player.volume = 2;
    }).toThrow(DOMException);
    expect(() => {
      player.playbackRate = -1;
    }).toThrow(DOMException);
  });

  test('that was played stops where its new settings cannot be, and comes back with better ones', async () => {
    const { player, errors } = mount({ src: WALK, view: 'overlay', loop: '' });
    await player.play();
    await vi.waitUntil(() => player.currentTime > 0.1, { timeout: 40 * SECONDS });
    player.every = 99;
    await vi.waitUntil(() => errors.length === 1, { timeout: 10 * SECONDS });
    expect(errors[0]!.type).toBe('bad-option');
    // A frame that was on its way comes yet.
    await new Promise((resolve) => setTimeout(resolve, 200));
    const { currentTime } = player;
    await new Promise((resolve) => setTimeout(resolve, 300));
    expect(player.currentTime).toBe(currentTime);
    player.every = 20;
    const again = when(player, 'load');
    void player.play();
    expect((await again).interval).toBe(20);
    expect(player.error).toBe(null);
  });

  test('without anybody in it is an error; with nobody in some frames it is none', async () => {
    const { player, errors } = mount({ src: '/tests/fixtures/empty-room.mp4', view: 'overlay' });
    await player.load();
    expect(errors.map(({ type }) => type)).toEqual(['nobody-in-view']);

    const { player: other, poses } = mount({ src: '/tests/fixtures/gap.mp4', view: 'overlay' });
    await other.load();
    const empty = [...other.poses!.times.keys()].find((frame) => !hasPose(other.poses!, frame))!;
    other.currentTime = other.poses!.times[empty]!;
    await vi.waitUntil(() => poses.some(({ frame }) => frame === empty), { timeout: 30 * SECONDS });
    expect(poses.find(({ frame }) => frame === empty)).toMatchObject({
      keypoints: null,
      scores: null,
    });
  });
});

describe('players on a page', () => {
  test('have room where their place has no width of its own', () => {
    const place = document.createElement('div');
    place.style.cssText = 'display: flex; width: 1000px';
    document.body.append(place);
    const { player } = mount({ src: WALK, view: 'overlay', preload: 'none' }, place);
    expect(player.getBoundingClientRect().width).toBeGreaterThan(300);
  });

  test('take over the page’s switch from light to dark', async () => {
    document.documentElement.style.colorScheme = 'light';
    const { player } = mount({ src: WALK, view: 'overlay', controls: '', preload: 'none' });
    const timeline = () =>
      player
        .shadowRoot!.querySelector('dw-player-controls')
        ?.shadowRoot?.querySelector('dw-timeline');
    await vi.waitUntil(() => timeline()?.shadowRoot?.querySelector('.legend, .track'));
    const update = vi.spyOn(timeline()!, 'requestUpdate');
    document.documentElement.style.colorScheme = 'dark';
    await vi.waitUntil(() => update.mock.calls.length > 0, { timeout: 10 * SECONDS });
    document.documentElement.style.colorScheme = '';
  });

  test('share one worker, and free it when the last one goes', async () => {
    const first = mount({ src: WALK, view: 'overlay' });
    const second = mount({ src: '/tests/fixtures/gap.mp4', view: 'overlay' });
    await Promise.all([first.player.load(), second.player.load()]);
    expect(workers.size).toBe(1);
    first.player.remove();
    await Promise.resolve();
    expect(workers.size).toBe(1);
    expect(first.player.clip).toBe(null);
    // Moved, not removed: it keeps what it has.
    const place = document.createElement('div');
    document.body.append(place);
    place.append(second.player);
    await new Promise((resolve) => setTimeout(resolve));
    expect(workers.size).toBe(1);
    expect(second.player.clip).not.toBe(null);
  });

  test('rest while they are out of sight, and go on in it', async () => {
    const { player, poses } = mount({ src: WALK, view: 'overlay', loop: '' });
    await player.play();
    await vi.waitUntil(() => poses.length > 5, { timeout: 40 * SECONDS });
    player.style.display = 'none';
    const video = player
      .shadowRoot!.querySelector('dw-clip-view')!
      .shadowRoot!.querySelector('video')!;
    await vi.waitUntil(() => video.paused, { timeout: 5 * SECONDS });
    expect(player.paused).toBe(false);
    player.style.display = '';
    await vi.waitUntil(() => !video.paused, { timeout: 5 * SECONDS });
  });

  test('fetch nothing but a first picture until they are wanted', async () => {
    const fetched = vi.spyOn(globalThis, 'fetch');
    const { player } = mount({ src: WALK });
    await vi.waitUntil(() => player.videoWidth > 0, { timeout: 30 * SECONDS });
    expect(fetched).not.toHaveBeenCalled();
    expect(workers.size).toBe(0);
  });

  test('with autoplay stand still where less motion is asked for', async () => {
    const real = globalThis.matchMedia;
    vi.spyOn(globalThis, 'matchMedia').mockImplementation((query) =>
      query.includes('reduced-motion')
        ? ({
            matches: true,
            addEventListener() {},
            removeEventListener() {},
          } as unknown as MediaQueryList)
        : real(query),
    );
    const { player } = mount({ src: WALK, autoplay: '', view: 'overlay' });
    await when(player, 'load');
    await new Promise((resolve) => setTimeout(resolve, 300));
    expect(player.paused).toBe(true);
  });
});
