import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { type Browser, chromium, type Frame, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import { type CameraClip, makeCameraClip } from '../../web/cli/camera-clip.ts';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { MemoryProbe } from '../../web/cli/memory.ts';
import { PROJECT_ROOT } from '../../web/cli/site.ts';
import { embedding, type ForeignPage, type ForeignSite, servePages } from './pages.ts';
import { keepPlayerLog, playerLog } from './player-log.ts';
import { type ServedSite, serveBuiltSite } from './served-site.ts';

const FRAMES = 126;

/**
 * Code that V8 compiles faster and faster versions of counts as heap, and grows for minutes: without
 * those versions, what grows is what a page holds.
 */
const COMPILED_ONCE =
  '--js-flags=--no-opt --no-sparkplug --no-maglev --no-lazy-feedback-allocation';
const WALK = 'samples/walk.mp4';

let widget: ServedSite;
let browser: Browser;
const sites: ForeignSite[] = [];
const browsers: Browser[] = [];

async function launch(args: readonly string[] = []): Promise<Browser> {
  return chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS, ...args],
  });
}

beforeAll(async () => {
  widget = await serveBuiltSite();
  browser = await launch();
});
afterEach(async () => {
  for (const context of browser.contexts()) await context.close();
  for (const other of browsers.splice(0)) await other.close();
  for (const site of sites.splice(0)) await site.close();
});
afterAll(async () => {
  await browser?.close();
  await widget?.close();
});

async function openForeign(
  pages: Readonly<Record<string, ForeignPage>>,
  where: Browser = browser,
): Promise<Page> {
  const site = await servePages(pages);
  sites.push(site);
  const page = await where.newPage();
  await keepPlayerLog(page);
  await page.goto(site.url);
  return page;
}

/** The policy that docs/widget.md gives to those who embed the player, and nothing allowed beside it. */
async function documentedPolicy(): Promise<string> {
  const docs = await readFile(join(PROJECT_ROOT, 'docs/widget.md'), 'utf8');
  const [line] = /^script-src W .*$/m.exec(docs) ?? [];
  if (!line) throw new Error('docs/widget.md gives no policy.');
  const host = new URL(widget.url).origin;
  const policy = line.replace(/\b[WV]\b/g, host).replace(/ img-src \(.*\)/, '');
  return `default-src 'none'; ${policy}`;
}

const player = (attributes: string) =>
  `<deciwatch-player estimator="lite" muted ${attributes}></deciwatch-player>`;

async function whenPlayed(frame: Page | Frame): Promise<void> {
  await expect
    .poll(async () => (await playerLog(frame)).poses.length, { timeout: 120_000 })
    .toBe(FRAMES);
}

const everyFrame = Array.from({ length: FRAMES }, (_, frame) => frame);

describe('the widget on somebody else’s page', () => {
  test('plays every frame under the documented policy, without isolation', async () => {
    const html = embedding(
      widget.url,
      player(`src="${widget.url}${WALK}" every="10" autoplay controls`),
    );
    const policy = await documentedPolicy();
    const page = await openForeign({
      '/': { html, headers: { 'Content-Security-Policy': policy } },
    });
    const requests: string[] = [];
    page.on('request', (request) => requests.push(request.url()));
    await whenPlayed(page);
    const log = await playerLog(page);
    expect(log.poses).toEqual(everyFrame);
    expect(log.errors).toEqual([]);
    expect(log.complaints).toEqual([]);
    expect(log.isolated).toBe(false);
    // It is the policy that let it: another worker is refused.
    const refused = await page.evaluate(() => {
      try {
        new Worker('/own-worker.js');
      } catch {
        // Some versions throw, some tell of it later.
      }
      return new Promise<string>((resolve) => {
        document.addEventListener('securitypolicyviolation', (event) =>
          resolve(event.violatedDirective),
        );
      });
    });
    expect(refused).toMatch(/worker-src/);
    const hosts = new Set([new URL(widget.url).origin, new URL(page.url()).origin]);
    expect(
      requests.filter((url) => !/^(blob|data):/.test(url) && !hosts.has(new URL(url).origin)),
    ).toEqual([]);
  });

  test('plays every frame in a frame of yet another host', async () => {
    const inner = await servePages({
      '/': {
        html: embedding(widget.url, player(`src="${widget.url}${WALK}" autoplay view="overlay"`)),
      },
    });
    sites.push(inner);
    const html = `<!doctype html><title>Outer</title><iframe allow="autoplay" width="800" height="600" src="${inner.url}"></iframe>`;
    const page = await openForeign({ '/': { html } });
    const frame = page.frames().find((one) => one.url() === inner.url)!;
    await whenPlayed(frame);
    const log = await playerLog(frame);
    expect(log.poses).toEqual(everyFrame);
    expect([...log.errors, ...log.complaints]).toEqual([]);
  });

  test('is loaded twice, beside an import map and another three of the page’s own', async () => {
    const page = await browser.newPage();
    await keepPlayerLog(page);
    await page.goto(`${widget.url}examples/importmap.html`);
    await page.evaluate(() => {
      const one = document.querySelector('deciwatch-player')!;
      one.estimator = 'lite';
      return one.play();
    });
    await whenPlayed(page);
    expect(await page.locator('#own').textContent()).toMatch(/^three \d+, 5$/);
    const log = await playerLog(page);
    expect([...log.errors, ...log.complaints]).toEqual([]);
    expect(await page.locator('deciwatch-player dw-stage-view canvas').count()).toBe(1);
  });

  test('mounted, played and taken away twenty times, leaves nothing behind', async () => {
    const other = await launch([COMPILED_ONCE]);
    browsers.push(other);
    const page = await openForeign({ '/': { html: embedding(widget.url, '') } }, other);
    const probe = await MemoryProbe.attach(page);
    const round = () =>
      page.evaluate(async (src) => {
        const one = document.createElement('deciwatch-player');
        Object.assign(one, { src, estimator: 'lite', muted: true, loop: true, controls: true });
        document.querySelector('main')!.append(one);
        await one.play();
        await new Promise((resolve) => setTimeout(resolve, 2000));
        const told = one.clip !== null && !one.paused;
        one.remove();
        return told;
      }, widget.url + WALK);
    // What is made once for the page is there after the first rounds.
    for (let i = 0; i < 4; i++) expect(await round()).toBe(true);
    await expect.poll(() => probe.workers).toBe(0);
    const before = await probe.measure();
    for (let i = 4; i < 20; i++) expect(await round()).toBe(true);
    await expect.poll(() => probe.workers).toBe(0);
    const after = await probe.measure();
    expect(page.workers()).toHaveLength(0);
    expect(after.openFrames).toBe(0);
    expect(after.heap / before.heap).toBeLessThan(1.05);
    expect((await playerLog(page)).errors).toEqual([]);
  }, 600_000);
});

describe('the camera on somebody else’s page', () => {
  let clip: CameraClip;
  beforeAll(async () => {
    clip = await makeCameraClip('public/samples/walk.mp4');
  });
  afterAll(() => clip?.remove());

  async function framed(args: readonly string[]): Promise<{ page: Page; frame: Frame }> {
    const other = await launch(args);
    browsers.push(other);
    const inner = await servePages({
      '/': { html: embedding(widget.url, player('camera mirror view="overlay"')) },
    });
    sites.push(inner);
    const html = `<!doctype html><title>Outer</title><iframe allow="camera" width="800" height="600" src="${inner.url}"></iframe>`;
    const page = await openForeign({ '/': { html } }, other);
    const frame = page.frames().find((one) => one.url() === inner.url)!;
    await frame
      .locator('deciwatch-player')
      .getByRole('button', { name: 'Start the camera' })
      .click();
    return { page, frame };
  }

  test('is followed in a frame that may use it', async () => {
    const { frame } = await framed(clip.args);
    await expect
      .poll(async () => (await playerLog(frame)).poses.length, { timeout: 90_000 })
      .toBeGreaterThan(30);
    expect((await playerLog(frame)).errors).toEqual([]);
    await frame.evaluate(() => document.querySelector('deciwatch-player')!.remove());
  });

  test('refused: one error, and a sentence in the player', async () => {
    const { frame } = await framed([
      '--use-fake-device-for-media-stream',
      '--use-fake-ui-for-media-stream=deny',
    ]);
    await expect.poll(async () => (await playerLog(frame)).errors.length).toBe(1);
    const { errors, complaints } = await playerLog(frame);
    expect(errors[0]).toMatchObject({ type: 'camera-refused', fatal: true });
    expect(complaints).toEqual([]);
    await frame.locator('deciwatch-player').getByText(errors[0]!.message).waitFor();
  });
});
