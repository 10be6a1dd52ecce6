import { posix } from 'node:path';
import { defineConfig } from 'vite';
import { libFiles } from './packaging/lib-files.ts';
import { libLicences } from './packaging/lib-licences.ts';
import { ENTRIES, libTypes } from './packaging/lib-types.ts';
import { plainImports } from './packaging/plain-imports.ts';
import site from './vite.config.ts';

/** Relative to the module that names it, and said as every bundler looks for it. */
function besideModule(file: string, module: string): string {
  const path = posix.relative(posix.dirname(module), file);
  return `new URL(${JSON.stringify(path.startsWith('.') ? path : `./${path}`)}, import.meta.url).href`;
}

const licences = libLicences();

/**
 * The npm package: ES modules with all that they import, and beside them the files that they fetch.
 * Not Vite's library mode, which writes every file that is named into the code.
 */
export default defineConfig({
  base: './',
  plugins: [plainImports(), licences.page, libFiles(), libTypes()],
  resolve: site.resolve ?? {},
  experimental: {
    renderBuiltUrl: (file, { hostId, hostType }) =>
      hostType === 'js' ? { runtime: besideModule(file, hostId) } : { relative: true },
  },
  build: {
    outDir: 'lib',
    target: 'es2022',
    copyPublicDir: false,
    assetsInlineLimit: 0,
    // A bundler minifies them with the rest; who debugs reads them.
    minify: false,
    modulePreload: false,
    // three.js.
    chunkSizeWarningLimit: 1500,
    rollupOptions: {
      checks: { pluginTimings: false },
      input: ENTRIES,
      preserveEntrySignatures: 'strict',
      output: {
        entryFileNames: '[name].js',
        chunkFileNames: 'chunks/[name].js',
        // Not .mjs, which many web servers do not know to be JavaScript.
        assetFileNames: ({ names }) => `runtime/${names[0]?.replace(/\.mjs$/, '.js')}`,
        // What does not need the engine must not bring it along: a bundler drops whole files.
        codeSplitting: {
          groups: [
            {
              name: 'base',
              test: /\/web\/(errors|pose\/.*|sampling\/watched|estimators\/names)\.ts$/,
            },
            { name: 'pose-files', test: /\/web\/formats\// },
            { name: 'estimators', test: /\/web\/estimators\// },
            { name: 'camera', test: /\/web\/sources\// },
            { name: 'engine', test: /\/web\/engine\// },
          ],
        },
      },
    },
  },
  worker: {
    format: 'es',
    plugins: licences.worker,
    rollupOptions: {
      output: { entryFileNames: 'worker.js', codeSplitting: false, minify: true },
    },
  },
});
