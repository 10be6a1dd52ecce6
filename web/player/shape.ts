import type { PlayerView } from './types.ts';

/** The 3D view beside a picture is square, below it a little wider, alone as wide as a screen. */
const STAGE_BESIDE = 1;
const STAGE_BELOW = 1.25;
const STAGE_ALONE = 16 / 10;

/**
 * The panes' shape as CSS custom properties: width by height as a whole, and how two panes share it, side by
 * side or, in a narrow player, one above the other.
 * @param aspect width by height of the picture
 */
export function shapeOf(view: PlayerView, aspect: number): string {
  if (view === 'overlay') return `--shape: ${round(aspect)}`;
  if (view === 'stage') return `--shape: ${STAGE_ALONE}`;
  const rows = [1 / aspect, 1 / STAGE_BELOW];
  const tall = 1 / (rows[0]! + rows[1]!);
  return [
    `--shape: ${round(aspect + STAGE_BESIDE)}`,
    `--columns: minmax(0, ${round(aspect)}fr) minmax(0, ${STAGE_BESIDE}fr)`,
    `--tall-shape: ${round(tall)}`,
    `--rows: ${rows.map((row) => `minmax(0, ${round(row)}fr)`).join(' ')}`,
  ].join('; ');
}

function round(value: number): number {
  return Number(value.toFixed(4));
}
