import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
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
  const site = await buildAndServe(PAGE);
  const browser = await chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS],
  });
  const folder = await mkdtemp(join(tmpdir(), 'deciwatch-camera-'));
  const file = join(folder, 'clip.mjpeg');
  try {
    const page = await browser.newPage();
    await page.goto(new URL(PAGE, site.url).href);
    await page.waitForFunction(() => window.jpegsOfChosenClip !== undefined);
    await page.setInputFiles('#clip', path);
    const jpegs = await page.evaluate((pixels) => window.jpegsOfChosenClip!(pixels), width);
    await writeFile(file, Buffer.concat(jpegs.map((jpeg) => Buffer.from(jpeg, 'base64'))));
  } finally {
    await browser.close();
    await site.close();
  }
  return {
    args: [
      '--use-fake-ui-for-media-stream',
      '--use-fake-device-for-media-stream',
      `--use-file-for-fake-video-capture=${file}`,
    ],
    remove: () => rm(folder, { recursive: true, force: true }),
  };
}
