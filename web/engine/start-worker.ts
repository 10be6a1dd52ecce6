import workerUrl from './worker.ts?worker&url';

/** In a constant for webpack's sake: see `files.ts`. */
const HERE = import.meta.url;

/**
 * Starts the engine's worker. A browser starts a worker only from the page's own origin; for a widget
 * that comes from another one, a worker of the page's own imports it.
 */
export function startWorker(): Worker {
  const url = new URL(workerUrl, HERE);
  if (url.origin === location.origin) return new Worker(url, { type: 'module', name: 'deciwatch' });
  return new Worker(importing(url), { type: 'module', name: 'deciwatch' });
}

let loader: string | undefined;

/** Made once and never revoked: some browsers look it up later than when a worker starts. */
function importing(url: URL): string {
  loader ??= URL.createObjectURL(
    new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' }),
  );
  return loader;
}
