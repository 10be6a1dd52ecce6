import { defaultClientConditions, defineConfig } from 'vite';

export default defineConfig({
  // Relative, so that the built site works from any folder of any host.
  base: './',
  worker: { format: 'es' },
  resolve: {
    // Makes `onnxruntime-web/wasm` the build that fetches its two files from the addresses we give
    // it, rather than the one with its loader inlined, which hangs inside another's module worker.
    conditions: ['onnxruntime-web-use-extern-wasm', ...defaultClientConditions],
  },
  optimizeDeps: {
    // Left as it is: it finds its own files, and needs no bundling.
    exclude: ['onnxruntime-web'],
    // Reached only from the worker or by a dynamic import: found late, they would reload the page.
    include: ['@mediapipe/tasks-vision', 'comlink', 'mediabunny', 'valibot'],
  },
});
