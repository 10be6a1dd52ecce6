import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

/** MediaPipe's library names a source map that does not come with it, which Vite complains of in development. */
export function noMissingMap(): Plugin {
  return {
    name: 'deciwatch-no-missing-map',
    apply: 'serve',
    load(id) {
      if (!id.endsWith('/tasks-vision/vision_bundle.mjs')) return null;
      return readFileSync(id, 'utf8').replace(/^\/\/# sourceMappingURL=.*$/m, '');
    },
  };
}
