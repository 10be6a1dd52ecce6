import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { outputPaths } from '../../web/cli/outputs.ts';

let folder: string;
beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'deciwatch-outputs-'));
});
afterAll(() => rm(folder, { recursive: true }));

describe('outputPaths', () => {
  test('a folder, there or not, gets a file for each clip', async () => {
    for (const out of [folder, join(folder, 'new')]) {
      const paths = await outputPaths(['a.mp4', 'clips/b.mov'], out);
      expect(paths.every((path) => path.startsWith(out) && path.endsWith('.json'))).toBe(true);
      expect(new Set(paths).size).toBe(2);
    }
  });

  test('a file that is there already and no pose file is refused before any work', async () => {
    const notes = join(folder, 'notes.txt');
    await writeFile(notes, 'mine');
    await expect(outputPaths(['a.mp4'], notes)).rejects.toThrow(/notes\.txt is a file/);
    const poses = join(folder, 'poses.json');
    await writeFile(poses, '{}');
    expect(await outputPaths(['a.mp4'], poses)).toEqual([poses]);
  });
});
