import { type Browser, chromium, type Page, type Request } from 'playwright-core';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { buildAndServe, type Site } from '../../web/cli/site.ts';

/** A name that the site answers to, and that no browser takes for a secure one. */
export const INSECURE_HOST = 'insecure.test';

/** The built demo and a browser to visit it with. */
export class Visit {
  private constructor(
    readonly site: Site,
    readonly browser: Browser,
  ) {}

  static async start(): Promise<Visit> {
    const site = await buildAndServe('index.html', [INSECURE_HOST]);
    const browser = await chromium.launch({
      executablePath: await findChromium(),
      args: [...CHROMIUM_ARGS],
    });
    return new Visit(site, browser);
  }

  /** A page on the demo, in a context of its own, with every request that it makes. */
  async open(
    prepare?: (page: Page) => Promise<unknown>,
  ): Promise<{ page: Page; requests: Request[] }> {
    const context = await this.browser.newContext({ viewport: { width: 1280, height: 900 } });
    const page = await context.newPage();
    const requests: Request[] = [];
    context.on('request', (request) => requests.push(request));
    await prepare?.(page);
    await page.goto(this.site.url);
    return { page, requests };
  }

  async close(): Promise<void> {
    await this.browser.close();
    await this.site.close();
  }
}

/** Waits until the page has a result for a clip, by its own word. */
export async function whenReady(page: Page): Promise<void> {
  await page.waitForSelector('html[data-state="ready"]', { timeout: 120_000 });
}
