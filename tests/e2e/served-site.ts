import { serveFolder } from './static-server.ts';
import { buildWholeSite } from './whole-site.ts';

/** The built site on a host that was set up as docs/hosting.md says. */
export interface ServedSite {
  /** Ends in a slash. */
  readonly url: string;
  close(): Promise<void>;
}

/** Builds the site and serves it, for pages of other hosts too. */
export async function serveBuiltSite(): Promise<ServedSite> {
  const site = await buildWholeSite();
  const served = await serveFolder(site.folder);
  return {
    url: served.url,
    async close() {
      await served.close();
      await site.remove();
    },
  };
}
