import { execFile } from 'node:child_process';
import { cp, link, mkdir, mkdtemp, readdir, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { build, createServer, type InlineConfig, preview } from 'vite';
import { afterAll } from 'vitest';
import { PROJECT_ROOT, type Site } from '../../web/cli/site.ts';

const run = promisify(execFile);

/** Where everything here is written: gone when the file's tests have ended. */
let workshop: Promise<string> | undefined;

async function folder(name: string): Promise<string> {
  workshop ??= mkdtemp(join(tmpdir(), 'deciwatch-package-'));
  return mkdtemp(join(await workshop, `${name}-`));
}

afterAll(async () => {
  if (workshop) await rm(await workshop, { recursive: true, force: true });
});

let packed: Promise<string> | undefined;

/**
 * What `npm install` would put into `node_modules/deciwatch-web`: the package built, packed and unpacked,
 * once for a test file.
 * @returns its folder, not to be written to
 */
export function packedPackage(): Promise<string> {
  packed ??= pack();
  return packed;
}

async function pack(): Promise<string> {
  const into = await folder('tarball');
  // Vitest's own NODE_ENV would give the development builds of what is bundled.
  const env = { ...process.env, NODE_ENV: 'production' };
  await run('npm', ['run', 'build:lib'], { cwd: PROJECT_ROOT, env });
  // The build above is what `prepack` would do.
  const { stdout } = await run(
    'npm',
    ['pack', '--ignore-scripts', '--json', '--pack-destination', into],
    { cwd: PROJECT_ROOT },
  );
  const [{ filename }] = JSON.parse(stdout) as [{ filename: string }];
  await run('tar', ['-xzf', filename], { cwd: into });
  return join(into, 'package');
}

/** A page of somebody's. */
export interface ForeignPage {
  /** The body's HTML. */
  readonly html?: string;
  /** A module: `main.ts` in a project, inline in a plain page. */
  readonly script: string;
  /** Files to serve beside the page: their names there, and where they are now. */
  readonly files?: Readonly<Record<string, string>>;
}

const DOCUMENT = (body: string, script: string) => `<!doctype html>
<html lang="en">
  <head><meta charset="utf-8"><title>Somebody's page</title></head>
  <body>${body}${script}</body>
</html>
`;

/** A copy that takes no room: the package is 80 MB. */
async function linkAll(from: string, to: string): Promise<void> {
  await mkdir(to, { recursive: true });
  for (const entry of await readdir(from, { withFileTypes: true })) {
    const copy = entry.isDirectory() ? linkAll : link;
    await copy(join(from, entry.name), join(to, entry.name));
  }
}

/** A folder with the package installed, and the files beside the page in `served`. */
async function foreignFolder(page: ForeignPage, served: string): Promise<string> {
  const root = await folder('page');
  await mkdir(join(root, served), { recursive: true });
  await linkAll(await packedPackage(), join(root, 'node_modules/deciwatch-web'));
  await writeFile(join(root, 'package.json'), '{ "private": true, "type": "module" }\n');
  for (const [name, from] of Object.entries(page.files ?? {})) {
    await cp(from, join(root, served, name));
  }
  return root;
}

/** A new Vite project that has the package installed, and nothing configured. @returns its folder */
export async function viteProject(page: ForeignPage): Promise<string> {
  const root = await foreignFolder(page, 'public');
  const script = '<script type="module" src="/main.ts"></script>';
  await writeFile(join(root, 'index.html'), DOCUMENT(page.html ?? '', script));
  await writeFile(join(root, 'main.ts'), page.script);
  return root;
}

const quiet = (root: string): InlineConfig => ({ root, configFile: false, logLevel: 'error' });

const LOOPBACK = { host: '127.0.0.1', port: 0, strictPort: false, open: false };

/** Builds a project as `npx vite build` does. @returns the folder of the site */
export async function buildProject(root: string): Promise<string> {
  await build(quiet(root));
  return join(root, 'dist');
}

/** A new Vite project, served as it is built or by Vite's development server. */
export async function freshViteProject(page: ForeignPage, mode: 'build' | 'dev'): Promise<Site> {
  return serveProject(await viteProject(page), mode);
}

/**
 * A project of `examples/`, as somebody has it who copied the folder and ran `npm install`.
 * @param installed packages beside ours
 */
export async function exampleProject(
  name: string,
  mode: 'build' | 'dev',
  installed: readonly string[] = [],
): Promise<Site> {
  const root = await folder(name);
  await cp(join(PROJECT_ROOT, 'examples', name), root, { recursive: true });
  const modules = join(root, 'node_modules');
  await linkAll(await packedPackage(), join(modules, 'deciwatch-web'));
  for (const other of installed) {
    await symlink(join(PROJECT_ROOT, 'node_modules', other), join(modules, other), 'dir');
  }
  return serveProject(root, mode);
}

async function serveProject(root: string, mode: 'build' | 'dev'): Promise<Site> {
  if (mode === 'build') return served(root, await buildProject(root));
  const server = await createServer({ ...quiet(root), server: LOOPBACK });
  await server.listen();
  return site(server);
}

/**
 * A page without any bundler, served as it lies there; the package is in `./node_modules/deciwatch-web`.
 * Its script must not contain the text of a closing tag.
 */
export async function plainPage(page: ForeignPage): Promise<Site> {
  const root = await foreignFolder(page, '.');
  const script = `<script type="module">${page.script}</script>`;
  await writeFile(join(root, 'index.html'), DOCUMENT(page.html ?? '', script));
  return served(root, root);
}

/** Serves a folder as any web server does: what is not there is a 404. */
async function served(root: string, outDir: string): Promise<Site> {
  const server = await preview({
    ...quiet(root),
    appType: 'mpa',
    build: { outDir },
    preview: LOOPBACK,
  });
  return site(server);
}

function site(server: {
  readonly resolvedUrls: { readonly local: string[] } | null;
  close(): Promise<void>;
}): Site {
  const url = server.resolvedUrls?.local[0];
  if (!url) throw new Error('The page could not be served on 127.0.0.1.');
  return { url, close: () => server.close() };
}
