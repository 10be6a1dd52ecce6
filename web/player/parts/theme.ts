import type { ReactiveController, ReactiveControllerHost } from 'lit';
import type { Theme } from '../../stage/palette.ts';

/**
 * Light or dark, as CSS `light-dark()` sees it where the host is: the system's setting where the page allows
 * both, else what the page is. Re-renders its host when the system's setting changes.
 */
export class ThemeController implements ReactiveController {
  readonly #query = matchMedia('(prefers-color-scheme: dark)');
  readonly #host: ReactiveControllerHost & Element;
  #theme: Theme = 'light';

  constructor(host: ReactiveControllerHost & Element) {
    this.#host = host;
    host.addController(this);
  }

  get theme(): Theme {
    return this.#theme;
  }

  hostConnected(): void {
    this.#query.addEventListener('change', this.#look);
    this.#look();
  }

  hostDisconnected(): void {
    this.#query.removeEventListener('change', this.#look);
  }

  readonly #look = () => {
    const { colorScheme } = getComputedStyle(this.#host);
    const dark = colorScheme.includes('dark');
    const theme =
      dark && (this.#query.matches || !colorScheme.includes('light')) ? 'dark' : 'light';
    if (theme === this.#theme) return;
    this.#theme = theme;
    this.#host.requestUpdate();
  };
}
