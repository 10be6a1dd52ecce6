import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** Whether a host can be seen: in the window, in a tab that is shown. */
export class SightController implements ReactiveController {
  readonly #host: ReactiveControllerHost & Element;
  readonly #onChange: (inSight: boolean) => void;
  readonly #observer: IntersectionObserver;
  #intersects = false;
  #told: boolean | null = null;

  /** @param onChange told once it is known and when it changes; before, it counts as out of sight */
  constructor(host: ReactiveControllerHost & Element, onChange: (inSight: boolean) => void) {
    this.#host = host;
    this.#onChange = onChange;
    this.#observer = new IntersectionObserver((entries) => {
      this.#intersects = entries.at(-1)!.isIntersecting;
      this.#tell();
    });
    host.addController(this);
  }

  get inSight(): boolean {
    return this.#told === true;
  }

  hostConnected(): void {
    this.#observer.observe(this.#host);
    document.addEventListener('visibilitychange', this.#tell);
  }

  hostDisconnected(): void {
    this.#observer.disconnect();
    document.removeEventListener('visibilitychange', this.#tell);
    this.#intersects = false;
    this.#told = null;
  }

  readonly #tell = () => {
    const inSight = this.#intersects && !document.hidden;
    if (inSight === this.#told) return;
    this.#told = inSight;
    this.#onChange(inSight);
  };
}
