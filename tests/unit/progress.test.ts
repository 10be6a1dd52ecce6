import { expect, it } from 'vitest';
import { ProgressReporter } from '../../web/engine/progress.ts';
import type { RecoverProgress } from '../../web/engine/types.ts';

it('tells at most twenty times a second, never falls, and ends at 1', () => {
  const told: { at: number; step: RecoverProgress }[] = [];
  let now = 0;
  const progress = new ProgressReporter(
    (step) => told.push({ at: now, step }),
    () => now,
  );
  progress.report('loading', 0, 0, 100);
  for (let frame = 1; frame <= 100; frame++) {
    now += 10;
    progress.report('watching', frame / 100, frame, 100);
  }
  // A stage that begins anew, as when a job has two passes.
  now += 60;
  progress.report('recovering', 0.5, 100, 100);
  now += 60;
  progress.report('recovering', 0.2, 100, 100);
  progress.finish(100);

  const fractions = told.map(({ step }) => step.fraction);
  expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
  expect(fractions[0]).toBe(0);
  expect(fractions.at(-1)).toBe(1);
  expect(fractions.filter((fraction) => fraction === 1).length).toBe(1);
  const watching = told.filter(({ step }) => step.stage === 'watching');
  expect(watching.length).toBeLessThanOrEqual(21);
  expect(watching.length).toBeGreaterThan(10);
});
