import { rmSync } from 'node:fs';
import { mkdtemp } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { build, type InlineConfig, preview, type Rolldown } from 'vite';
import { type Bundle, describeBundle } from './build/bundle.ts';

export const PROJECT_ROOT = resolve(import.meta.dirname, '../..');

/** A built page being served on this machine. */
export interface Site {
  /** Ends in a slash. */
  readonly url: string;
  close(): Promise<void>;
}

/** Under a test runner, which says so in NODE_ENV, Vite would make a development build. */
async function buildAsShipped(config: InlineConfig): ReturnType<typeof build> {
  const { NODE_ENV } = process.env;
  process.env.NODE_ENV = 'production';
  try {
    return await build(config);
  } finally {
    if (NODE_ENV === undefined) delete process.env.NODE_ENV;
    else process.env.NODE_ENV = NODE_ENV;
  }
}

/** Builds the whole site into a folder, which is emptied first: the demo, the widget, the models. */
export async function buildSite(outDir: string): Promise<Bundle> {
  const built = await buildAsShipped({
    root: PROJECT_ROOT,
    logLevel: 'warn',
    build: { outDir, emptyOutDir: true },
  });
  return describeBundle((built as Rolldown.RolldownOutput).output);
}

/**
 * Builds a page of the project as it is shipped and serves it on a free port of the loopback
 * address. `page` is relative to the project's root; the build lives in a temporary folder.
 * @param allowedHosts names beside localhost that it answers to
 */
export async function buildAndServe(page: string, allowedHosts: string[] = []): Promise<Site> {
  const outDir = await mkdtemp(join(tmpdir(), 'deciwatch-site-'));
  const remove = () => rmSync(outDir, { recursive: true, force: true });
  // Interrupted, a command ends without closing what it opened.
  process.once('exit', remove);
  try {
    await buildAsShipped({
      root: PROJECT_ROOT,
      logLevel: 'error',
      build: { outDir, emptyOutDir: true, rollupOptions: { input: join(PROJECT_ROOT, page) } },
    });
    const server = await preview({
      root: PROJECT_ROOT,
      logLevel: 'error',
      build: { outDir },
      preview: { host: '127.0.0.1', port: 0, strictPort: false, open: false, allowedHosts },
    });
    const url = server.resolvedUrls?.local[0];
    if (!url) throw new Error('The built page could not be served on 127.0.0.1.');
    return {
      url,
      async close() {
        await server.close();
        remove();
        process.off('exit', remove);
      },
    };
  } catch (error) {
    remove();
    throw error;
  }
}
