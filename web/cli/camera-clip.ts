import { rmSync } from 'node:fs';
import { mkdtemp, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Browser, chromium } from 'playwright-core';
import { CHROMIUM_ARGS, findChromium } from './chromium.ts';
import { buildAndServe } from './site.ts';

const PAGE = 'web/cli/camera-clip.html';

/** A clip as Chromium's fake camera plays it, in a temporary folder, and the arguments that say so. */
export interface CameraClip {
  readonly args: readonly string[];
  remove(): Promise<void>;
}

/**
 * Makes a clip into a motion JPEG, which the fake camera plays at 30 frames a second, over and over.
 * @param width pixels
 */
export async function makeCameraClip(path: string, width = 640): Promise<CameraClip> {
  const executablePath = await findChromium();
  const folder = await mkdtemp(join(tmpdir(), 'deciwatch-camera-'));
  const file = join(folder, 'clip.mjpeg');
  const removeNow = () => rmSync(folder, { recursive: true, force: true });
  // Interrupted, a command ends without removing it.
  process.once('exit', removeNow);
  const site = await buildAndServe(PAGE);
  let browser: Browser | undefined;
  try {
    browser = await chromium.launch({ executablePath, args: [...CHROMIUM_ARGS] });
    const page = await browser.newPage();
    await page.goto(new URL(PAGE, site.url).href);
    await page.waitForFunction(() => window.jpegsOfChosenClip !== undefined);
    await page.setInputFiles('#clip', path);
    const jpegs = await page.evaluate((pixels) => window.jpegsOfChosenClip!(pixels), width);
    await writeFile(file, Buffer.concat(jpegs.map((jpeg) => Buffer.from(jpeg, 'base64'))));
  } finally {
    await browser?.close();
    await site.close();
  }
  return {
    args: [
      '--use-fake-ui-for-media-stream',
      '--use-fake-device-for-media-stream',
      `--use-file-for-fake-video-capture=${file}`,
    ],
    async remove() {
      removeNow();
      process.off('exit', removeNow);
    },
  };
}
