import { expect, test } from 'vitest';
import { cumulativeFlops } from '../../web/app/cumulative-cost.ts';
import type { RecoveredClip } from '../../web/engine/types.ts';

test('the running count grows with every look and closes on the report’s total', () => {
  const watched = Uint8Array.of(1, 0, 0, 1, 0, 1);
  const clip = {
    estimator: { name: 'any', flops: 600 },
    poses2d: { watched },
    cost: {
      estimatorCalls: 3,
      everyFrameFlopsPerFrame: 600,
      flopsPerFrame: { estimator: 300, denoise: 4, recover: 6, total: 310 },
    },
  } as unknown as RecoveredClip;
  const upTo = cumulativeFlops(clip);
  expect(upTo(0)).toEqual({ spent: 610, everyFrame: 600, calls: 1 });
  expect(upTo(2)).toEqual({ spent: 630, everyFrame: 1800, calls: 1 });
  expect(upTo(5).spent).toBe(6 * 310);
  expect(upTo(99)).toEqual(upTo(5));
});
