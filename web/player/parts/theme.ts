import { css, type ReactiveController, type ReactiveControllerHost } from 'lit';
import type { Theme } from '../../stage/palette.ts';

/** For the host's styles: a colour that nobody sees, whose change tells of another scheme by a page's own switch. */
export const themeStyles = css`
  :host { text-decoration-color: light-dark(black, white); transition: text-decoration-color 1ms; }
`;

/**
 * Light or dark, as CSS `light-dark()` sees it where the host is: the system's setting where the page allows
 * both, else what the page is. Re-renders its host when that changes; the host must have {@link themeStyles}.
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
    this.#host.addEventListener('transitionend', this.#look);
    this.#look();
  }

  hostDisconnected(): void {
    this.#query.removeEventListener('change', this.#look);
    this.#host.removeEventListener('transitionend', this.#look);
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
