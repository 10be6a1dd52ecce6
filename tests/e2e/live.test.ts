import { readFile } from 'node:fs/promises';
import { type Browser, chromium, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { type CameraClip, makeCameraClip } from '../../web/cli/camera-clip.ts';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { parsePoseFile } from '../../web/formats/pose-file.ts';
import { INSECURE_HOST, Visit, whenReady } from './site.ts';

let visit: Visit;
let clip: CameraClip;
const browsers: Browser[] = [];

/** The built demo in a browser of its own, whose camera is what `args` say. */
async function open(args: readonly string[], url = visit.site.url) {
  const browser = await chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS, ...args],
  });
  browsers.push(browser);
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  const page = await context.newPage();
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(url);
  return { page, requests };
}

async function startCamera(page: Page): Promise<void> {
  await page.getByTestId('estimator-lite').check({ force: true });
  await page.getByTestId('start-camera').click();
}

const state = (page: Page) => page.getByTestId('live-state').getAttribute('data-state');

beforeAll(async () => {
  visit = await Visit.start();
  clip = await makeCameraClip('public/samples/walk.mp4');
});
afterEach(async () => {
  for (const browser of browsers.splice(0)) await browser.close();
});
afterAll(async () => {
  await visit?.close();
  await clip?.remove();
});

describe('the camera on the built demo', () => {
  test('is followed, recorded, played and saved, without leaving the origin', async () => {
    const { page, requests } = await open(clip.args);
    await startCamera(page);
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    await page.getByTestId('mode-now').check({ force: true });
    // However slow this machine is, N is to stay.
    await page.getByTestId('adapt').uncheck();
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    await expect
      .poll(() => page.getByTestId('live-counter').textContent(), { timeout: 30_000 })
      .toMatch(/%\s+of the FLOPs of watching every frame[\s\S]*Delay, camera to screen\s*\d/);

    await page.getByTestId('keep-picture').check();
    await page.getByTestId('record').click();
    await page.waitForTimeout(2500);
    await page.getByTestId('stop-recording').click();
    await whenReady(page);
    // It plays, and lasts as long as its poses do.
    const video = page.getByTestId('video');
    await expect.poll(() => video.evaluate((v) => (v as HTMLVideoElement).videoWidth)).toBe(640);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByTestId('save').click(),
    ]);
    const file = parsePoseFile(JSON.parse(await readFile(await download.path(), 'utf8')));
    expect(file.source.name).toMatch(/^recording-/);
    expect(file.frames.length).toBeGreaterThan(20);
    expect(file.frames.every((frame) => frame.keypoints3d !== null)).toBe(true);
    expect(file.interval).toBe(10);
    const duration = await video.evaluate((v) => (v as HTMLVideoElement).duration);
    expect(duration - file.source.duration).toBeGreaterThan(-0.2);
    expect(duration - file.source.duration).toBeLessThan(0.2);

    const origin = new URL(visit.site.url).origin;
    const foreign = requests.filter((url) => !/^(blob|data):/.test(url) && !url.startsWith(origin));
    expect(foreign).toEqual([]);
  });

  test('records the movement alone unless the picture is asked for', async () => {
    const { page } = await open(clip.args);
    await startCamera(page);
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    await page.getByTestId('adapt').uncheck();
    await page.getByTestId('record').click();
    await page.waitForTimeout(1500);
    await page.getByTestId('stop-recording').click();
    await whenReady(page);
    const sum = await page.getByTestId('video').evaluate(async (element) => {
      const video = element as HTMLVideoElement;
      const canvas = new OffscreenCanvas(8, 8);
      const context = canvas.getContext('2d')!;
      context.drawImage(video, 0, 0, 8, 8);
      return context.getImageData(0, 0, 8, 8).data.reduce((a, b, i) => a + (i % 4 < 3 ? b : 0), 0);
    });
    expect(sum).toBeLessThan(8 * 8 * 3 * 4);
    // Another N would need the picture.
    await page.getByTestId('every').fill('5');
    await expect.poll(() => page.getByTestId('note').textContent()).toMatch(/no picture/);
    expect(await page.getByTestId('every').inputValue()).toBe('10');
  });

  test('that is switched off, or unplugged, leaves the clip as it was', async () => {
    const { page } = await open(clip.args);
    await whenReady(page);
    await startCamera(page);
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    await page.getByTestId('every').fill('4');
    await page.getByTestId('stop-camera').click();
    await whenReady(page);
    // The controls say again what the clip's poses were made with.
    await expect.poll(() => page.getByTestId('every').inputValue()).toBe('10');
    await page.getByTestId('start-camera').click();
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    // So is a recording that is put away while it is being recovered.
    await page.getByTestId('record').click();
    await page.waitForTimeout(1500);
    await page.getByTestId('stop-recording').click();
    await page.getByTestId('stop-camera').click();
    await page.getByTestId('start-camera').click();
    await page.waitForTimeout(3000);
    expect(await page.getByTestId('error').count()).toBe(0);
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    // What is no video leaves the camera on.
    await page.getByTestId('open-file').setInputFiles({
      name: 'photo.jpg',
      mimeType: 'image/jpeg',
      buffer: Buffer.from('no video'),
    });
    expect(await page.getByTestId('error').textContent()).toMatch(/is not a video/);
    expect(await state(page)).toBe('following');
    const track = (run: string) =>
      page.getByTestId('camera').evaluate((element, code) => {
        const stream = (element as HTMLVideoElement).srcObject as MediaStream;
        return new Function('track', code)(stream.getVideoTracks()[0]);
      }, run);
    await expect.poll(() => state(page), { timeout: 90_000 }).toBe('following');
    await track(`window.track = track; track.dispatchEvent(new Event('ended'))`);
    expect(await page.getByTestId('error').textContent()).toMatch(/unplugged/);
    expect(await page.evaluate('window.track.readyState')).toBe('ended');
    await whenReady(page);
  });

  test.each([
    [
      'refused',
      ['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream=deny'],
      /refused: allow it/,
    ],
    ['not there', ['--use-fake-ui-for-media-stream'], /No camera was found/],
  ])('that is %s is told in words of its own', async (_, args, words) => {
    const { page } = await open(args);
    await startCamera(page);
    await expect.poll(() => page.getByTestId('error').textContent()).toMatch(words);
    expect(await page.evaluate(() => document.documentElement.dataset.state)).not.toBe('live');
  });

  test('asks for a secure page where it is none', async () => {
    const url = visit.site.url.replace(/127\.0\.0\.1|localhost/, INSECURE_HOST);
    const { page } = await open([`--host-resolver-rules=MAP ${INSECURE_HOST} 127.0.0.1`], url);
    await page.getByTestId('start-camera').click();
    await expect.poll(() => page.getByTestId('error').textContent()).toMatch(/over https/);
  });
});
