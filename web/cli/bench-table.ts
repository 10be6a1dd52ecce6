/** One measured run; milliseconds and FLOPs are per frame of the clip. */
export interface BenchRow {
  readonly name: string;
  readonly estimator: string;
  readonly every: number;
  readonly frames: number;
  readonly estimatorCalls: number;
  readonly flopsPerFrame: number;
  readonly wallMsPerFrame: number;
  /** CPU time of the whole browser, all processes. */
  readonly cpuMsPerFrame: number;
  readonly stages: Readonly<Record<string, number>>;
}

/** Rows as text, with each row's ratio to the same estimator at N = 1 where that was measured. */
export function formatTable(rows: readonly BenchRow[]): string {
  const stageNames = [...new Set(rows.flatMap((row) => Object.keys(row.stages)))];
  const head = ['estimator', 'N', 'frames', 'calls', 'MFLOP', 'wall', 'CPU', ...stageNames];
  const body = rows.map((row) => {
    const every = rows.find((other) => other.estimator === row.estimator && other.every === 1);
    return [
      row.estimator,
      String(row.every),
      String(row.frames),
      String(row.estimatorCalls),
      (row.flopsPerFrame / 1e6).toFixed(1),
      row.wallMsPerFrame.toFixed(2),
      row.cpuMsPerFrame.toFixed(2),
      ...stageNames.map((stage) => (row.stages[stage] ?? 0).toFixed(2)),
      every ? (row.wallMsPerFrame / every.wallMsPerFrame).toFixed(3) : '',
      every ? (row.flopsPerFrame / every.flopsPerFrame).toFixed(3) : '',
    ];
  });
  const lines = [[...head, 'wall/N=1', 'FLOPs/N=1'], ...body];
  const widths = lines[0]!.map((_, column) =>
    Math.max(...lines.map((line) => line[column]?.length ?? 0)),
  );
  const text = lines.map((line) => line.map((cell, i) => cell.padStart(widths[i]!)).join('  '));
  return `${text.join('\n')}\n(per frame of the clip: MFLOP, and milliseconds)\n`;
}
