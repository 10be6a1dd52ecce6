import { openFile } from '../sources/file.ts';

declare global {
  interface Window {
    /** The chosen clip's pictures, each as a JPEG in base64, `width` pixels wide. */
    jpegsOfChosenClip?: (width: number) => Promise<string[]>;
  }
}

const QUALITY = 0.92;
const input = document.querySelector<HTMLInputElement>('#clip')!;

window.jpegsOfChosenClip = async (width) => {
  const file = input.files![0]!;
  const clip = await openFile(file, file.name);
  try {
    const even = 2 * Math.round((width * clip.info.height) / clip.info.width / 2);
    const canvas = new OffscreenCanvas(width, even);
    const context = canvas.getContext('2d', { alpha: false })!;
    const jpegs: string[] = [];
    for await (const { image } of clip.frames(clip.times.keys())) {
      context.drawImage(image as OffscreenCanvas, 0, 0, canvas.width, canvas.height);
      const blob = await canvas.convertToBlob({ type: 'image/jpeg', quality: QUALITY });
      const bytes = new Uint8Array(await blob.arrayBuffer());
      jpegs.push(btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')));
    }
    return jpegs;
  } finally {
    clip.close();
  }
};
