/**
 * What `web/` is made of, from the bottom up: each folder (or file) may import from itself and from
 * what stands before it.
 */
export const LAYERS: readonly string[] = [
  'errors.ts',
  'digest.ts',
  'pose',
  'sampling',
  'download.ts',
  'estimators',
  'recovery',
  'sources',
  'cost',
  'engine',
  'stage',
  'formats',
  'player',
  'app',
  'cli',
];

/** Static and dynamic imports, re-exports, and workers and files named by `new URL`. */
const IMPORT = /(?:\bfrom\s*|\bimport\s*\(?\s*|new URL\(\s*)['"](\.[^'"?]*)[^'"]*['"]/g;

/** The relative imports in a module's text. */
export function importsIn(text: string): string[] {
  return Array.from(text.matchAll(IMPORT), (match) => match[1]!);
}

/**
 * Says what is wrong with an import, or nothing.
 *
 * @param file path of the importing file within `web/`, such as `engine/worker.ts`
 * @param imported relative path, such as `../stage/stage.ts`
 */
export function violation(file: string, imported: string): string | undefined {
  const target = new URL(imported, `file:///web/${file}`).pathname;
  if (!target.startsWith('/web/')) return undefined;
  const from = layerOf(file);
  const to = layerOf(target.slice('/web/'.length));
  if (from < 0) return `${file} is in no known layer`;
  if (to < 0) return `${file} imports ${imported}, which is in no known layer`;
  return to <= from ? undefined : `${file} imports ${imported}, which stands above it`;
}

function layerOf(file: string): number {
  return LAYERS.indexOf(file.split('/')[0]!);
}
