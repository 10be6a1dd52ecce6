/**
 * The service worker of a page that is kept for offline use; nobody else's page has one. It stores nothing of
 * its own accord but estimators that come into use: the page fills the copy, so that it can say how far it is
 * and what went wrong.
 */
import { sha256 } from '../../digest.ts';
import { digestIn, isImmutable, scopeOf, wholeCopies } from './addresses.ts';

/** What TypeScript's library for pages does not know. */
interface ServiceWorkerScope {
  skipWaiting(): Promise<void>;
  readonly clients: { claim(): Promise<void> };
  addEventListener(type: 'install', listener: () => void): void;
  addEventListener(type: 'activate', listener: (event: LastingEvent) => void): void;
  addEventListener(type: 'fetch', listener: (event: FetchEvent) => void): void;
}

interface LastingEvent {
  waitUntil(work: Promise<unknown>): void;
}

interface FetchEvent extends LastingEvent {
  readonly request: Request;
  respondWith(response: Promise<Response>): void;
}

const worker = self as unknown as ServiceWorkerScope;
const scope = scopeOf(location.href);

worker.addEventListener('install', () => void worker.skipWaiting());
worker.addEventListener('activate', (event) => event.waitUntil(worker.clients.claim()));
worker.addEventListener('fetch', (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (request.method !== 'GET' || request.headers.has('range')) return;
  if (!url.href.startsWith(scope.href)) return;
  event.respondWith(isImmutable(url, scope) ? keptFirst(event, url) : networkFirst(request, url));
});

async function keptFirst(event: FetchEvent, url: URL): Promise<Response> {
  const kept = await findKept(url);
  if (kept) return kept;
  const response = await fetch(event.request);
  if (response.ok && url.pathname.startsWith(`${scope.pathname}estimators/`)) {
    event.waitUntil(keepToo(url, response.clone()));
  }
  return response;
}

/** The page, the manifests, the sample: of the newest release while there is a connection. */
async function networkFirst(request: Request, url: URL): Promise<Response> {
  try {
    return await fetch(request);
  } catch (error) {
    const kept = await findKept(request.mode === 'navigate' ? pageAddress(url) : url);
    if (kept) return kept;
    throw error;
  }
}

/** The page is kept under its folder's address, whatever the query and whether or not its file is named. */
function pageAddress(url: URL): URL {
  const address = new URL(url.href.replace(/[?#].*/, ''));
  return address.pathname === `${scope.pathname}index.html` ? scope : address;
}

async function findKept(url: URL): Promise<Response | undefined> {
  for (const { cache } of (await wholeCopies(scope)).reverse()) {
    const kept = await cache.match(url, { ignoreVary: true });
    if (kept) return kept;
  }
  return undefined;
}

/** An estimator that somebody uses is wanted offline as well; where there is no room, it is not kept. */
async function keepToo(url: URL, response: Response): Promise<void> {
  const newest = (await wholeCopies(scope)).at(-1);
  if (!newest) return;
  const headers = new Headers(response.headers);
  headers.delete('content-encoding');
  const bytes = await response.arrayBuffer();
  if (!(await sha256(bytes)).startsWith(digestIn(url))) return;
  await newest.cache.put(url, new Response(bytes, { headers })).catch(() => {});
}
