import { execFile } from 'node:child_process';
import { cp, readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { type Browser, chromium } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { CHROMIUM_ARGS, findChromium } from '../../web/cli/chromium.ts';
import { PROJECT_ROOT, type Site } from '../../web/cli/site.ts';
import {
  buildProject,
  exampleProject,
  freshViteProject,
  packedPackage,
  plainPage,
  viteProject,
} from './packed.ts';
import { keepPlayerLog, playerLog } from './player-log.ts';

const run = promisify(execFile);

const WALK = { 'walk.mp4': join(PROJECT_ROOT, 'public/samples/walk.mp4') };

/** Recovers the clip that lies beside the page, and leaves what came of it in the page's title. */
const recoverWith = (library: string) => `
import { createEngine } from '${library}';
const engine = createEngine();
try {
  const clip = await (await fetch('walk.mp4')).blob();
  const recovered = await engine.recover(clip, 'walk.mp4', { every: 10, estimator: 'lite' });
  const { poses2d, poses3d, cost, estimator } = recovered;
  document.title = JSON.stringify({
    frames: poses2d.times.length,
    calls: cost.estimatorCalls,
    estimator: estimator.name,
    complete: poses3d.values.every(Number.isFinite) && poses2d.values.every(Number.isFinite),
  });
} catch (error) {
  document.title = JSON.stringify({ failure: String(error) });
}
engine.close();
`;

/** The bundled clip: every frame has a pose, and the estimator saw 0, 10, … 120 and the last. */
const RECOVERED = { frames: 126, calls: 14, estimator: 'lite', complete: true, complaints: [] };

let browser: Browser;

beforeAll(async () => {
  browser = await chromium.launch({
    executablePath: await findChromium(),
    args: [...CHROMIUM_ARGS],
  });
  await packedPackage();
});
afterAll(() => browser?.close());

/** What a page says in the end, and what it asked for that was not there or not its own. */
async function outcome(site: Site) {
  const page = await browser.newPage();
  const complaints: string[] = [];
  const { origin } = new URL(site.url);
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.context().on('response', (response) => {
    const url = new URL(response.url());
    const isOwn = url.origin === origin || /^(blob|data):$/.test(url.protocol);
    if (url.pathname !== '/favicon.ico' && !(response.ok() && isOwn)) {
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

describe('the package recovers a clip', () => {
  test('in a new Vite project, built', async () => {
    const page = { script: recoverWith('deciwatch-web'), files: WALK };
    expect(await outcome(await freshViteProject(page, 'build'))).toEqual(RECOVERED);
  });

  test("in a new Vite project, on Vite's development server", async () => {
    const page = { script: recoverWith('deciwatch-web'), files: WALK };
    expect(await outcome(await freshViteProject(page, 'dev'))).toEqual(RECOVERED);
  });

  test('in a page without a bundler', async () => {
    const script = recoverWith('./node_modules/deciwatch-web/lib/index.js');
    expect(await outcome(await plainPage({ script, files: WALK }))).toEqual(RECOVERED);
  });
});

describe('a project of the examples, with the package installed', () => {
  const FRAMES = Array.from({ length: 126 }, (_, frame) => frame);

  async function open(site: Site) {
    const page = await browser.newPage();
    await keepPlayerLog(page);
    await page.goto(site.url);
    return page;
  }

  test.each(['build', 'dev'] as const)('plays every frame (%s)', async (mode) => {
    const site = await exampleProject('vite', mode);
    const page = await open(site);
    try {
      await page.locator('input[type=file]').setInputFiles(WALK['walk.mp4']);
      const poses = async () => (await playerLog(page)).poses;
      await expect.poll(async () => (await poses()).length, { timeout: 150_000 }).toBe(126);
      const log = await playerLog(page);
      expect(log.poses).toEqual(FRAMES);
      expect([...log.errors, ...log.complaints]).toEqual([]);
      expect(await page.locator('output').textContent()).toBe('126');
    } finally {
      await page.close();
      await site.close();
    }
  });

  test('recovers what an ONNX model of somebody’s sees', async () => {
    const site = await exampleProject('own-model', 'build', ['onnxruntime-web']);
    const page = await open(site);
    try {
      const model = join(PROJECT_ROOT, 'tests/fixtures/onnx-estimators/heatmap.onnx');
      await page.locator('[name=model]').setInputFiles(model);
      await page.locator('[name=video]').setInputFiles(WALK['walk.mp4']);
      await page.locator('[name=decode]').selectOption('heatmap');
      await page.locator('[name=width]').fill('48');
      await page.locator('[name=height]').fill('64');
      await page.getByRole('button', { name: 'Recover' }).click();
      await expect
        .poll(() => page.locator('output').textContent(), { timeout: 90_000 })
        .toBe('126 frames of 3 joints from 14 looks (cubic).');
      await expect
        .poll(async () => (await playerLog(page)).poses.length, { timeout: 60_000 })
        .toBeGreaterThan(30);
      const log = await playerLog(page);
      expect([...log.errors, ...log.complaints]).toEqual([]);
    } finally {
      await page.close();
      await site.close();
    }
  });
});

describe('what a bundler makes of a part of it', () => {
  /** A built page's files under `assets/`, with the bytes of its code. */
  async function built(entry: string) {
    const script = `
      import { mpjpe } from '${entry}';
      document.title = String(mpjpe([1, 2, 3], [1, 2, 4], { joints: 1, dims: 3 }));`;
    const assets = join(await buildProject(await viteProject({ script })), 'assets');
    const files = await readdir(assets);
    const code = files.find((file) => /^index-.*\.js$/.test(file));
    return { files, code: await readFile(join(assets, code ?? ''), 'utf8') };
  }

  test('the metrics bring no engine', async () => {
    const { code } = await built('deciwatch-web');
    expect(code.length).toBeLessThan(4000);
    expect(code).not.toMatch(/comlink|worker/i);
  });

  test('from their own entry, they bring no models either', async () => {
    const { files } = await built('deciwatch-web/poses');
    expect(files).toHaveLength(1);
  });
});

describe('the package', () => {
  test('has types that need no other package, and that the guide keeps to', async () => {
    const root = await viteProject({ script: '' });
    await cp(join(PROJECT_ROOT, 'tests/fixtures/consumer/consumer.ts'), join(root, 'main.ts'));
    const guide = await readFile(join(PROJECT_ROOT, 'docs/library.md'), 'utf8');
    const examples = Array.from(guide.matchAll(/^```ts\n(.*?)^```/gms), ([, code]) => code!);
    expect(examples.length).toBeGreaterThan(2);
    const files = ['main.ts', ...examples.map((_, index) => `example-${index}.ts`)];
    for (const [index, code] of examples.entries()) {
      await writeFile(join(root, `example-${index}.ts`), code);
    }
    const compilerOptions = {
      target: 'ES2022',
      lib: ['ES2022', 'DOM', 'DOM.Iterable'],
      module: 'ESNext',
      moduleResolution: 'bundler',
      types: [],
      strict: true,
      exactOptionalPropertyTypes: true,
      skipLibCheck: false,
      noEmit: true,
    };
    await writeFile(join(root, 'tsconfig.json'), JSON.stringify({ compilerOptions, files }));
    const tsc = join(PROJECT_ROOT, 'node_modules/typescript/bin/tsc');
    const { stdout } = await run(process.execPath, [tsc, '-p', root]).catch((error) => error);
    expect(stdout).toBe('');
  });

  test('can be imported where there is no page, and does nothing', async () => {
    const root = await viteProject({ script: '' });
    await writeFile(
      join(root, 'import.js'),
      `const before = Object.keys(globalThis).length;
       const library = await import('deciwatch-web');
       console.log(JSON.stringify({
         kinds: [...new Set(Object.values(library).map((value) => typeof value))].sort(),
         metric: library.mpjpe([1, 2, 3], [1, 2, 4], { joints: 1, dims: 3 }),
         added: Object.keys(globalThis).length - before,
       }));`,
    );
    const { stdout, stderr } = await run(process.execPath, [join(root, 'import.js')]);
    expect(stderr).toBe('');
    expect(JSON.parse(stdout)).toEqual({
      kinds: ['function', 'number', 'object', 'string'],
      metric: 1,
      added: 0,
    });
  });

  test('carries the models, and every licence', async () => {
    const files = await readdir(await packedPackage(), { recursive: true });
    expect(files).toEqual(
      expect.arrayContaining([
        'LICENSE',
        'THIRD_PARTY.md',
        'lib/LICENSES.md',
        'lib/estimators/LICENSE-mediapipe.txt',
        'lib/estimators/pose_landmarker_heavy.task',
        'lib/models/3d-forecast.onnx',
        'lib/worker.js',
      ]),
    );
    expect(
      files.filter((file) => /walk\.mp4|favicon|\.ts$/.test(file) && !file.endsWith('.d.ts')),
    ).toEqual([]);
    const { dependencies } = JSON.parse(
      await readFile(join(await packedPackage(), 'package.json'), 'utf8'),
    );
    expect(dependencies).toBeUndefined();
  });
});
