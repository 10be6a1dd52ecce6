/** Bytes of a file as it is, and as brotli makes it. */
export interface Size {
  readonly raw: number;
  readonly brotli: number;
}

/** Files that belong together, under a name for the table. */
export interface SizeGroup {
  readonly name: string;
  readonly files: readonly string[];
}

/** What may not grow beyond a limit. */
export interface Budget {
  readonly name: string;
  readonly files: readonly string[];
  /** Bytes, brotli. */
  readonly limit: number;
}

/** The sum over files, each counted once. */
export function total(files: Iterable<string>, sizes: ReadonlyMap<string, Size>): Size {
  const sum = { raw: 0, brotli: 0 };
  for (const file of new Set(files)) {
    const size = sizes.get(file);
    if (!size) throw new Error(`${file} is not in the built site.`);
    sum.raw += size.raw;
    sum.brotli += size.brotli;
  }
  return sum;
}

/** One sentence for each budget that is exceeded. */
export function exceeded(budgets: readonly Budget[], sizes: ReadonlyMap<string, Size>): string[] {
  return budgets.flatMap(({ name, files, limit }) => {
    const { brotli } = total(files, sizes);
    if (brotli <= limit) return [];
    return `"${name}" is ${bytesInWords(brotli, limit)} with brotli, ${bytesInWords(brotli - limit)} over its budget of ${bytesInWords(limit)}.`;
  });
}

/** The table that `npm run build` prints: groups, then what has a budget. */
export function sizeTable(
  groups: readonly SizeGroup[],
  budgets: readonly Budget[],
  sizes: ReadonlyMap<string, Size>,
): string {
  const row = ({ name, files }: SizeGroup) => {
    const { raw, brotli } = total(files, sizes);
    return [name, bytesInWords(raw), bytesInWords(brotli), ''];
  };
  const lines = [
    ['', 'raw', 'brotli', ''],
    ...groups.map(row),
    ...budgets.map((budget) => [...row(budget).slice(0, 3), `of ${bytesInWords(budget.limit)}`]),
  ];
  const widths = [0, 1, 2, 3].map((column) =>
    Math.max(...lines.map((line) => line[column]!.length)),
  );
  const text = lines.map(([name, ...figures]) =>
    [name!.padEnd(widths[0]!), ...figures.map((cell, i) => cell.padStart(widths[i + 1]!))]
      .join('  ')
      .trimEnd(),
  );
  return `${text.join('\n')}\n`;
}

/** Decimal kilobytes, or megabytes from a million on. */
export function bytesInWords(bytes: number, scale = bytes): string {
  return scale >= 1e6 ? `${(bytes / 1e6).toFixed(2)} MB` : `${(bytes / 1e3).toFixed(1)} kB`;
}
