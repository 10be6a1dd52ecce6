import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { whenReady } from './site.ts';
import { type Served, serveFolder } from './static-server.ts';
import { buildWholeSite, type WholeSite } from './whole-site.ts';

const SLOW = { timeout: 90_000 };

let site: WholeSite;
let browser: Browser;
let served: Served;
let context: BrowserContext;
/** Answered with this instead of the file, where a test says so. */
let refused: (path: string) => number | undefined;

async function open(): Promise<Page> {
  const page = await context.newPage();
  await page.goto(served.url);
  await whenReady(page);
  return page;
}

const state = (page: Page) => page.getByTestId('offline').getAttribute('data-state');
const words = (page: Page) => page.getByTestId('offline').innerText();
const spoken = (page: Page) => page.getByTestId('offline-status').textContent();

async function keep(page: Page): Promise<void> {
  await page.getByTestId('keep-offline').click();
  await expect.poll(() => state(page), SLOW).toBe('kept');
}

/** What the browser stores of the page. */
function stored(page: Page) {
  return page.evaluate(async () => ({
    caches: await caches.keys(),
    workers: (await navigator.serviceWorker.getRegistrations()).length,
  }));
}

/** The release that is kept, by the list in its cache. */
function keptRelease(page: Page) {
  return page.evaluate(async () => {
    const list = await caches.match(new URL('offline.json', location.href));
    return list ? String((await list.json()).release) : '';
  });
}

const NOTHING = { caches: [], workers: 0 };

beforeAll(async () => {
  site = await buildWholeSite();
  browser = await chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS],
  });
});
beforeEach(async () => {
  refused = () => undefined;
  served = await serveFolder(site.folder, { refuse: (path) => refused(path) });
  context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
});
afterEach(async () => {
  await context.close();
  await served.close();
});
afterAll(async () => {
  await browser?.close();
  await site?.remove();
});

// Each recovers the sample several times.
describe('keeping the page for offline use', { timeout: 400_000 }, () => {
  test('happens when asked for, works without a server, keeps what is used later, and is undone', async () => {
    const page = await open();
    await expect.poll(() => words(page)).toMatch(/Keep it \(\d+\.\d\sMB\)/);
    expect(await stored(page)).toEqual(NOTHING);

    await page.getByTestId('keep-offline').focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => state(page), SLOW).toBe('kept');
    expect(await spoken(page)).toMatch(/ready for offline use/);
    expect(await words(page)).toMatch(/with the full estimator\s/);
    expect((await stored(page)).workers).toBe(1);
    // Whoever works by keyboard stays where they were.
    expect(await page.getByTestId('remove-offline').evaluate((e) => e.matches(':focus'))).toBe(
      true,
    );

    // Another estimator comes into use, and is kept as well.
    await page.getByTestId('estimator-lite').check({ force: true });
    await expect.poll(() => words(page), SLOW).toMatch(/lite and full estimators/);
    const port = Number(new URL(served.url).port);
    await page.close();
    await served.close();

    const offline = await open();
    await expect.poll(() => state(offline)).toBe('kept');
    await offline.getByTestId('stage').locator('canvas').waitFor();
    await offline.getByTestId('estimator-lite').check({ force: true });
    await expect
      .poll(() => offline.evaluate(() => document.documentElement.dataset.state), SLOW)
      .toBe('ready');
    expect(await offline.getByTestId('error').count()).toBe(0);
    await offline.goto(`${served.url}index.html?from=a-bookmark`);
    await whenReady(offline);

    served = await serveFolder(site.folder, { port });
    await offline.getByTestId('remove-offline').click();
    await expect.poll(() => state(offline), SLOW).toBe('offered');
    expect(await spoken(offline)).toMatch(/nothing of this page is stored/);
    expect(await stored(offline)).toEqual(NOTHING);
  });

  test('a newer release takes the place of the one that is kept', async () => {
    const page = await open();
    await keep(page);
    const before = await keptRelease(page);
    // A slow device and connection, and a page that always just looks at what it keeps: it is kept all the same.
    await page.addInitScript(() => {
      const { keys } = CacheStorage.prototype;
      CacheStorage.prototype.keys = async function (this: CacheStorage) {
        return new Promise<void>((resolve) => setTimeout(resolve, 100)).then(() => keys.call(this));
      };
      const { fetch } = window;
      window.fetch = async (input, init) => {
        if (String(input).includes('offline.json')) {
          await new Promise((resolve) => setTimeout(resolve, 1000));
        }
        return fetch(input, init);
      };
      document.addEventListener('DOMContentLoaded', () => {
        setInterval(() => {
          document.documentElement.dataset.estimator ??= 'full';
          document.documentElement.dataset.estimator += '';
        }, 20);
      });
    });
    const index = join(site.folder, 'index.html');
    const list = join(site.folder, 'offline.json');
    const [oldIndex, oldList] = await Promise.all([readFile(index), readFile(list, 'utf8')]);
    try {
      // A file that has changed, and a list that knows it.
      await writeFile(index, `${oldIndex}<!-- newer -->`);
      const bytes = await readFile(index);
      const release = JSON.parse(oldList);
      release.release = '0123456789abcdef';
      release.files[0].bytes = bytes.length;
      release.files[0].sha256 = createHash('sha256').update(bytes).digest('hex');
      await writeFile(list, JSON.stringify(release));
      served.requests.splice(0);
      await page.reload();
      await expect.poll(() => keptRelease(page), SLOW).toBe('0123456789abcdef');
      expect(await page.getByTestId('offline-failure').count()).toBe(0);
      expect(before).not.toBe('0123456789abcdef');
      await expect.poll(async () => (await stored(page)).caches.length).toBe(1);
      // What is the same in both is not fetched again.
      expect(served.requests.filter(({ path }) => /wasm|\.task|\.onnx/.test(path))).toEqual([]);
    } finally {
      await writeFile(index, oldIndex);
      await writeFile(list, oldList);
    }
  });

  test('says in one sentence that a file did not come, and keeps nothing', async () => {
    refused = (path) => (path.endsWith('3d-forecast.onnx') ? 503 : undefined);
    const page = await open();
    await page.getByTestId('keep-offline').click();
    await expect
      .poll(() => page.getByTestId('offline-failure').innerText(), SLOW)
      .toMatch(/Nothing was kept\. .*connection/);
    expect(await stored(page)).toEqual(NOTHING);

    refused = () => undefined;
    await keep(page);
  });

  test('says that there is no room before it fetches anything', async () => {
    const page = await open();
    const devtools = await context.newCDPSession(page);
    await devtools.send('Storage.overrideQuotaForOrigin', {
      origin: new URL(served.url).origin,
      quotaSize: 10e6,
    });
    await page.getByTestId('keep-offline').click();
    await expect
      .poll(() => page.getByTestId('offline-failure').innerText(), SLOW)
      .toMatch(/no room/);
    expect(await stored(page)).toEqual(NOTHING);
  });

  test('says that there is no room where the browser finds out on the way, and keeps nothing', async () => {
    const page = await open();
    await page.evaluate(() => {
      const put = Cache.prototype.put;
      Cache.prototype.put = function (this: Cache, request, response) {
        return String(request).includes('.wasm')
          ? Promise.reject(new DOMException('full', 'QuotaExceededError'))
          : put.call(this, request, response);
      };
    });
    await page.getByTestId('keep-offline').click();
    await expect
      .poll(() => page.getByTestId('offline-failure').innerText(), SLOW)
      .toMatch(/no room/);
    expect(await stored(page)).toEqual(NOTHING);
  });

  test('can be cancelled, and a tab that was closed half-way leaves nothing behind', async () => {
    // The last file never comes.
    await context.route('**/pose_landmarker_lite.task*', () => {});
    const page = await open();
    const start = async () => {
      await page.evaluate(() => {
        document.documentElement.dataset.estimator = 'lite';
      });
      await page.getByTestId('keep-offline').click();
      await expect.poll(async () => (await stored(page)).caches.length, SLOW).toBe(1);
    };
    await start();
    await page.getByTestId('cancel-offline').click();
    await expect.poll(() => state(page), SLOW).toBe('offered');
    expect(await page.getByTestId('offline-failure').count()).toBe(0);
    expect(await stored(page)).toEqual(NOTHING);

    await start();
    await page.close();
    const next = await open();
    await next.getByTestId('keep-offline').waitFor();
    await expect.poll(() => stored(next)).toEqual(NOTHING);
  });

  test('fits a phone', async () => {
    const page = await open();
    await page.setViewportSize({ width: 375, height: 812 });
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBeLessThanOrEqual(0);
  });
});
