import { spawnSync } from 'node:child_process';
import { expect, test } from 'vitest';
import { PROJECT_ROOT } from '../../web/cli/site.ts';

test('two minutes of live playback leave memory as it was, and no frame open', () => {
  const { stdout, stderr, status } = spawnSync(
    'npx',
    ['tsx', 'web/cli/soak.ts', '--minutes', '2', '--estimator', 'lite', '--mode', 'now'],
    { cwd: PROJECT_ROOT, encoding: 'utf8' },
  );
  // One frame may be on its way to the worker when it is looked.
  expect(stdout).toMatch(/[01] open frames, 1 worker[\s\S]*from minute 0.5 to 2: JS heap/);
  expect(stderr.replace(/npm warn.*\n/g, '')).toBe('');
  expect(status).toBe(0);
}, 240_000);
