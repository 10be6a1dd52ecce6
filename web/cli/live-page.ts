import { type Browser, chromium, type Page } from 'playwright-core';
import type { LiveReport } from '../cost/live-meter.ts';
import type { LiveMode, LoadPolicy } from '../engine/live/types.ts';
import { type CameraClip, makeCameraClip } from './camera-clip.ts';
import { CHROMIUM_ARGS, findChromium } from './chromium.ts';
import { buildAndServe, type Site } from './site.ts';

const SAMPLE = 'public/samples/walk.mp4';

/** What somebody would choose on the page. */
export interface LiveChoice {
  readonly every: number;
  readonly estimator: string;
  readonly mode: LiveMode;
  readonly load?: LoadPolicy;
}

/** Counts since the camera was started, and the running figures. */
export interface LiveSnapshot {
  readonly totals: {
    readonly frames: number;
    readonly missed: number;
    readonly calls: number;
    readonly shown: number;
  };
  readonly report: LiveReport;
  readonly every: number;
  readonly longTasks: readonly number[];
}

/** The demo page as it is shipped, in a headless browser whose camera plays a clip of a person. */
export class LivePage {
  private constructor(
    private readonly site: Site,
    private readonly clip: CameraClip,
    readonly browser: Browser,
    readonly page: Page,
  ) {}

  /** @param clip a video file; else the bundled sample */
  static async start(clip = SAMPLE, args: readonly string[] = []): Promise<LivePage> {
    const executablePath = await findChromium();
    const camera = await makeCameraClip(clip);
    let site: Site | undefined;
    let browser: Browser | undefined;
    try {
      site = await buildAndServe('index.html');
      browser = await chromium.launch({
        executablePath,
        args: [...CHROMIUM_ARGS, ...camera.args, ...args],
      });
      return new LivePage(site, camera, browser, await openPage(browser, site));
    } catch (error) {
      // What stays open would keep the command from ending.
      await browser?.close();
      await site?.close();
      await camera.remove();
      throw error;
    }
  }

  /** Starts the camera, and waits until somebody is followed. */
  async follow({ every, estimator, mode, load = 'skip' }: LiveChoice): Promise<void> {
    const { page } = this;
    await page.getByTestId(`estimator-${estimator}`).check({ force: true });
    await page.getByTestId('every').fill(String(every));
    await page.waitForSelector('html[data-state="ready"]', { timeout: 120_000 });
    await page.getByTestId('start-camera').click();
    await page.getByTestId(`mode-${mode}`).check({ force: true });
    await page.getByTestId('adapt').setChecked(load === 'adapt');
    await page.waitForSelector('[data-testid="live-state"][data-state="following"]', {
      timeout: 120_000,
    });
  }

  async stop(): Promise<void> {
    await this.page.getByTestId('stop-camera').click();
  }

  async wait(seconds: number): Promise<void> {
    await this.page.waitForTimeout(1000 * seconds);
  }

  snapshot(): Promise<LiveSnapshot> {
    return this.page.evaluate(() => {
      const session = document.querySelector('deciwatch-app')!.liveSession!;
      const { longTasks } = window as unknown as { longTasks: number[] };
      return {
        totals: { ...session.totals },
        report: session.report,
        every: session.status.every,
        longTasks: longTasks.splice(0),
      };
    });
  }

  async close(): Promise<void> {
    await this.browser.close();
    await this.site.close();
    await this.clip.remove();
  }
}

/** The page once its sample has been recovered. */
async function openPage(browser: Browser, site: Site): Promise<Page> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  const page = await context.newPage();
  await page.addInitScript(() => {
    const tasks: number[] = [];
    new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) tasks.push(duration);
    }).observe({ type: 'longtask', buffered: true });
    Object.assign(window, { longTasks: tasks });
  });
  await page.goto(site.url);
  await page.waitForSelector('html[data-state="ready"]', { timeout: 120_000 });
  return page;
}
