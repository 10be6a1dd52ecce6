import { spawnSync } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { PROJECT_ROOT } from '../../web/cli/site.ts';
import { parsePoseFile } from '../../web/formats/pose-file.ts';

let folder: string;

function recover(...args: string[]) {
  return spawnSync('npx', ['tsx', 'web/cli/recover.ts', ...args], {
    cwd: PROJECT_ROOT,
    encoding: 'utf8',
  });
}

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'deciwatch-recover-'));
});
afterAll(() => rm(folder, { recursive: true, force: true }));

describe('npm run recover', () => {
  test('names every bad clip, goes on with the others and ends non-zero', async () => {
    const { status, stderr } = recover(
      'tests/fixtures/corrupt.mp4',
      'tests/fixtures/nowhere.mp4',
      'tests/fixtures/gap.mp4',
      '--every',
      '10',
      '--out',
      join(folder, 'poses'),
    );
    expect(status).toBe(1);
    expect(stderr).toMatch(/corrupt\.mp4: .+\./);
    expect(stderr).toMatch(/nowhere\.mp4: there is no such file/);
    expect(await readdir(join(folder, 'poses'))).toEqual(['gap.poses.json']);
    const text = await readFile(join(folder, 'poses/gap.poses.json'), 'utf8');
    const file = parsePoseFile(JSON.parse(text));
    const present = file.frames.map((frame) => frame.keypoints2d !== null);
    expect(present.at(0) && present.at(-1)).toBe(true);
    expect(present).toContain(false);
  });

  test.each([
    [['--every', '0', 'clip.mp4'], /--every wants a whole number from 1 to 20/],
    [['--estimator', 'huge', 'clip.mp4'], /lite, full, heavy/],
    [[], /at least one clip/],
    [['a/clip.mp4', 'b/clip.mp4'], /both be written/],
  ])('refuses %j in one sentence', (args, sentence) => {
    const { status, stderr } = recover(...args);
    expect(status).toBe(2);
    expect(stderr).toMatch(sentence);
  });
});
