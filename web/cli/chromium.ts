import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';

const INSTALLED_NAMES = ['google-chrome', 'google-chrome-stable', 'chromium', 'chromium-browser'];
const INSTALLED_PATHS = [
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
];

/** Quiet, deterministic, and able to run as root in a container; web security stays on. */
export const CHROMIUM_ARGS: readonly string[] = [
  '--no-sandbox',
  '--disable-dev-shm-usage',
  '--disable-background-networking',
  '--disable-component-update',
  '--enable-unsafe-swiftshader',
];

/**
 * The browser that headless commands and tests drive: `CHROMIUM` from the environment, else an
 * installed Chrome or Chromium, else the one inside the npm package `@sparticuz/chromium`, which
 * unpacks itself into the system's temporary folder.
 */
export async function findChromium(): Promise<string> {
  const named = process.env.CHROMIUM;
  if (named) {
    if (!existsSync(named)) {
      throw new Error(`CHROMIUM names ${named}, which does not exist: point it at a browser.`);
    }
    return named;
  }
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  const candidates = [
    ...folders.flatMap((folder) => INSTALLED_NAMES.map((name) => join(folder, name))),
    ...INSTALLED_PATHS,
  ];
  const installed = candidates.find((path) => existsSync(path));
  if (installed) return installed;
  if (process.platform !== 'linux' || process.arch !== 'x64') {
    throw new Error(
      'No Chrome or Chromium was found: install one, or name it in the environment variable CHROMIUM.',
    );
  }
  // Its own launch arguments switch web security off, so only the path is taken from it.
  const { default: bundled } = await import('@sparticuz/chromium');
  return bundled.executablePath();
}
