import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';

/** One page of somebody else's site. */
export interface ForeignPage {
  readonly html: string;
  readonly headers?: Readonly<Record<string, string>>;
}

/** Somebody else's site, on a port of its own. */
export interface ForeignSite {
  /** Ends in a slash. */
  readonly url: string;
  close(): Promise<void>;
}

/** Serves pages by their path: `/` is the first one that a browser asks for. */
export async function servePages(
  pages: Readonly<Record<string, ForeignPage>>,
): Promise<ForeignSite> {
  const server = createServer((request, response) => {
    const page = pages[new URL(request.url ?? '/', 'http://any').pathname];
    response.writeHead(page ? 200 : 404, {
      'Content-Type': 'text/html; charset=utf-8',
      ...page?.headers,
    });
    response.end(page?.html ?? '');
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}/`,
    async close() {
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

/** A page that embeds the widget as the documentation says. */
export function embedding(widget: string, player: string): string {
  return `<!doctype html><html lang="en"><title>Somebody else’s page</title>
    <script type="module" src="${widget}widget.js"></script>
    <main><h1>Somebody else’s page</h1>${player}</main></html>`;
}
