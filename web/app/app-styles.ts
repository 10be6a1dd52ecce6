import { css } from 'lit';

/** The page's layout: two panes over a timeline over settings and counter; one column on a phone. */
export const appStyles = css`
  :host { display: block; }
  .stack { display: grid; gap: 0.875rem; grid-template-columns: minmax(0, 1fr); }
  .viewer { overflow: hidden; container-type: inline-size; }
  .panes { position: relative; display: grid; grid-template-columns: minmax(0, 1fr); }
  dw-clip-view, dw-live-view { aspect-ratio: var(--aspect); width: 100%; max-height: 56vh; }
  dw-stage-view { height: clamp(17rem, 38vh, 26rem); }
  .pane { position: relative; }
  .pane:first-child { background: var(--video); }
  .pane > * { transition: opacity 200ms; }
  .dimmed > dw-clip-view, .dimmed > dw-stage-view { opacity: 0.45; }
  .pane > dw-progress-card, .pane > .start {
    position: absolute; left: 50%; top: 50%; translate: -50% -50%; width: min(25rem, calc(100% - 2rem));
  }
  .start { display: grid; gap: 0.75rem; justify-items: center; text-align: center; padding: 1.25rem; }
  .deck { padding: 0.75rem 1rem 0.9375rem; border-top: 1px solid var(--line); display: grid; gap: 0.75rem; }

  @media (min-width: 56rem) {
    /* As wide and as high as the picture asks for, within what leaves the 3D view enough. */
    .panes > * { --height: clamp(22rem, 66cqw / var(--aspect), max(22rem, 47vh)); }
    .panes { grid-template-columns: clamp(36%, max(22rem, 47vh) * var(--aspect), 66%) minmax(0, 1fr); }
    dw-clip-view, dw-live-view, dw-stage-view { aspect-ratio: auto; max-height: none; height: var(--height); }
    .lower { grid-template-columns: minmax(17rem, 22rem) minmax(0, 1fr); }
  }

  .notices { display: grid; gap: 0.5rem; }
  .notices:not(:has(.notice)) { position: absolute; }
  .notice { display: flex; align-items: flex-start; gap: 0.75rem; padding: 0.625rem 0.625rem 0.625rem 1rem; border-radius: var(--round-small); }
  .notice p { flex: 1; padding-block: 0.3125rem; text-wrap: pretty; overflow-wrap: anywhere; }
  .notice button { min-height: 2.125rem; min-width: 2.125rem; }
  .error { background: var(--danger-faint); color: var(--danger); }
  .note { background: var(--surface); border: 1px solid var(--line); }

  .drop {
    position: fixed; inset: 0; z-index: 10; display: grid; place-content: center; pointer-events: none;
    background: color-mix(in srgb, var(--page) 82%, transparent); font-size: 1.375rem; font-weight: 600;
  }
  .drop::before { content: ''; position: absolute; inset: 1rem; border: 3px dashed var(--accent); border-radius: 22px; }
`;
