import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { createEngine } from '../engine/client.ts';
import type { Engine } from '../engine/types.ts';

/** The page's one engine, which files and the camera share, so that models are loaded once. */
export class PageEngine implements ReactiveController {
  #engine: Engine | null = null;

  constructor(host: ReactiveControllerHost) {
    host.addController(this);
  }

  get(): Engine {
    this.#engine ??= createEngine();
    return this.#engine;
  }

  hostConnected(): void {}

  hostDisconnected(): void {
    this.#engine?.close();
    this.#engine = null;
  }
}
