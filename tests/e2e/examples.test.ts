import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, chromium, type Frame, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { type CameraClip, makeCameraClip } from '../../web/cli/camera-clip.ts';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { PROJECT_ROOT } from '../../web/cli/site.ts';
import { focused, seriousFindings, tabTo } from './accessibility.ts';
import { keepPlayerLog, playerLog } from './player-log.ts';
import { type ServedSite, serveBuiltSite } from './served-site.ts';
import { whenReady } from './site.ts';

const LONG = { timeout: 120_000 };

let site: ServedSite;
let clip: CameraClip;
let browser: Browser;

beforeAll(async () => {
  site = await serveBuiltSite();
  clip = await makeCameraClip('public/samples/walk.mp4');
  browser = await chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS, ...clip.args],
  });
});
afterEach(async () => {
  for (const context of browser.contexts()) await context.close();
});
afterAll(async () => {
  await browser?.close();
  await site?.close();
  await clip?.remove();
});

async function open(path: string, colorScheme: 'light' | 'dark' = 'light'): Promise<Page> {
  const page = await browser.newPage({ colorScheme, viewport: { width: 1280, height: 900 } });
  await keepPlayerLog(page);
  await page.goto(site.url + path);
  return page;
}

/** Plays as a visitor would, with the smallest estimator. */
async function play(where: Page | Frame, frames = 30): Promise<void> {
  await where.evaluate(() => {
    document.querySelector('deciwatch-player')!.estimator = 'lite';
  });
  await where.getByRole('button', { name: 'Play', exact: true }).first().click();
  await expect
    .poll(async () => (await playerLog(where)).poses.length, LONG)
    .toBeGreaterThan(frames);
}

const text = (page: Page, id: string) => page.locator(`#${id}`).textContent();

/** What a visitor does on each page, and what then is to be seen. */
const EXAMPLES: Readonly<Record<string, (page: Page) => Promise<void>>> = {
  'index.html': async (page) => {
    for (const link of await page.getByRole('link').all()) {
      const url = new URL((await link.getAttribute('href'))!, page.url());
      expect((await page.request.get(url.href)).status(), url.href).toBe(200);
    }
  },
  'widget.html': (page) => play(page),
  'csp.html': (page) => play(page),
  'importmap.html': async (page) => {
    await play(page);
    expect(await text(page, 'own')).toMatch(/^three \d+, 5$/);
  },
  'framed.html': (page) => play(page),
  'iframe.html': async (page) => play(page.frame({ url: /framed/ })!),
  'several.html': async (page) => {
    await page.evaluate(() => {
      for (const player of document.querySelectorAll('deciwatch-player')) player.estimator = 'lite';
    });
    for (const button of await page.getByRole('button', { name: 'Play', exact: true }).all()) {
      if (await button.isVisible()) await button.click();
    }
    await expect.poll(async () => (await playerLog(page)).loads, LONG).toBe(2);
    expect(page.workers()).toHaveLength(1);
  },
  'looks.html': async (page) => {
    await play(page);
    expect(await page.locator('output').textContent()).toBe('100');
  },
  'events.html': async (page) => {
    await play(page);
    expect(await text(page, 'frame')).toMatch(/^\d+, \d\.\d\d s, (watched|recovered)$/);
    expect(await text(page, 'knee')).toMatch(/^bent by \d+°$/);
    expect(await text(page, 'cost')).toMatch(/^1\d\.\d % of the FLOPs/);
    expect(await text(page, 'error')).toBe('none');
  },
  'camera.html': async (page) => {
    await page.evaluate(() => {
      document.querySelector('deciwatch-player')!.estimator = 'lite';
    });
    await page.getByRole('button', { name: 'Start the camera' }).first().click();
    await expect.poll(async () => (await playerLog(page)).poses.length, LONG).toBeGreaterThan(10);
  },
  'library.html': async (page) => {
    await page.getByRole('button').click();
    await expect
      .poll(() => text(page, 'result'), LONG)
      .toMatch(/^126 frames from 14 looks; the pose file has \d+/);
  },
  'recorded.html': async (page) => {
    await page.getByRole('button', { name: 'Recover' }).click();
    await expect
      .poll(() => text(page, 'result'), LONG)
      .toMatch(/^14 looks; \d+ mm from watching every frame\.$/);
  },
};

test('every example is opened here', () => {
  const pages = readdirSync(join(PROJECT_ROOT, 'examples')).filter((name) =>
    name.endsWith('.html'),
  );
  expect(Object.keys(EXAMPLES).sort()).toEqual(pages.sort());
});

describe.each(Object.entries(EXAMPLES))('examples/%s', (name, visit) => {
  test('does what it says, without complaint, and axe finds nothing serious', async () => {
    const page = await open(`examples/${name}`);
    expect(await seriousFindings(page)).toEqual([]);
    await visit(page);
    expect(await seriousFindings(page)).toEqual([]);
    for (const frame of page.frames()) {
      const log = await playerLog(frame);
      expect([...log.errors, ...log.complaints]).toEqual([]);
    }
  });
});

describe('for everybody', () => {
  test.each(['light', 'dark'] as const)(
    'axe finds nothing serious on the demo, %s',
    async (scheme) => {
      const page = await open('', scheme);
      expect(await seriousFindings(page)).toEqual([]);
      await whenReady(page);
      expect(await seriousFindings(page)).toEqual([]);
      await page.keyboard.press('?');
      await page.getByRole('dialog').waitFor();
      expect(await seriousFindings(page)).toEqual([]);
    },
  );

  test('axe finds nothing serious on a player in the dark, nor where it failed', async () => {
    const page = await open('examples/events.html', 'dark');
    await play(page);
    expect(await seriousFindings(page)).toEqual([]);
    await page.evaluate(() => {
      document.querySelector('deciwatch-player')!.src = 'nowhere.mp4';
    });
    await page.getByRole('alert').waitFor();
    expect(await seriousFindings(page)).toEqual([]);
  });

  test('the player can be used by keyboard alone, and the focus is always seen', async () => {
    const page = await open('examples/widget.html');
    await page.evaluate(() => {
      document.querySelector('deciwatch-player')!.estimator = 'lite';
    });
    const player = (name: 'paused' | 'currentTime' | 'view' | 'muted') =>
      page.evaluate((key) => document.querySelector('deciwatch-player')![key], name);
    const passed = await tabTo(page, 'Play');
    await page.keyboard.press('Enter');
    // The button has gone; the keyboard's place is at the bar's own.
    await expect.poll(async () => (await focused(page)).label).toBe('Pause');
    await expect.poll(async () => (await playerLog(page)).poses.length, LONG).toBeGreaterThan(5);

    // The slider: paused by going through it, one frame at a time.
    passed.push(...(await tabTo(page, 'Frame')));
    await page.keyboard.press('Home');
    await page.keyboard.press('ArrowRight');
    await expect.poll(() => player('currentTime')).toBeCloseTo(1 / 30, 2);
    expect(await player('paused')).toBe(true);
    passed.push(...(await tabTo(page, 'One frame on')));
    await page.keyboard.press('Space');
    await expect.poll(() => player('currentTime')).toBeCloseTo(2 / 30, 2);
    passed.push(...(await tabTo(page, '2D: the video with its skeleton')));
    await page.keyboard.press('Enter');
    expect(await player('view')).toBe('overlay');
    passed.push(...(await tabTo(page, 'Sound on')));
    await page.keyboard.press('Enter');
    expect(await player('muted')).toBe(false);
    // Anywhere in the player.
    await page.keyboard.press('k');
    await expect.poll(() => player('paused')).toBe(false);
    await page.keyboard.press('k');
    await page.keyboard.press('.');
    await expect.poll(() => player('paused')).toBe(true);
    expect(passed.filter(({ visible, tag }) => !visible && tag !== 'body')).toEqual([]);
  });

  test('without a bar of controls too', async () => {
    const page = await open('examples/looks.html');
    await page.evaluate(() => {
      document.querySelector('deciwatch-player')!.estimator = 'lite';
    });
    await tabTo(page, 'Play');
    await page.keyboard.press('Enter');
    await expect.poll(async () => (await playerLog(page)).poses.length, LONG).toBeGreaterThan(5);
    await tabTo(page, 'Pause');
    await page.keyboard.press('Enter');
    await expect
      .poll(() => page.evaluate(() => document.querySelector('deciwatch-player')!.paused))
      .toBe(true);
  });
});
