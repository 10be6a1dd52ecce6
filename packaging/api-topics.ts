import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { PROJECT_ROOT } from '../web/cli/site.ts';

/** Exports that belong together. */
export interface Topic {
  readonly heading: string;
  readonly names: readonly string[];
}

/** The topics of a module that only exports what others define: its `// #` comments, and the names below each. */
export function topicsIn(file: string): Topic[] {
  const text = readFileSync(join(PROJECT_ROOT, file), 'utf8');
  const [, ...parts] = text.split(/^\/\/ # /m);
  return parts.map((part) => {
    const lists = Array.from(part.matchAll(/export (?:type )?\{([^}]*)\}/g), ([, list]) => list!);
    const names = lists.flatMap((list) => list.split(',').map((name) => name.trim()));
    return {
      heading: part.split('\n', 1)[0]!.trim(),
      names: names.filter(Boolean).map((name) => name.replace(/^type\s+/, '')),
    };
  });
}
