import { execFile } from 'node:child_process';
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { type Browser, chromium } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { PROJECT_ROOT, type Site } from '../../web/cli/site.ts';
import { buildProject, freshViteProject, packedPackage, plainPage, viteProject } from './packed.ts';

const run = promisify(execFile);

const WALK = { 'walk.mp4': join(PROJECT_ROOT, 'public/samples/walk.mp4') };

/** Recovers the clip that lies beside the page, and leaves what came of it in the page's title. */
const recoverFrom = (library: string) => `
import { createEngine, mpjpe } from '${library}';
const engine = createEngine();
try {
  const clip = await (await fetch('walk.mp4')).blob();
  const { poses2d, poses3d, cost, estimator } = await engine.recover(clip, 'walk.mp4', { every: 10, estimator: 'lite' });
  const joints = poses3d.skeleton.joints.length;
  document.title = JSON.stringify({
    frames: poses2d.times.length,
    calls: cost.estimatorCalls,
    estimator: estimator.name,
    complete: poses3d.values.every(Number.isFinite) && poses2d.values.every(Number.isFinite),
    error: mpjpe(poses3d.values, poses3d.values, { joints, dims: 3 }),
  });
} catch (error) {
  document.title = JSON.stringify({ failure: String(error) });
}
engine.close();
`;

let browser: Browser;

beforeAll(async () => {
  browser = await chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS],
  });
  await packedPackage();
});
afterAll(() => browser?.close());

/** What the page says in the end, and what it asked for that was not there or not its own. */
async function outcome(site: Site) {
  const page = await browser.newPage();
  const complaints: string[] = [];
  const origin = new URL(site.url).origin;
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.context().on('response', (response) => {
    const url = new URL(response.url());
    const isOwn = url.origin === origin || ['blob:', 'data:'].includes(url.protocol);
    if ((!response.ok() || !isOwn) && url.pathname !== '/favicon.ico') {
      complaints.push(`${response.status()} ${url.href}`);
    }
  });
  try {
    await page.goto(site.url);
    await page.waitForFunction(() => document.title.startsWith('{'), undefined, {
      timeout: 150_000,
    });
    return { ...JSON.parse(await page.title()), complaints };
  } finally {
    await page.close();
    await site.close();
  }
}

const RECOVERED = {
  frames: 180,
  calls: 19,
  estimator: 'lite',
  complete: true,
  error: 0,
  complaints: [],
};

describe('the package recovers a clip', () => {
  test('in a new Vite project, built', async () => {
    const page = { script: recoverFrom('deciwatch-web'), files: WALK };
    expect(await outcome(await freshViteProject(page, 'build'))).toEqual(RECOVERED);
  });

  test("in a new Vite project, on Vite's development server", async () => {
    const page = { script: recoverFrom('deciwatch-web'), files: WALK };
    expect(await outcome(await freshViteProject(page, 'dev'))).toEqual(RECOVERED);
  });

  test('in a page without a bundler', async () => {
    const script = recoverFrom('./node_modules/deciwatch-web/lib/index.js');
    expect(await outcome(await plainPage({ script, files: WALK }))).toEqual(RECOVERED);
  });
});
