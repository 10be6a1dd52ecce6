import type { ReactiveController, ReactiveControllerHost } from 'lit';

export type FullscreenState = 'on' | 'off' | 'unavailable';

/** Shows its host on the whole screen, and re-renders it when that begins or ends. */
export class FullscreenController implements ReactiveController {
  readonly #host: ReactiveControllerHost & Element;

  constructor(host: ReactiveControllerHost & Element) {
    this.#host = host;
    host.addController(this);
  }

  get state(): FullscreenState {
    if (!document.fullscreenEnabled) return 'unavailable';
    return this.#host.matches(':fullscreen') ? 'on' : 'off';
  }

  toggle(): void {
    // Refused without a click, or by a frame's own policy: nothing changes.
    const change = this.state === 'on' ? document.exitFullscreen() : this.#host.requestFullscreen();
    change.catch(() => {});
  }

  hostConnected(): void {
    this.#host.addEventListener('fullscreenchange', this.#changed);
  }

  hostDisconnected(): void {
    this.#host.removeEventListener('fullscreenchange', this.#changed);
  }

  readonly #changed = () => this.#host.requestUpdate();
}
