import { defaultClientConditions, defineConfig } from 'vite';
import { examplesPlugin } from './web/cli/build/examples-plugin.ts';
import { noMissingMap } from './web/cli/build/no-missing-map.ts';
import { offlinePlugin } from './web/cli/build/offline-plugin.ts';

/** Named in other people's pages: they keep their names from release to release. */
const LASTING = {
  'widget.js': '/web/player/player.ts',
  'library.js': '/web/player/library.ts',
} as const;

const nameOf = (file: string) => file.replace('.js', '');
const lastingInputs = Object.entries(LASTING).map(([file, source]) => [nameOf(file), `.${source}`]);

export default defineConfig({
  // Relative, so that the built site works from any folder of any host.
  base: './',
  plugins: [examplesPlugin(LASTING), offlinePlugin(), noMissingMap()],
  // One file, which names no other: it can be copied, renamed and started from another origin.
  worker: { format: 'es', rollupOptions: { output: { codeSplitting: false } } },
  resolve: {
    // Makes `onnxruntime-web/wasm` the build that fetches its two files from the addresses we give
    // it, rather than the one with its loader inlined, which hangs inside another's module worker.
    conditions: ['onnxruntime-web-use-extern-wasm', ...defaultClientConditions],
  },
  build: {
    // `npm run build` has budgets of its own.
    chunkSizeWarningLimit: 1000,
    reportCompressedSize: false,
    rollupOptions: {
      checks: { pluginTimings: false },
      input: { demo: 'index.html', ...Object.fromEntries(lastingInputs) },
      // What they export can be imported by those names.
      preserveEntrySignatures: 'exports-only',
      output: {
        entryFileNames: ({ name }) =>
          `${name}.js` in LASTING ? '[name].js' : 'assets/[name]-[hash].js',
      },
    },
  },
  server: {
    // Python's environment and the training's results: tens of thousands of files, none of them ours.
    watch: { ignored: ['**/export/**', '**/runs/**'] },
  },
  optimizeDeps: {
    entries: ['*.html', 'web/**/*.html'],
    // Left as they are: bundled already, and loaded by their address.
    exclude: ['onnxruntime-web', '@mediapipe/tasks-vision'],
    // Reached only from the worker or by a dynamic import: found late, they would reload the page.
    include: ['comlink', 'mediabunny', 'valibot'],
  },
});
