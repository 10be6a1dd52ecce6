import type { Browser } from 'playwright-core';

/** CPU seconds spent so far by all processes of a Chromium: page, worker, GPU and browser. */
export async function chromiumCpuSeconds(browser: Browser): Promise<number> {
  const session = await browser.newBrowserCDPSession();
  try {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    return processInfo.reduce((sum, process) => sum + process.cpuTime, 0);
  } finally {
    await session.detach();
  }
}
