import { type Browser, chromium, type Page } from 'playwright-core';
import type { RecoverProgress } from '../engine/types.ts';
import { DeciWatchError, type DeciWatchErrorCode } from '../errors.ts';
import type { EstimatorName } from '../estimators/names.ts';
import { CHROMIUM_ARGS, findChromium } from './chromium.ts';
import { buildAndServe, type Site } from './site.ts';

const PAGE = 'web/cli/headless.html';

export interface HeadlessOptions {
  readonly every: number;
  readonly estimator: EstimatorName;
  readonly onProgress?: (progress: RecoverProgress) => void;
}

/** The page's own engine, driven from Node in a headless browser. One clip at a time. */
export class HeadlessEngine {
  #onProgress: ((progress: RecoverProgress) => void) | undefined;
  #page: Page | undefined;

  private constructor(
    readonly browser: Browser,
    private readonly site: Site,
  ) {}

  /** Builds the page and starts the browser: some seconds. */
  static async start(): Promise<HeadlessEngine> {
    const executablePath = await findChromium();
    const site = await buildAndServe(PAGE);
    try {
      const browser = await chromium.launch({ executablePath, args: [...CHROMIUM_ARGS] });
      return new HeadlessEngine(browser, site);
    } catch (error) {
      await site.close();
      throw error;
    }
  }

  /**
   * Recovers one clip.
   * @returns the pose file's text (docs/pose-file.md).
   * @throws DeciWatchError with one sentence when the clip cannot be used.
   */
  async recover(path: string, options: HeadlessOptions): Promise<string> {
    const page = await this.#openPage();
    this.#onProgress = options.onProgress;
    try {
      await page.setInputFiles('#clip', path);
      const answer = await page.evaluate(
        ({ every, estimator }) => window.recoverChosenClip!(every, estimator),
        { every: options.every, estimator: options.estimator },
      );
      if (answer.ok) return answer.poseFile;
      throw new DeciWatchError(answer.code as DeciWatchErrorCode, answer.message);
    } catch (error) {
      if (error instanceof DeciWatchError) throw error;
      // The page is in an unknown state: the next clip gets a fresh one.
      this.#page = undefined;
      await page.close().catch(() => {});
      const detail = error instanceof Error ? error.message.split('\n')[0] : String(error);
      throw new DeciWatchError('engine-crashed', `The browser stopped on this clip: ${detail}`);
    } finally {
      this.#onProgress = undefined;
    }
  }

  async close(): Promise<void> {
    await this.browser.close();
    await this.site.close();
  }

  async #openPage(): Promise<Page> {
    if (this.#page) return this.#page;
    const page = await this.browser.newPage();
    await page.exposeFunction('reportProgress', (progress: RecoverProgress) =>
      this.#onProgress?.(progress),
    );
    await page.goto(new URL(PAGE, this.site.url).href);
    await page.waitForFunction(() => window.recoverChosenClip !== undefined);
    this.#page = page;
    return page;
  }
}
