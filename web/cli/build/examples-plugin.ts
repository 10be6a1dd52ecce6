import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

/** A version that the widget does not use, for the example of a page with a three.js of its own. */
const VENDOR = {
  'examples/vendor/another-three.js': 'node_modules/three-another/build/three.module.min.js',
};

/** Pages and what they are styled by; folders are projects of their own. */
const COPIED = /\.(html|css)$/;

/**
 * Puts `examples/` into the built site as it is: pages that name `../widget.js` and `../library.js`, as a
 * page of anybody's does. In development the two names lead to their sources.
 * @param entries the name in the site of each source, relative to the root
 */
export function examplesPlugin(entries: Readonly<Record<string, string>>): Plugin {
  let root = '';
  return {
    name: 'deciwatch-examples',
    configResolved(config) {
      root = config.root;
    },
    generateBundle() {
      const folder = join(root, 'examples');
      for (const name of readdirSync(folder).filter((file) => COPIED.test(file))) {
        const source = readFileSync(join(folder, name));
        this.emitFile({ type: 'asset', fileName: `examples/${name}`, source });
      }
      for (const [fileName, from] of Object.entries(VENDOR)) {
        this.emitFile({ type: 'asset', fileName, source: readFileSync(join(root, from)) });
      }
    },
    resolveId(id, importer) {
      const name = /^(?:\.\.)?\/([\w-]+\.js)(?:\?.*)?$/.exec(id)?.[1] ?? '';
      const source = entries[name];
      // By a page's own address, as Vite reads its scripts ahead, or by a module in it.
      const ofExample = id.startsWith('/') || importer?.includes('/examples/');
      return source && ofExample ? join(root, source) : null;
    },
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const path = (request.url ?? '').split('?')[0]!.slice(1);
        const source = entries[path];
        const vendor = VENDOR[path as keyof typeof VENDOR];
        if (!source && !vendor) return next();
        response.setHeader('Content-Type', 'text/javascript');
        // Other origins' pages may have it, as of a real host.
        response.setHeader('Access-Control-Allow-Origin', '*');
        response.end(
          vendor ? readFileSync(join(root, vendor)) : `export * from ${JSON.stringify(source)};\n`,
        );
      });
    },
  };
}
