import { createHash } from 'node:crypto';
import { readFile, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { build, type Plugin, type Rolldown } from 'vite';
import { LIST } from '../../app/offline/addresses.ts';
import type { Release, ReleaseEntry } from '../../app/offline/release.ts';
import { versionQuery } from '../../digest.ts';
import type { FileEntry } from '../../download.ts';
import type { EstimatorManifest } from '../../estimators/manifest.ts';
import { ESTIMATOR_NAMES } from '../../estimators/names.ts';
import type { ModelManifest } from '../../recovery/manifest.ts';
import { chunkOf, describeBundle, reachable } from './bundle.ts';

const DEMO = '/web/app/main.ts';

/** What the page fetches that no chunk names. */
const FIXED = [
  'models/manifest.json',
  'estimators/manifest.json',
  'samples/walk.mp4',
  'favicon.svg',
];

/** Writes what the demo needs to be kept for offline use: its service worker, and the list of its files. */
export function offlinePlugin(): Plugin {
  let root = '';
  return {
    name: 'deciwatch-offline',
    apply: 'build',
    configResolved(config) {
      root = config.root;
    },
    async generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'sw.js', source: await bundleWorker(root) });
    },
    async writeBundle({ dir }, output) {
      const bundle = describeBundle(Object.values(output));
      const demo = chunkOf(bundle, DEMO);
      // Another page was built: one of the headless commands'.
      if (!demo || !dir) return;
      const release = await listFiles(dir, [...reachable(bundle, demo.file)]);
      await writeFile(join(dir, LIST), `${JSON.stringify(release)}\n`);
    },
  };
}

/** Alone in its file, and no module: not every browser starts a service worker that is one. */
async function bundleWorker(root: string): Promise<string> {
  const built = await build({
    configFile: false,
    publicDir: false,
    root,
    logLevel: 'error',
    build: {
      write: false,
      rollupOptions: {
        input: resolve(root, 'web/app/offline/sw.ts'),
        output: { format: 'iife', codeSplitting: false },
      },
      modulePreload: false,
    },
  });
  const { output } = built as Rolldown.RolldownOutput;
  return output[0].code;
}

async function listFiles(site: string, code: readonly string[]): Promise<Release> {
  const read = async <T>(file: string): Promise<T> =>
    JSON.parse(await readFile(join(site, file), 'utf8'));
  const { pairs } = await read<ModelManifest>('models/manifest.json');
  const { estimators } = await read<EstimatorManifest>('estimators/manifest.json');
  const nets = Object.values(pairs).flatMap((pair) => [pair.denoise, pair.recover, pair.forecast]);
  const files: ReleaseEntry[] = [
    // The page goes by its folder's address.
    { ...(await digested(site, 'index.html')), file: './' },
    ...(await Promise.all([...code, ...FIXED].map((file) => digested(site, file)))),
    ...nets.flatMap((net) => (net ? [listed('models', net)] : [])),
    ...ESTIMATOR_NAMES.map((estimator) => ({
      ...listed('estimators', estimators[estimator]),
      estimator,
    })),
  ];
  const release = createHash('sha256').update(JSON.stringify(files)).digest('hex').slice(0, 16);
  return { format: 'deciwatch-offline/1', release, files };
}

async function digested(site: string, file: string): Promise<FileEntry> {
  const bytes = await readFile(join(site, file));
  return { file, bytes: bytes.length, sha256: createHash('sha256').update(bytes).digest('hex') };
}

function listed(folder: string, { file, bytes, sha256 }: FileEntry): FileEntry {
  return { file: `${folder}/${file}${versionQuery(sha256)}`, bytes, sha256 };
}
