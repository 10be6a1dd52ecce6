import { cp, mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/** The folders of `public/` that the engine fetches from; the rest is the demo's. */
const FOLDERS = ['models', 'estimators'];

/**
 * Modules are strict without it; but webpack's minifier takes a `.js` file that it only copies for a script,
 * and leaves out braces that strict code must have.
 */
const STRICT = '"use strict";';

const SOURCE_MAP = /^\/\/# sourceMappingURL=.*$/m;

/** Puts the models and their licences beside the modules, under the names that their manifests give. */
export function libFiles(): Plugin {
  let publicDir = '';
  return {
    name: 'deciwatch:lib-files',
    configResolved: (config) => {
      publicDir = config.publicDir;
    },
    generateBundle(_, bundle) {
      for (const output of Object.values(bundle)) {
        if (output.type === 'asset' && output.fileName.endsWith('.js')) {
          // A map that does not come with it would only be missed.
          const code = Buffer.from(output.source).toString().replace(SOURCE_MAP, '');
          output.source = `${STRICT}\n${code}`;
        }
      }
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
