/**
 * What the page and its service worker must agree on. A copy for offline use is one cache for each release
 * of the site; it counts only once the list that it was made from is in it, which is put there last.
 */

/** The list of a release's files, relative to the page's folder. */
export const LIST = 'offline.json';

/** Caches belong to an origin, on which there may be several such pages, in different folders. */
export function cachePrefix(scope: URL): string {
  return `deciwatch ${scope.pathname} `;
}

/** The page's folder, which is also what the service worker sees the requests of. */
export function scopeOf(page: string): URL {
  const scope = new URL('.', page);
  scope.search = '';
  scope.hash = '';
  return scope;
}

/** An address whose file never changes: its name or its query has the file's digest. */
export function isImmutable(url: URL, scope: URL): boolean {
  return url.pathname.startsWith(`${scope.pathname}assets/`) || digestIn(url) !== '';
}

/** The beginning of the file's SHA-256, where the address carries it. */
export function digestIn(url: URL): string {
  return /^\?([0-9a-f]{16})$/.exec(url.search)?.[1] ?? '';
}

/** The caches whose copy is whole, the newest last. */
export async function wholeCopies(scope: URL): Promise<{ name: string; cache: Cache }[]> {
  const prefix = cachePrefix(scope);
  const names = (await caches.keys()).filter((name) => name.startsWith(prefix));
  const opened = await Promise.all(
    names.map(async (name) => {
      const cache = await caches.open(name);
      return (await cache.match(new URL(LIST, scope))) ? [{ name, cache }] : [];
    }),
  );
  return opened.flat();
}
