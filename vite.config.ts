import { defaultClientConditions, defineConfig } from 'vite';
import { offlinePlugin } from './web/cli/build/offline-plugin.ts';
import { widgetInDev } from './web/cli/build/widget-in-dev.ts';

const WIDGET = '/web/player/player.ts';
const WIDGET_NAME = 'widget';

export default defineConfig({
  // Relative, so that the built site works from any folder of any host.
  base: './',
  plugins: [widgetInDev(WIDGET), offlinePlugin()],
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
      input: { demo: 'index.html', [WIDGET_NAME]: `.${WIDGET}` },
      // What player.ts exports can be imported from widget.js.
      preserveEntrySignatures: 'exports-only',
      output: {
        // Named in other people's pages: it keeps its name from release to release.
        entryFileNames: ({ name }) =>
          name === WIDGET_NAME ? 'widget.js' : 'assets/[name]-[hash].js',
      },
    },
  },
  server: {
    // Python's environment and the training's results: tens of thousands of files, none of them ours.
    watch: { ignored: ['**/export/**', '**/runs/**'] },
  },
  optimizeDeps: {
    entries: ['*.html', 'web/**/*.html'],
    // Left as it is: it is bundled already, and finds files of its own.
    exclude: ['onnxruntime-web'],
    // Reached only from the worker or by a dynamic import: found late, they would reload the page.
    include: ['@mediapipe/tasks-vision', 'comlink', 'mediabunny', 'valibot'],
  },
});
