import { cp, mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/** The folders of `public/` that the engine fetches from; the rest is the demo's. */
const FOLDERS = ['models', 'estimators'];

/** Puts the models and their licences beside the modules, under the names that their manifests give. */
export function libFiles(): Plugin {
  let publicDir = '';
  return {
    name: 'deciwatch:lib-files',
    configResolved: (config) => {
      publicDir = config.publicDir;
    },
    async writeBundle({ dir }) {
      if (!dir) return;
      await mkdir(dir, { recursive: true });
      for (const folder of FOLDERS) {
        await cp(join(publicDir, folder), join(dir, folder), { recursive: true });
      }
    },
  };
}
