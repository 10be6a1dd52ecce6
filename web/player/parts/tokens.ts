import { css } from 'lit';

/**
 * The player's colours and shapes, under the names that the shared parts use. Each can be set from outside by
 * a custom property of its own; light or dark follows the `color-scheme` of the place that the player is in.
 */
export const tokens = css`
  :host {
    --surface: var(--deciwatch-surface, light-dark(#ffffff, #141a21));
    --sunken: var(--deciwatch-stage, light-dark(#eef1f4, #12171e));
    --hover: var(--deciwatch-hover, light-dark(#f0f3f6, #1d252e));
    --pressed: var(--deciwatch-pressed, light-dark(#e5eaef, #27313c));
    --line: var(--deciwatch-line, light-dark(#dde3e9, #252e38));
    --line-strong: var(--deciwatch-line-strong, light-dark(#b9c3cd, #44515f));
    --ink: var(--deciwatch-text, light-dark(#11161d, #f0f3f7));
    --ink-hover: var(--deciwatch-text-hover, light-dark(#2b333d, #ffffff));
    --muted: var(--deciwatch-muted, light-dark(#56616e, #9aa6b3));
    --disabled: light-dark(#97a1ac, #5b6773);
    --accent: var(--deciwatch-accent, light-dark(#00796b, #45c9b5));
    --focus: var(--deciwatch-focus, light-dark(#1f66c9, #7cb4ff));
    --danger: light-dark(#a8231c, #ff9a92);
    --danger-faint: light-dark(#fdeceb, #33191a);
    --video: var(--deciwatch-video, #0b0f14);
    --round: var(--deciwatch-radius, 10px);
    --round-small: calc(var(--round) * 0.7);
    font: 400 16px/1.45 var(--deciwatch-font, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif);
    color: var(--ink);
    text-align: start;
    letter-spacing: normal;
  }
`;
