import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { PROJECT_ROOT } from '../../web/cli/site.ts';
import { type PoseFile, parsePoseFile } from '../../web/formats/pose-file.ts';
import { Visit, whenReady } from './site.ts';

const fixture = (name: string) => join(PROJECT_ROOT, 'tests/fixtures', name);

let visit: Visit;
const pages: Page[] = [];

async function open(prepare?: (page: Page) => Promise<unknown>) {
  const opened = await visit.open(prepare);
  pages.push(opened.page);
  return opened;
}

async function save(page: Page): Promise<PoseFile> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId('save').click(),
  ]);
  return parsePoseFile(JSON.parse(await readFile(await download.path(), 'utf8')));
}

beforeAll(async () => {
  visit = await Visit.start();
});
afterEach(async () => {
  for (const page of pages.splice(0)) await page.context().close();
});
afterAll(() => visit?.close());

describe('the built demo', () => {
  test('recovers the sample, plays it and saves it, without leaving its origin', async () => {
    const { page, requests } = await open();
    const complaints: string[] = [];
    page.on('pageerror', (error) => complaints.push(String(error)));
    await whenReady(page);

    const file = await save(page);
    const last = file.frames.length - 1;
    const watched = file.frames.filter((frame) => frame.watched).map((frame) => frame.index);
    const expected = file.frames.map((f) => f.index).filter((i) => i % 10 === 0 || i === last);
    expect(watched).toEqual(expected);
    expect(file.frames.every((f) => f.keypoints2d && f.keypoints3d)).toBe(true);
    expect(file.cost.estimatorCalls).toBe(watched.length);

    // Space starts and stops the video wherever the focus is not on a control of its own.
    const time = () =>
      page.getByTestId('video').evaluate((v) => (v as HTMLVideoElement).currentTime);
    const paused = () => page.getByTestId('video').evaluate((v) => (v as HTMLVideoElement).paused);
    if (await paused()) await page.getByTestId('play').click();
    const before = await time();
    await expect.poll(time).not.toBe(before);
    await page.getByTestId('play').click();
    expect(await paused()).toBe(true);

    const origin = new URL(visit.site.url).origin;
    const foreign = requests
      .map((request) => request.url())
      .filter((url) => !/^(blob|data):/.test(url) && new URL(url).origin !== origin);
    expect(foreign).toEqual([]);
    // The worker's requests are among them, or the line above would prove little.
    expect(requests.some((request) => request.url().includes('pose_landmarker_full.task?'))).toBe(
      true,
    );
    const stored = await page.evaluate(async () => ({
      local: localStorage.length,
      session: sessionStorage.length,
      cookies: document.cookie,
      databases: (await indexedDB.databases()).length,
      caches: (await caches.keys()).length,
      workers: (await navigator.serviceWorker.getRegistrations()).length,
    }));
    expect(stored).toEqual({
      local: 0,
      session: 0,
      cookies: '',
      databases: 0,
      caches: 0,
      workers: 0,
    });
    expect(requests.some((request) => request.url().includes('heavy'))).toBe(false);
    expect(complaints).toEqual([]);
  });

  test('says what is wrong with a corrupt file and keeps the clip that was there', async () => {
    const { page } = await open();
    await whenReady(page);
    const frames = await page.evaluate(() => document.documentElement.dataset.frames);
    await page.getByTestId('open-file').setInputFiles(fixture('corrupt.mp4'));
    await expect.poll(() => page.getByTestId('error').innerText()).toMatch(/corrupt\.mp4.*\./s);
    expect(await page.evaluate(() => document.documentElement.dataset.frames)).toBe(frames);
    expect((await save(page)).source.name).toBe('walk.mp4');
  });

  test('says so when nobody is in view', async () => {
    const { page } = await open();
    await whenReady(page);
    await page.getByTestId('open-file').setInputFiles(fixture('empty-room.mp4'));
    await expect
      .poll(() => page.getByTestId('error').innerText())
      .toMatch(/nobody|no one|no person/i);
  });

  test('a file, another N and stepping through frames, by keyboard alone', async () => {
    const { page } = await open();
    await whenReady(page);
    await page.getByTestId('every').focus();
    for (let press = 0; press < 5; press += 1) await page.keyboard.press('ArrowLeft');
    await expect
      .poll(async () => (await page.evaluate(() => document.documentElement.dataset.every)) ?? '', {
        timeout: 120_000,
      })
      .toBe('5');
    await whenReady(page);
    const timeline = page.getByTestId('timeline').locator('input[type=range]');
    await timeline.focus();
    await page.keyboard.press('Home');
    await page.keyboard.press('ArrowRight');
    await expect.poll(() => timeline.getAttribute('aria-valuetext')).toMatch(/frame 2 of/i);
    expect((await save(page)).interval).toBe(5);
  });

  test('goes on without the 3D view when WebGL is refused, and says so', async () => {
    const { page } = await open((fresh) =>
      fresh.addInitScript(() => {
        const original = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (
          this: HTMLCanvasElement,
          ...args: Parameters<typeof original>
        ) {
          return args[0].startsWith('webgl') ? null : original.apply(this, args);
        } as typeof original;
      }),
    );
    await whenReady(page);
    await page.getByTestId('stage').getByText(/WebGL/).waitFor();
    expect((await save(page)).frames.length).toBeGreaterThan(0);
  });

  test('says so when the 3D view is lost, and brings it back', async () => {
    const { page } = await open();
    await whenReady(page);
    const message = page.getByTestId('stage').getByText(/3D view/);
    const lose = await page
      .getByTestId('stage')
      .locator('canvas')
      .evaluateHandle((canvas: HTMLCanvasElement) =>
        canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context'),
      );
    await lose.evaluate((extension) => extension!.loseContext());
    await message.waitFor();
    await lose.evaluate((extension) => extension!.restoreContext());
    await message.waitFor({ state: 'hidden' });
  });

  test('a cancelled job leaves the poses and the settings that were there', async () => {
    const { page } = await open();
    await whenReady(page);
    await page.getByTestId('estimator-lite').click();
    await page.getByTestId('cancel').click();
    await whenReady(page);
    expect((await save(page)).estimator.name).toBe('full');
    await expect
      .poll(() =>
        page.getByTestId('estimator-full').evaluate((e) => (e as HTMLInputElement).checked),
      )
      .toBe(true);
  });

  test('says which model is missing when it cannot be had', async () => {
    const { page } = await open((fresh) =>
      fresh.route('**/*.task?*', (route) => route.fulfill({ status: 404, body: 'gone' })),
    );
    await expect
      .poll(() => page.getByTestId('error').innerText(), { timeout: 60_000 })
      .toMatch(/pose_landmarker_full/);
  });

  test('fits a phone without scrolling sideways', async () => {
    const { page } = await open((fresh) => fresh.setViewportSize({ width: 375, height: 812 }));
    await whenReady(page);
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBeLessThanOrEqual(0);
  });
});
