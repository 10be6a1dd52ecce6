import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { type BrowserContext, chromium } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { whenReady } from './site.ts';
import { type Served, serveFolder } from './static-server.ts';
import { buildWholeSite, type WholeSite } from './whole-site.ts';

/** As docs/hosting.md gives it, for a page on the same host as the widget's files. */
const POLICY =
  "script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; connect-src 'self'; media-src 'self' blob:";

/** What has no digest in its address, and is asked for on every visit. */
const REVALIDATED = ['/', '/estimators/manifest.json', '/models/manifest.json', '/offline.json'];

let site: WholeSite;
let served: Served;
let profile: string;
let context: BrowserContext;

beforeAll(async () => {
  site = await buildWholeSite();
  // As `npm run build` leaves it, for one file.
  const worker = await readFile(join(site.folder, 'sw.js'));
  await writeFile(join(site.folder, 'sw.js.br'), brotliCompressSync(worker));
  served = await serveFolder(site.folder, {
    headers: (path) => (path === '/' ? { 'Content-Security-Policy': POLICY } : {}),
  });
  // A profile on disk: a browser without one caches nothing as large as the WebAssembly.
  profile = await mkdtemp(join(tmpdir(), 'deciwatch-profile-'));
  context = await chromium.launchPersistentContext(profile, {
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS],
  });
});
afterAll(async () => {
  await context?.close();
  await served?.close();
  await site?.remove();
  if (profile) await rm(profile, { recursive: true, force: true });
});

describe('the site on a host that was set up as documented', () => {
  test('works under the documented policy, and a second visit asks only for what may have changed', async () => {
    const first = await context.newPage();
    const complaints: string[] = [];
    first.on('console', (message) => {
      if (message.type() === 'error') complaints.push(message.text());
    });
    await first.goto(served.url);
    await whenReady(first);
    await first.getByTestId('offline').waitFor();
    expect(complaints).toEqual([]);
    expect(served.requests.some(({ path }) => path.startsWith('/assets/'))).toBe(true);
    expect(served.requests.some(({ path }) => path.includes('.task?'))).toBe(true);
    await first.close();

    served.requests.splice(0);
    const second = await context.newPage();
    await second.goto(served.url);
    await whenReady(second);
    await second.getByTestId('offline').waitFor();
    const asked = [...new Set(served.requests.map(({ path }) => path))].sort();
    expect(asked).toEqual(REVALIDATED);
    // And of these, nothing came again.
    expect(new Set(served.requests.map(({ status }) => status))).toEqual(new Set([304]));
    await second.close();
  });

  test.each([
    ['/widget.js', 'text/javascript', 'no-cache'],
    ['/sw.js', 'text/javascript', 'no-cache'],
    ['/models/manifest.json', 'application/json', 'no-cache'],
    ['/models/3d-denoise.onnx?0', 'application/octet-stream', 'immutable'],
    ['/estimators/pose_landmarker_lite.task?0', 'application/octet-stream', 'immutable'],
  ])('%s is %s, %s, and every origin’s', async (path, type, caching) => {
    const response = await fetch(new URL(path, served.url), { method: 'HEAD' });
    expect(response.status).toBe(200);
    expect(response.headers.get('content-type')).toBe(type);
    expect(response.headers.get('cache-control')).toContain(caching);
    expect(response.headers.get('access-control-allow-origin')).toBe('*');
  });

  test('loaders and WebAssembly have the types that browsers insist on', async () => {
    const list = JSON.parse(await readFile(join(site.folder, 'offline.json'), 'utf8'));
    const types = { mjs: 'text/javascript', wasm: 'application/wasm' };
    for (const [extension, type] of Object.entries(types)) {
      const { file } = list.files.find((entry: { file: string }) => entry.file.endsWith(extension));
      const response = await fetch(new URL(file, served.url), { method: 'HEAD' });
      expect(response.headers.get('content-type')).toBe(type);
      expect(response.headers.get('cache-control')).toContain('immutable');
    }
  });

  test('sends the compressed copy of a file to who can read it, and parts of others', async () => {
    const headers = { 'Accept-Encoding': 'br' };
    const body = await (await fetch(new URL('sw.js', served.url), { headers })).text();
    await expect.poll(() => served.requests.at(-1)?.encoding).toBe('br');
    expect(body).toBe(await readFile(join(site.folder, 'sw.js'), 'utf8'));
    const part = await fetch(new URL('samples/walk.mp4', served.url), {
      headers: { Range: 'bytes=4-7' },
    });
    expect([part.status, await part.text()]).toEqual([206, 'ftyp']);
  });
});
