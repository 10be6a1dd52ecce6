import { css } from 'lit';

/** What every component's shadow tree shares: controls, cards, and text for screen readers only. */
export const sharedStyles = css`
  *, *::before, *::after { box-sizing: border-box; }
  :host([hidden]), [hidden] { display: none !important; }
  h2, h3, p, dl, dd, figure, fieldset, legend { margin: 0; padding: 0; }
  fieldset { border: 0; min-width: 0; }
  h2 { font-size: 15px; font-weight: 620; letter-spacing: -0.005em; }
  svg { display: block; flex: none; }

  button, select {
    font: inherit; color: inherit; cursor: pointer;
    display: inline-flex; align-items: center; justify-content: center; gap: 8px;
    min-height: 40px; min-width: 40px; padding: 0 14px;
    border: 1px solid var(--line); border-radius: var(--round-small); background: var(--surface);
    transition: background-color 120ms, border-color 120ms;
  }
  button:hover:not(:disabled), select:hover { background: var(--hover); border-color: var(--line-strong); }
  button:active:not(:disabled) { background: var(--pressed); }
  button:disabled { color: var(--disabled); cursor: default; }
  button.primary { background: var(--ink); border-color: var(--ink); color: var(--surface); font-weight: 560; }
  button.primary:hover:not(:disabled) { background: var(--ink-hover); border-color: var(--ink-hover); }
  button.bare { border-color: transparent; background: transparent; padding: 0; }
  button.bare:hover:not(:disabled) { background: var(--hover); border-color: transparent; }
  button[aria-pressed='true'] { background: var(--pressed); border-color: var(--line-strong); }
  :focus-visible { outline: 2px solid var(--focus); outline-offset: 2px; }

  .card { background: var(--surface); border: 1px solid var(--line); border-radius: var(--round); }
  .muted { color: var(--muted); }
  .numbers { font-variant-numeric: tabular-nums; }
  .visually-hidden {
    position: absolute; width: 1px; height: 1px; margin: -1px; overflow: hidden;
    clip-path: inset(50%); white-space: nowrap; border: 0;
  }
`;
