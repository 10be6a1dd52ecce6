/**
 * Renders and estimates clips for `python -m deciwatch pairs`, in headless Chromium.
 *
 * `tsx export/render/drive.ts AVATARS_FOLDER JOBS_FOLDER`, then one job's name on a line of standard
 * input at a time. For each, JOBS_FOLDER/NAME.json and NAME.bin are read (`job.ts`), NAME.answer.json
 * is written, and `done NAME` is printed. Ends when its input does.
 */
import { rename, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { chromium, type Page } from 'playwright-core';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { buildAndServe } from '../../web/cli/site.ts';
import type {} from './page.ts';

const PAGE = 'export/render/index.html';

async function openPage(site: string, avatars: string, jobs: string): Promise<Page> {
  const executablePath = await findChromium();
  const browser = await chromium.launch({ executablePath, args: [...CHROMIUM_ARGS] });
  const page = await browser.newPage();
  const serve = (prefix: string, folder: string) =>
    page.route(`**/${prefix}/**`, (route) => {
      const name = new URL(route.request().url()).pathname.split(`/${prefix}/`)[1] ?? '';
      return route.fulfill({ path: join(folder, name) });
    });
  await serve('avatars', avatars);
  await serve('jobs', jobs);
  page.on('pageerror', (error) => process.stderr.write(`${error.message}\n`));
  await page.goto(new URL(PAGE, site).href);
  await page.waitForFunction(() => window.renderClip !== undefined);
  return page;
}

async function main(): Promise<void> {
  const [avatars, jobs] = process.argv.slice(2);
  if (!avatars || !jobs) throw new Error('usage: drive.ts AVATARS_FOLDER JOBS_FOLDER');
  const site = await buildAndServe(PAGE);
  const page = await openPage(site.url, avatars, jobs);
  process.stdout.write('ready\n');
  try {
    for await (const name of createInterface({ input: process.stdin })) {
      const answer = await page.evaluate((url) => window.renderClip!(url), `/jobs/${name}.json`);
      const target = join(jobs, `${name}.answer.json`);
      await writeFile(`${target}.part`, JSON.stringify(answer));
      await rename(`${target}.part`, target);
      process.stdout.write(`done ${name}\n`);
    }
  } finally {
    await page.context().browser()?.close();
    await site.close();
  }
}

await main();
