import { afterEach, beforeEach, expect, vi } from 'vitest';
import '../../web/player/player.ts';
import type {
  DeciWatchPlayer,
  PlayerErrorDetail,
  PlayerEventMap,
  PoseDetail,
} from '../../web/player/types.ts';

export const WALK = '/samples/walk.mp4';
export const SECONDS = 1000;

/** Workers that have been started and not ended. */
export const workers = new Set<Worker>();
const unhandled: unknown[] = [];

// Every test of whoever imports this leaves no worker and no unhandled rejection.
beforeEach(() => {
  const { Worker: Real } = globalThis;
  vi.stubGlobal(
    'Worker',
    class extends Real {
      constructor(...args: ConstructorParameters<typeof Worker>) {
        super(...args);
        workers.add(this);
      }
      override terminate() {
        super.terminate();
        workers.delete(this);
      }
    },
  );
  addEventListener('unhandledrejection', keep);
});

afterEach(async () => {
  document.body.replaceChildren();
  await expect.poll(() => workers.size).toBe(0);
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
  removeEventListener('unhandledrejection', keep);
  expect(unhandled.splice(0)).toEqual([]);
});

function keep(event: PromiseRejectionEvent): void {
  unhandled.push(event.reason);
}

/** A player with these attributes on the page, and what it tells. */
export function mount(attributes: Record<string, string>, parent: Element = document.body) {
  const player = document.createElement('deciwatch-player');
  const errors: PlayerErrorDetail[] = [];
  const poses: PoseDetail[] = [];
  player.addEventListener('error', ({ detail }) => errors.push(detail));
  player.addEventListener('pose', ({ detail }) => poses.push(detail));
  for (const [name, value] of Object.entries({ estimator: 'lite', muted: '', ...attributes })) {
    player.setAttribute(name, value);
  }
  parent.append(player);
  return { player, errors, poses };
}

/** What the next event of a type tells. */
export function when<K extends keyof PlayerEventMap>(player: DeciWatchPlayer, type: K) {
  return new Promise<PlayerEventMap[K]['detail']>((resolve) => {
    player.addEventListener(type, ({ detail }) => resolve(detail), { once: true });
  });
}

/** The text of a part of the player. */
export function shownText(player: DeciWatchPlayer, part: string): string {
  return player.shadowRoot!.querySelector(`[part=${part}]`)?.textContent?.trim() ?? '';
}
