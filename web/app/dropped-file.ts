/** Which file of several to open, and what to say about the rest. */
export interface Picked<TFile> {
  readonly file: TFile | null;
  /** Something that went otherwise than people may expect, or why nothing was picked. */
  readonly note: string | null;
}

/**
 * Picks the video out of the files that were dropped or chosen.
 *
 * A file whose type the browser does not know is let through: the engine looks into it.
 */
export function pickVideo<TFile extends { readonly name: string; readonly type: string }>(
  files: readonly TFile[],
): Picked<TFile> {
  const file = files.find(({ type }) => type === '' || type.startsWith('video/')) ?? null;
  if (!file) {
    const what = files[0] ? `“${files[0].name}” is not a video` : 'That was not a file';
    return { file, note: `${what}: choose or drop a video file, such as an MP4, MOV or WebM.` };
  }
  const note =
    files.length > 1
      ? `Several files came at once: “${file.name}” was opened, the others were not.`
      : null;
  return { file, note };
}
