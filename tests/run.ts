/**
 * Every test of the project: `npm test`. Installs what it needs (the Python packages of `export/`
 * into `export/.venv`; a browser comes with the npm packages unless one is installed), says so, and
 * ends with one line, `N passed, N failed`, for the whole.
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findChromium } from '../web/cli/chromium.ts';
import { PROJECT_ROOT } from '../web/cli/site.ts';
import { ensurePython } from './python-env.ts';

interface Count {
  readonly passed: number;
  readonly failed: number;
}

const reports = mkdtempSync(join(tmpdir(), 'deciwatch-reports-'));

function runs(command: string, args: readonly string[]): boolean {
  process.stdout.write(`\n> ${[command, ...args].join(' ')}\n`);
  const { status } = spawnSync(command, args, { cwd: PROJECT_ROOT, stdio: 'inherit' });
  return status === 0;
}

/** A command that either holds or does not: a linter, a type checker. */
function check(command: string, args: readonly string[]): Count {
  return runs(command, args) ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

/** A run that failed although no test in it did (a crash, a file that would not load) counts too. */
function counted(ok: boolean, passed: number, failed: number): Count {
  return { passed, failed: !ok && failed === 0 ? 1 : failed };
}

function vitest(project: string): Count {
  const file = join(reports, `${project}.json`);
  const ok = runs('npx', [
    'vitest',
    'run',
    '--project',
    project,
    '--reporter=default',
    '--reporter=json',
    `--outputFile.json=${file}`,
  ]);
  try {
    const report = JSON.parse(readFileSync(file, 'utf8'));
    return counted(ok, Number(report.numPassedTests), Number(report.numFailedTests));
  } catch {
    return { passed: 0, failed: 1 };
  }
}

function pytest(python: string): Count {
  const file = join(reports, 'pytest.xml');
  const ok = runs(python, ['-m', 'pytest', 'tests/export', '-q', `--junit-xml=${file}`]);
  try {
    const suite = /<testsuite [^>]*>/.exec(readFileSync(file, 'utf8'))?.[0] ?? '';
    const number = (name: string) => Number(new RegExp(`${name}="(\\d+)"`).exec(suite)?.[1]);
    const failed = number('failures') + number('errors');
    return counted(ok, number('tests') - failed - number('skipped'), failed);
  } catch {
    return { passed: 0, failed: 1 };
  }
}

async function main(): Promise<void> {
  const browser = await findChromium();
  process.stdout.write(`Browser for the tests: ${browser}\n`);
  const counts = [
    check('npx', ['biome', 'check', '.']),
    check('npx', ['tsc', '--noEmit']),
    check('npm', ['run', 'docs:api', '--', '--check']),
    // The built site keeps its budgets.
    check('npx', ['tsx', 'web/cli/build.ts', '--budgets-only', '--out', join(reports, 'site')]),
    vitest('unit'),
    vitest('browser'),
    vitest('e2e'),
  ];
  const python = ensurePython();
  if (python) {
    counts.push(
      check(python, ['-m', 'ruff', 'check', 'export', 'tests/export']),
      check(python, ['-m', 'ruff', 'format', '--check', 'export', 'tests/export']),
      pytest(python),
    );
  } else {
    counts.push({ passed: 0, failed: 1 });
  }
  const passed = counts.reduce((sum, count) => sum + count.passed, 0);
  const failed = counts.reduce((sum, count) => sum + count.failed, 0);
  process.stdout.write(`\n${passed} passed, ${failed} failed\n`);
  process.exitCode = failed === 0 && passed > 0 ? 0 : 1;
}

main().finally(() => rmSync(reports, { recursive: true, force: true }));
