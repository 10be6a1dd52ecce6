import workerUrl from './worker.ts?worker&url';

/**
 * Starts the engine's worker. A browser starts a worker only from the page's own origin; for a widget
 * that comes from another one, a worker of the page's own imports it.
 */
export function startWorker(): Worker {
  const url = new URL(workerUrl, import.meta.url);
  if (url.origin === location.origin) return new Worker(url, { type: 'module', name: 'deciwatch' });
  const source = new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' });
  // Not revoked: some browsers look it up later than here.
  return new Worker(URL.createObjectURL(source), { type: 'module', name: 'deciwatch' });
}
