/**
 * Builds the site, compresses it, and says how large its parts are: `npm run build`.
 *
 *     npm run build -- [--out DIR] [--budgets-only] [--widget-budget KB] [--first-use-budget MB]
 *
 * With `--budgets-only`, only what has a budget is compressed: to check it, not to publish. Ends with 1 where a part is larger than its budget.
 */
import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { type Bundle, chunkOf, modulesMatching } from './build/bundle.ts';
import { LIMITS, siteParts } from './build/parts.ts';
import { precompress } from './build/precompress.ts';
import { exceeded, sizeTable } from './build/sizes.ts';
import { buildSite, PROJECT_ROOT } from './site.ts';

const CACHE = join(PROJECT_ROOT, 'node_modules/.cache/deciwatch/brotli');

/** The demo's own, and what only it writes files with: the widget has no business with either. */
const DEMO_ALONE = /\/web\/app\/|\/node_modules\/mediabunny\//;

/** What somebody would load with the widget for nothing. */
function strays(bundle: Bundle): string[] {
  const widget = chunkOf(bundle, '/web/player/player.ts');
  const found = widget ? modulesMatching(bundle, widget.file, DEMO_ALONE) : [];
  return found.length > 0
    ? [`widget.js can load ${found[0]}, which belongs to the demo alone (${found.length} such).`]
    : [];
}

async function main(): Promise<void> {
  const { values } = parseArgs({
    options: {
      out: { type: 'string', default: join(PROJECT_ROOT, 'dist') },
      'budgets-only': { type: 'boolean', default: false },
      'widget-budget': { type: 'string', default: String(LIMITS.widget / 1e3) },
      'first-use-budget': { type: 'string', default: String(LIMITS.firstUse / 1e6) },
    },
  });
  const site = resolve(values.out);
  const bundle = await buildSite(site);
  const json = async (file: string) => JSON.parse(await readFile(join(site, file), 'utf8'));
  const { groups, budgets } = siteParts(
    bundle,
    await json('models/manifest.json'),
    await json('estimators/manifest.json'),
    {
      widget: Number(values['widget-budget']) * 1e3,
      firstUse: Number(values['first-use-budget']) * 1e6,
    },
  );
  process.stdout.write('Compressing, which takes minutes for what was not compressed before.\n');
  const only = values['budgets-only'] ? new Set(budgets.flatMap(({ files }) => files)) : undefined;
  const sizes = await precompress(site, CACHE, only);
  const measured = groups.filter(({ files }) => files.every((file) => sizes.has(file)));
  process.stdout.write(`\n${sizeTable(measured, budgets, sizes)}\n`);
  const failures = [...strays(bundle), ...exceeded(budgets, sizes)];
  for (const failure of failures) process.stderr.write(`${failure}\n`);
  if (failures.length > 0) process.exitCode = 1;
}

await main();
