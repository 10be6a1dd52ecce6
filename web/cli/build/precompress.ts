import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join, relative, sep } from 'node:path';
import { brotli } from './brotli.ts';
import type { Size } from './sizes.ts';

/** Below this saving a compressed copy is not worth its place on the host. */
const WORTHWHILE = 0.05;

/** Read by the host itself, and served to nobody. */
const NOT_SERVED = /^_headers$|\.br$/;

/**
 * Writes a `.br` beside every file of a site that gains by it, for servers that send such copies.
 * @param only files to do this for, instead of all
 * @returns the sizes of these files, by their paths within the site, with forward slashes
 */
export async function precompress(
  site: string,
  cache: string,
  only?: ReadonlySet<string>,
): Promise<Map<string, Size>> {
  const names = (await filesIn(site)).filter((name) => only?.has(name) ?? true);
  const files = await Promise.all(
    names.map(async (name) => ({ name, bytes: await readFile(join(site, name)) })),
  );
  // The largest first, or it would be alone at the end.
  files.sort((a, b) => b.bytes.length - a.bytes.length);
  const sizes = await Promise.all(
    files.map(async ({ name, bytes }): Promise<[string, Size]> => {
      const compressed = await brotli(bytes, cache);
      const size = { raw: bytes.length, brotli: Math.min(bytes.length, compressed.length) };
      if (size.brotli < size.raw * (1 - WORTHWHILE)) {
        await writeFile(join(site, `${name}.br`), compressed);
      }
      return [name, size];
    }),
  );
  return new Map(sizes);
}

async function filesIn(site: string): Promise<string[]> {
  const entries = await readdir(site, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile() && !NOT_SERVED.test(entry.name))
    .map((entry) => relative(site, join(entry.parentPath, entry.name)).replaceAll(sep, '/'));
}
