import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

/** MediaPipe's library names a source map that does not come with it, which Vite complains of in development. */
export function noMissingMap(): Plugin {
  return {
    name: 'deciwatch-no-missing-map',
    apply: 'serve',
    load(id) {
      const [file] = id.split('?');
      if (!file?.endsWith('/tasks-vision/vision_bundle.mjs') || id.includes('?url')) return null;
      return readFileSync(file, 'utf8').replace(/\/\/# sourceMappingURL=.*/, '');
    },
  };
}
