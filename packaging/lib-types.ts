import { join } from 'node:path';
import { rolldown } from 'rolldown';
import { dts, type Logger } from 'rolldown-plugin-dts';
import type { Plugin } from 'vite';
import { PROJECT_ROOT } from '../web/cli/site.ts';

/** What can be imported from the package, by the names of its files. */
export const ENTRIES = {
  index: 'web/player/library.ts',
  poses: 'web/player/poses.ts',
  player: 'web/player/player.ts',
};

/** Where the types of each are. The player's own module knows private elements and Lit, which are nobody else's business. */
const TYPES = { ...ENTRIES, player: 'web/player/types.ts' };

/** It tells at every run which compiler it uses, and that this one is new to it. */
const quiet: Logger = { info() {}, warn() {}, error: (...words) => console.error(...words) };

/** Writes the declarations of both entries into a folder, with all that they refer to. */
export async function writeTypes(dir: string): Promise<void> {
  const bundle = await rolldown({
    cwd: PROJECT_ROOT,
    input: TYPES,
    checks: { pluginTimings: false },
    plugins: [
      dts({ emitDtsOnly: true, tsconfig: join(PROJECT_ROOT, 'tsconfig.json'), logger: quiet }),
    ],
  });
  await bundle.write({ dir, format: 'es', chunkFileNames: 'chunks/[name].d.ts' });
  await bundle.close();
}

/** Puts the declarations beside the modules. */
export function libTypes(): Plugin {
  return {
    name: 'deciwatch:lib-types',
    async writeBundle({ dir }) {
      if (dir) await writeTypes(dir);
    },
  };
}
