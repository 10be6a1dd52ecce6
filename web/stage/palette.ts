import type { Side } from '../pose/skeleton.ts';

/** Light or dark surroundings. */
export type Theme = 'light' | 'dark';

/** The colours of a drawn pose, as CSS hex. */
export interface Palette {
  /**
   * Left and right differ in hue (orange, blue) and in lightness, so that people with any of the common
   * colour-vision deficiencies tell them apart.
   * @see https://jfly.uni-koeln.de/color/ (Okabe and Ito)
   */
  readonly sides: Readonly<Record<Side, string>>;
  /** The joints and the ring of a watched frame. */
  readonly watched: string;
  /** What low-score joints fade into. */
  readonly background: string;
  readonly floor: string;
  readonly grid: string;
}

const PALETTES: Readonly<Record<Theme, Palette>> = {
  light: {
    sides: { left: '#f08a1d', right: '#1f66c9', middle: '#8a94a3' },
    watched: '#11161d',
    background: '#eef1f4',
    floor: '#e2e7ec',
    grid: '#a9b4c0',
  },
  dark: {
    sides: { left: '#ffa640', right: '#4d97f5', middle: '#a5aebb' },
    watched: '#ffffff',
    background: '#12171e',
    floor: '#1c232c',
    grid: '#4a5664',
  },
};

/** The palette for a theme. */
export function paletteFor(theme: Theme): Palette {
  return PALETTES[theme];
}
