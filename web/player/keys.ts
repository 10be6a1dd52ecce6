import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { ControlAction } from './player-controls.ts';

const CLIP_KEYS: Readonly<Record<string, ControlAction>> = {
  k: { kind: 'toggle' },
  m: { kind: 'mute' },
  f: { kind: 'fullscreen' },
  ',': { kind: 'back' },
  '.': { kind: 'forward' },
};

const CAMERA_KEYS: Readonly<Record<string, ControlAction>> = {
  k: { kind: 'toggle' },
  f: { kind: 'fullscreen' },
};

/** The keys of a player while the focus is in it. */
export class PlayerKeys implements ReactiveController {
  readonly #host: EventTarget & { readonly controls: boolean; readonly camera: boolean };
  readonly #obey: (action: ControlAction) => void;

  constructor(
    host: ReactiveControllerHost &
      EventTarget & { readonly controls: boolean; readonly camera: boolean },
    obey: (action: ControlAction) => void,
  ) {
    this.#host = host;
    this.#obey = obey;
    host.addController(this);
  }

  hostConnected(): void {
    this.#host.addEventListener('keydown', this.#pressed);
  }

  hostDisconnected(): void {
    this.#host.removeEventListener('keydown', this.#pressed);
  }

  readonly #pressed = (event: Event) => {
    if (!(event instanceof KeyboardEvent) || !this.#host.controls) return;
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (isForWriting(event.composedPath()[0])) return;
    const action = (this.#host.camera ? CAMERA_KEYS : CLIP_KEYS)[event.key.toLowerCase()];
    // Held down, a key goes on through the frames, but switches nothing on and off.
    if (!action || (event.repeat && action.kind !== 'back' && action.kind !== 'forward')) return;
    event.preventDefault();
    this.#obey(action);
  };
}

/** What the page has put into a slot may have a use for letters. */
function isForWriting(target: EventTarget | undefined): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return target.type !== 'range';
  return target.isContentEditable || target.matches('textarea, select');
}
