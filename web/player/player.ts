/**
 * `<deciwatch-player>`: importing this registers the element.
 *
 *     <script type="module" src="https://host/widget.js"></script>
 *     <deciwatch-player src="clip.mp4" every="10" controls></deciwatch-player>
 */
import './player-element.ts';

export type * from './types.ts';
