import { mkdir, rename, rm, stat, writeFile } from 'node:fs/promises';
import { basename, dirname, join, resolve } from 'node:path';
import { poseFileName } from '../formats/pose-file.ts';
import { UsageError } from './options.ts';

async function isDirectory(path: string): Promise<boolean> {
  return stat(path).then(
    (found) => found.isDirectory(),
    () => false,
  );
}

async function isFile(path: string): Promise<boolean> {
  return stat(path).then(
    (found) => found.isFile(),
    () => false,
  );
}

/**
 * Where each clip's pose file goes: `out` itself when it names a file, else into the folder `out`,
 * else into the current folder.
 * @throws UsageError when two clips would be written to the same file, or `out` is another file.
 */
export async function outputPaths(clips: readonly string[], out?: string): Promise<string[]> {
  if (out && !out.endsWith('.json') && (await isFile(out))) {
    throw new UsageError(
      `--out ${out} is a file that is there already: name a folder, or a .json file.`,
    );
  }
  const namesFile = out?.endsWith('.json') && !(await isDirectory(out));
  if (out && namesFile && clips.length > 1) {
    throw new UsageError(
      `--out ${out} is one file, but there are ${clips.length} clips: name a folder.`,
    );
  }
  const paths = clips.map((clip) =>
    out && namesFile ? resolve(out) : resolve(out ?? '.', poseFileName(basename(clip))),
  );
  const twice = paths.find((path, index) => paths.indexOf(path) !== index);
  if (twice) throw new UsageError(`Two clips would both be written to ${twice}: rename one.`);
  return paths;
}

/** Writes a file whole or not at all, making its folder. */
export async function writeWhole(path: string, text: string): Promise<void> {
  await mkdir(dirname(path), { recursive: true });
  const partial = join(dirname(path), `.${basename(path)}.${process.pid}.part`);
  try {
    await writeFile(partial, text);
    await rename(partial, path);
  } catch (error) {
    await rm(partial, { force: true });
    throw error;
  }
}
