import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PROJECT_ROOT } from '../web/cli/site.ts';

const VENV = join(PROJECT_ROOT, 'export/.venv');
const PYTHON =
  process.platform === 'win32' ? join(VENV, 'Scripts/python.exe') : join(VENV, 'bin/python');
const CANDIDATES = ['python3.11', 'python3.12', 'python3.13', 'python3', 'python'];

function isPython311OrLater(command: string): boolean {
  const code = 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))';
  return spawnSync(command, ['-c', code], { stdio: 'ignore' }).status === 0;
}

function runs(command: string, args: readonly string[]): boolean {
  process.stdout.write(`\n> ${[command, ...args].join(' ')}\n`);
  return spawnSync(command, args, { cwd: PROJECT_ROOT, stdio: 'inherit' }).status === 0;
}

/**
 * Makes `export/.venv` and installs `export/` into it, unless that was done for this very
 * `pyproject.toml`.
 * @returns the environment's Python, or null when there is none, having said why.
 */
export function ensurePython(): string | null {
  const wanted = createHash('sha256')
    .update(readFileSync(join(PROJECT_ROOT, 'export/pyproject.toml')))
    .digest('hex');
  const stamp = join(VENV, 'installed-for.sha256');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return PYTHON;

  const base = CANDIDATES.find(isPython311OrLater);
  if (!base) {
    process.stdout.write(
      'The Python tests need Python 3.11 or later with venv and pip: install it and run again.\n',
    );
    return null;
  }
  process.stdout.write(
    'Installing the Python packages of export/ into export/.venv (torch: 6 GB).\n',
  );
  rmSync(stamp, { force: true });
  const installed =
    (existsSync(PYTHON) || runs(base, ['-m', 'venv', VENV])) &&
    runs(PYTHON, [
      '-m',
      'pip',
      'install',
      '--quiet',
      '--disable-pip-version-check',
      '-e',
      './export[dev]',
    ]);
  if (!installed) {
    process.stdout.write('The Python packages of export/ could not be installed: see above.\n');
    return null;
  }
  writeFileSync(stamp, wanted);
  return PYTHON;
}
