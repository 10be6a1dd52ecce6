import { css } from 'lit';

/** The player's own layout. */
export const playerStyles = css`
  :host { display: block; position: relative; container-type: inline-size; }
  .player {
    display: flex; flex-direction: column; height: 100%; overflow: hidden; position: relative;
    background: var(--surface); border: 1px solid var(--line); border-radius: var(--round);
  }
  .panes { position: relative; display: grid; flex: 1 1 auto; min-height: 0; max-height: 85vh; aspect-ratio: var(--shape); background: var(--video); }
  .panes > dw-clip-view, .panes > dw-live-view, .panes > dw-stage-view { min-width: 0; min-height: 0; height: 100%; }
  .both { grid-template-columns: var(--columns); }
  /* It plays on beneath: a video that is not shown at all tells of no frames. */
  .panes.stage > dw-clip-view, .panes.stage > dw-live-view { position: absolute; inset: 0; }
  .panes.stage > dw-stage-view { z-index: 1; }
  .cover { z-index: 2; }
  .unstaged { background: var(--sunken); display: grid; place-items: end center; padding: 0.75rem; font-size: 0.8125rem; color: var(--muted); text-align: center; }
  .dimmed { opacity: 0.45; }

  .cover { position: absolute; inset: 0; display: grid; place-items: center; pointer-events: none; }
  .cover > * { grid-area: 1 / 1; pointer-events: auto; }
  .poster, slot[name='poster']::slotted(*) { width: 100%; height: 100%; object-fit: contain; pointer-events: none; }
  .poster { background: var(--video); }
  .start {
    width: 4.25rem; height: 4.25rem; padding: 0; border-radius: 50%; border: 0;
    color: #fff; background: rgb(8 12 18 / 0.72); box-shadow: 0 0 0 2px rgb(255 255 255 / 0.85);
  }
  .start:hover:not(:disabled) { background: rgb(8 12 18 / 0.9); }
  .start svg { width: 2rem; height: 2rem; }
  .start:focus-visible { outline: 3px solid #fff; outline-offset: 3px; box-shadow: 0 0 0 2px #fff, 0 0 0 9px rgb(8 12 18 / 0.72); }
  .quiet:not(:focus-visible) { opacity: 0; pointer-events: none; }
  .box { width: min(25rem, calc(100% - 1.5rem)); padding: 0.875rem 1rem 1rem; max-height: calc(100% - 1rem); overflow: auto; }
  .doing { font-weight: 560; }
  .small { font-size: 0.8125rem; color: var(--muted); }
  progress { appearance: none; display: block; width: 100%; height: 8px; margin: 0.625rem 0 0.375rem; border: 0; border-radius: 4px; background: var(--pressed); overflow: hidden; }
  progress::-webkit-progress-bar { background: var(--pressed); }
  progress::-webkit-progress-value { background: var(--accent); }
  progress::-moz-progress-bar { background: var(--accent); }
  .figures { display: flex; justify-content: space-between; font-size: 0.8125rem; color: var(--muted); }
  .problem { display: grid; gap: 0.75rem; justify-items: start; color: var(--danger); background: var(--danger-faint); border-color: transparent; }
  .problem p { text-wrap: pretty; overflow-wrap: anywhere; }
  .problem button { color: var(--ink); }
  .notice { padding: 0.5rem 0.875rem; font-size: 0.8125rem; color: var(--danger); background: var(--danger-faint); }

  @container (max-width: 40rem) {
    .both { grid-template-columns: minmax(0, 1fr); grid-template-rows: var(--rows); aspect-ratio: var(--tall-shape); }
    .start { width: 3.5rem; height: 3.5rem; }
  }
  :host(:fullscreen) .player { border: 0; border-radius: 0; }
  :host(:fullscreen) .panes { max-height: none; }
  @media (prefers-reduced-motion: no-preference) {
    .dimmed, .panes > * { transition: opacity 200ms; }
    .quiet { transition: opacity 150ms; }
    progress::-webkit-progress-value { transition: width 180ms linear; }
  }
`;
