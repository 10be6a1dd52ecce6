import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** Lets files be dropped anywhere on the page; `active` while some are held over it. */
export class FileDrop implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #onFiles: (files: readonly File[]) => void;
  readonly #listeners: readonly [string, (event: DragEvent) => void][];
  #active = false;

  constructor(host: ReactiveControllerHost, onFiles: (files: readonly File[]) => void) {
    this.#host = host;
    this.#onFiles = onFiles;
    this.#listeners = [
      ['dragenter', this.#over],
      ['dragover', this.#over],
      ['dragleave', this.#left],
      ['drop', this.#dropped],
    ];
    host.addController(this);
  }

  get active(): boolean {
    return this.#active;
  }

  hostConnected(): void {
    for (const [type, listener] of this.#listeners)
      addEventListener(type, listener as EventListener);
  }

  hostDisconnected(): void {
    for (const [type, listener] of this.#listeners)
      removeEventListener(type, listener as EventListener);
  }

  readonly #over = (event: DragEvent) => {
    // Text or an image being dragged about on the page is none of ours.
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = 'copy';
    this.#set(true);
  };

  readonly #left = (event: DragEvent) => {
    // Null when the pointer leaves the window, not merely one element for another.
    if (event.relatedTarget === null) this.#set(false);
  };

  readonly #dropped = (event: DragEvent) => {
    this.#set(false);
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    this.#onFiles([...event.dataTransfer.files]);
  };

  #set(active: boolean): void {
    if (active === this.#active) return;
    this.#active = active;
    this.#host.requestUpdate();
  }
}
