import { defaultClientConditions, defineConfig } from 'vite';

export default defineConfig({
  // Relative, so that the built site works from any folder of any host.
  base: './',
  // One file, which names no other: it can be copied, renamed and started from another origin.
  worker: { format: 'es', rollupOptions: { output: { codeSplitting: false } } },
  resolve: {
    // Makes `onnxruntime-web/wasm` the build that fetches its two files from the addresses we give
    // it, rather than the one with its loader inlined, which hangs inside another's module worker.
    conditions: ['onnxruntime-web-use-extern-wasm', ...defaultClientConditions],
  },
  // three.js, fetched only once the page is there, is 570 kB (143 kB gzip).
  build: { chunkSizeWarningLimit: 600 },
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
