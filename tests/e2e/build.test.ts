import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { PROJECT_ROOT } from '../../web/cli/site.ts';

let out: string;
beforeAll(() => {
  out = mkdtempSync(join(tmpdir(), 'deciwatch-build-'));
});
afterAll(() => rmSync(out, { recursive: true, force: true }));

// Without what an earlier build compressed, this takes minutes.
test('a build beyond its budget prints its sizes, says so in one sentence and fails', {
  timeout: 900_000,
}, () => {
  const build = spawnSync(
    process.execPath,
    [
      ...['--import', 'tsx', 'web/cli/build.ts', '--out', out, '--budgets-only'],
      ...['--widget-budget', '1000', '--first-use-budget', '1'],
    ],
    { cwd: PROJECT_ROOT, encoding: 'utf8' },
  );
  expect(build.stdout).toMatch(/^runtime .+ MB +\d+\.\d+ MB$/m);
  expect(build.stdout).toMatch(/^first use with lite .+ of 1\.00 MB$/m);
  expect(build.stderr.trim().split('\n').at(-1)).toMatch(
    /^"first use with lite" is \d+\.\d+ MB with brotli, .+ over its budget of 1\.00 MB\.$/,
  );
  expect(build.status).toBe(1);
  expect(readdirSync(out)).toEqual(
    expect.arrayContaining(['index.html', 'widget.js', 'sw.js', 'offline.json', '_headers']),
  );
  const assets = readdirSync(join(out, 'assets'));
  const wasm = assets.filter((file) => file.endsWith('.wasm'));
  expect(wasm.length).toBe(2);
  for (const file of wasm) expect(assets).toContain(`${file}.br`);
});
