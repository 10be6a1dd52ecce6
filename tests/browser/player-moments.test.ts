import { describe, expect, test, vi } from 'vitest';
import type { DeciWatchPlayer } from '../../web/player/types.ts';
import { mount, SECONDS, WALK, when, workers } from './mounted-player.ts';

const GAP = '/tests/fixtures/gap.mp4';

function videoOf(player: DeciWatchPlayer): HTMLVideoElement {
  return player.shadowRoot!.querySelector('dw-clip-view')!.shadowRoot!.querySelector('video')!;
}

/** The player has taken in what was set. */
function drawn(): Promise<unknown> {
  return new Promise(requestAnimationFrame);
}

async function playing(player: DeciWatchPlayer): Promise<void> {
  await player.play();
  await vi.waitUntil(() => player.currentTime > 0.1, { timeout: 40 * SECONDS });
}

/** `play`, `pause` as they are told. */
function wishes(player: DeciWatchPlayer): string[] {
  const told: string[] = [];
  for (const type of ['play', 'pause']) player.addEventListener(type, () => told.push(type));
  return told;
}

test('time runs on after a jump while it plays', async () => {
  const { player } = mount({ src: WALK, view: 'overlay', loop: '' });
  await playing(player);
  player.currentTime = 1;
  await vi.waitUntil(() => player.currentTime > 1.2, { timeout: 20 * SECONDS });
});

test('a clip after another: play is told, and no pause that nobody asked for', async () => {
  const { player } = mount({ src: WALK, view: 'overlay' });
  await player.load();
  const told = wishes(player);
  for (const src of [GAP, WALK]) {
    player.src = src;
    await player.play();
  }
  expect(told).toEqual(['play']);
  expect(player.paused).toBe(false);
});

test('what concerns the camera alone does not recover a clip again', async () => {
  const { player } = mount({ src: GAP, view: 'overlay' });
  await player.load();
  const { clip } = player;
  const progress = vi.fn();
  player.addEventListener('progress', progress);
  player.mode = 'now';
  await new Promise((resolve) => setTimeout(resolve, 500));
  expect(progress).not.toHaveBeenCalled();
  expect(player.clip).toBe(clip);
});

test('keys that go through a clip leave a player alone that has none yet', async () => {
  const { player } = mount({ src: WALK, view: 'overlay', preload: 'none', controls: '' });
  await drawn();
  const start = () => player.shadowRoot!.querySelector('.cover button');
  expect(start()).not.toBeNull();
  for (const key of ['.', ',']) {
    player.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, composed: true }));
  }
  await drawn();
  expect(start()).not.toBeNull();
});

describe('a player that is not on the page', () => {
  test('can load before it is put there, keeps no worker, and plays once it is seen', async () => {
    const player = document.createElement('deciwatch-player');
    Object.assign(player, { src: GAP, estimator: 'lite', view: 'overlay', muted: true });
    const loaded = when(player, 'load');
    await player.load();
    expect(await loaded).toBe(player.clip);
    await vi.waitUntil(() => workers.size === 0, { timeout: 5 * SECONDS });
    await player.play();
    document.body.append(player);
    await vi.waitUntil(() => player.currentTime > 0.1, { timeout: 20 * SECONDS });
  });

  test('does not go on with what was asked in the moment in which it was taken away', async () => {
    const { player } = mount({ src: GAP, view: 'overlay' });
    await drawn();
    player.every = 5;
    void player.play();
    player.remove();
    await new Promise((resolve) => setTimeout(resolve, 300));
    expect(player.paused).toBe(true);
    expect(workers.size).toBe(0);
  });

  test('keeps neither worker nor camera that were asked for afterwards', async () => {
    const { player } = mount({ src: GAP, view: 'overlay' });
    await player.load();
    player.remove();
    await Promise.resolve();
    await player.load();
    await vi.waitUntil(() => workers.size === 0, { timeout: 5 * SECONDS });
    const asked = vi.spyOn(navigator.mediaDevices, 'getUserMedia');
    player.camera = true;
    await player.play();
    expect(asked).not.toHaveBeenCalled();
  });
});

test('one that plays and is moved to where nobody sees it rests', async () => {
  const { player } = mount({ src: WALK, view: 'overlay', loop: '' });
  await playing(player);
  const hidden = document.createElement('div');
  hidden.style.display = 'none';
  document.body.append(hidden);
  hidden.append(player);
  await vi.waitUntil(() => videoOf(player).paused, { timeout: 10 * SECONDS });
  expect(player.paused).toBe(false);
  hidden.style.display = '';
  await vi.waitUntil(() => !videoOf(player).paused, { timeout: 10 * SECONDS });
});
