import { html, svg, type TemplateResult } from 'lit';

/** Paths on a 24-unit grid, stroked with the text's colour. */
const PATHS = {
  play: svg`<path d="M7 4.8v14.4L19 12z" fill="currentColor"/>`,
  pause: svg`<path d="M8 5v14M16 5v14" stroke-width="3.4"/>`,
  previous: svg`<path d="M15 6l-6 6 6 6"/>`,
  next: svg`<path d="M9 6l6 6-6 6"/>`,
  first: svg`<path d="M18 6l-6 6 6 6M7 6v12"/>`,
  last: svg`<path d="M6 6l6 6-6 6M17 6v12"/>`,
  left: svg`<path d="M4 5v5h5"/><path d="M4.6 10A8 8 0 1 1 4.3 14"/>`,
  right: svg`<path d="M20 5v5h-5"/><path d="M19.4 10A8 8 0 1 0 19.7 14"/>`,
  plus: svg`<path d="M12 5v14M5 12h14"/>`,
  minus: svg`<path d="M5 12h14"/>`,
  sound: svg`<path d="M4 9.5v5h3.5L12 18.5v-13L7.5 9.5z"/><path d="M15.5 9a4.2 4.2 0 0 1 0 6M18 6.5a7.8 7.8 0 0 1 0 11"/>`,
  muted: svg`<path d="M4 9.5v5h3.5L12 18.5v-13L7.5 9.5z"/><path d="M16 9.5l5 5M21 9.5l-5 5"/>`,
  open: svg`<path d="M12 16V5M7.5 9L12 4.5 16.5 9M5 15v4h14v-4"/>`,
  save: svg`<path d="M12 4.5V15M7.5 11L12 15.5 16.5 11M5 16v3.5h14V16"/>`,
  camera: svg`<rect x="3" y="6.5" width="12.5" height="11" rx="2"/><path d="M15.5 11l5-3v8l-5-3"/>`,
  stop: svg`<rect x="6.5" y="6.5" width="11" height="11" rx="1.5" fill="currentColor"/>`,
  record: svg`<circle cx="12" cy="12" r="6" fill="currentColor"/>`,
  grow: svg`<path d="M9 4.5H4.5V9M15 4.5h4.5V9M9 19.5H4.5V15M15 19.5h4.5V15"/>`,
  shrink: svg`<path d="M4.5 9H9V4.5M19.5 9H15V4.5M4.5 15H9v4.5M19.5 15H15v4.5"/>`,
  close: svg`<path d="M6 6l12 12M18 6L6 18"/>`,
  keyboard: svg`<rect x="3" y="6.5" width="18" height="11" rx="2"/><path d="M7 10h.01M11 10h.01M15 10h.01M8 14h8"/>`,
} as const;

export type IconName = keyof typeof PATHS;

/** A decorative icon; the control that holds it carries the words. */
export function icon(name: IconName): TemplateResult {
  return html`<svg
    viewBox="0 0 24 24"
    width="20"
    height="20"
    fill="none"
    stroke="currentColor"
    stroke-width="1.8"
    stroke-linecap="round"
    stroke-linejoin="round"
    aria-hidden="true"
  >${PATHS[name]}</svg>`;
}
