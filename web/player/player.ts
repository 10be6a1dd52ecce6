/** `<deciwatch-player>`: importing this registers the element. */
export type * from './types.ts';
