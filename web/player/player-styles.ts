import { css } from 'lit';

/** The player's own layout. */
export const playerStyles = css`
  :host { display: block; position: relative; container-type: inline-size; contain-intrinsic-inline-size: 640px; font-size: 16px; }
  .player:focus { outline: none; }
  .player:focus-visible { outline: 2px solid var(--focus); outline-offset: -2px; }
  .player {
    display: flex; flex-direction: column; height: 100%; overflow: hidden; position: relative;
    background: var(--surface); border: 1px solid var(--line); border-radius: var(--round);
  }
  .panes {
    position: relative; display: grid; min-height: 0; background: var(--video);
    /* As high as its picture asks for within the window; a player with a height of its own is filled. */
    flex: 1 1 auto; height: min(85vh, 100cqi / var(--shape));
  }
  .panes > dw-clip-view, .panes > dw-live-view, .panes > dw-stage-view { min-width: 0; min-height: 0; height: 100%; }
  .both { grid-template-columns: var(--columns); }
  /* It plays on beneath: a video that is not shown at all tells of no frames. */
  .panes.stage > dw-clip-view, .panes.stage > dw-live-view { position: absolute; inset: 0; }
  .panes.stage > dw-stage-view { z-index: 1; }
  .unstaged { background: var(--sunken); display: grid; place-items: end center; padding: 12px; font-size: 13px; color: var(--muted); text-align: center; }
  .dimmed { opacity: 0.45; }

  .cover {
    position: absolute; inset: 0; z-index: 2; pointer-events: none;
    display: grid; grid-template: minmax(0, 1fr) / minmax(0, 1fr); place-items: center;
  }
  /* The picture's own place; what must be read may cover both. */
  .both > .over-picture { grid-area: 1 / 1 / 2 / 2; }
  .cover > *, .poster, .cover slot > *, slot::slotted(*) { grid-area: 1 / 1; pointer-events: auto; }
  slot[name='poster']::slotted(*) { box-sizing: border-box; }
  .poster, slot[name='poster']::slotted(*) { width: 100%; height: 100%; object-fit: contain; pointer-events: none; }
  .poster { background: var(--video); }
  .start {
    width: 68px; height: 68px; padding: 0; border-radius: 50%; border: 0;
    color: #fff; background: rgb(8 12 18 / 0.72); box-shadow: 0 0 0 2px rgb(255 255 255 / 0.85);
  }
  .start:hover:not(:disabled) { background: rgb(8 12 18 / 0.9); }
  .start svg { width: 32px; height: 32px; }
  .start:focus-visible { outline: 3px solid #fff; outline-offset: 3px; box-shadow: 0 0 0 2px #fff, 0 0 0 9px rgb(8 12 18 / 0.72); }
  .quiet:not(:focus-visible) { opacity: 0; pointer-events: none; }
  .box { width: min(400px, calc(100% - 24px)); padding: 14px 16px 16px; max-height: calc(100% - 16px); overflow: auto; }
  .doing { font-weight: 560; }
  .small { font-size: 13px; color: var(--muted); }
  progress { appearance: none; display: block; width: 100%; height: 8px; margin: 10px 0 6px; border: 0; border-radius: 4px; background: var(--pressed); overflow: hidden; }
  progress::-webkit-progress-bar { background: var(--pressed); }
  progress::-webkit-progress-value { background: var(--accent); }
  progress::-moz-progress-bar { background: var(--accent); }
  .figures { display: flex; justify-content: space-between; font-size: 13px; color: var(--muted); }
  .problem { display: grid; gap: 12px; justify-items: start; color: var(--danger); background: var(--danger-faint); border-color: transparent; }
  .problem p { text-wrap: pretty; overflow-wrap: anywhere; }
  .problem button { color: var(--ink); }
  .notice { padding: 8px 14px; font-size: 13px; color: var(--danger); background: var(--danger-faint); }

  @container (max-width: 640px) {
    .both { grid-template-columns: minmax(0, 1fr); grid-template-rows: var(--rows); height: min(120vh, 100cqi / var(--tall-shape)); }
    .start { width: 56px; height: 56px; }
  }
  @container (max-width: 320px) {
    .box { padding: 8px 10px; font-size: 13px; }
    .problem { gap: 6px; }
  }
  :host(:fullscreen) .player { border: 0; border-radius: 0; }
  @media (prefers-reduced-motion: no-preference) {
    .dimmed, .panes > * { transition: opacity 200ms; }
    .quiet { transition: opacity 150ms; }
    progress::-webkit-progress-value { transition: width 180ms linear; }
  }
`;
