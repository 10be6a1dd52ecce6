import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import sirv from 'sirv';
import { PROJECT_ROOT } from '../../web/cli/site.ts';
import { parseHeadersFile } from './headers-file.ts';

/** A request that reached the server. */
export interface ServedRequest {
  readonly method: string;
  /** With its query. */
  readonly path: string;
  /** 0 until all of it was answered. */
  status: number;
  /** `br`, or nothing. */
  encoding: string;
}

export interface ServeOptions {
  /** More headers for a path (without its query), in place of the documented ones of the same name. */
  readonly headers?: (path: string) => Readonly<Record<string, string>>;
  /** Leaves the headers of the shipped `_headers` file out. */
  readonly bare?: boolean;
  /** Answers with this status instead of the file. */
  readonly refuse?: (path: string) => number | undefined;
  readonly port?: number;
}

export interface Served {
  /** Ends in a slash. */
  readonly url: string;
  /** All so far, in the order in which they came. */
  readonly requests: ServedRequest[];
  close(): Promise<void>;
}

/**
 * Serves a folder on 127.0.0.1 as a host does that was set up by docs/hosting.md: with the headers of the
 * `_headers` file that ships, compressed copies where there are any, byte ranges and ETags.
 */
export async function serveFolder(folder: string, options: ServeOptions = {}): Promise<Served> {
  const requests: ServedRequest[] = [];
  const documented = options.bare ? () => new Map() : parseHeadersFile(shippedHeaders(folder));
  const files = sirv(folder, {
    // Reads the folder anew for each request: a test may put a new release there.
    dev: true,
    etag: true,
    brotli: true,
  });
  const server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://host').pathname;
    const entry = {
      method: request.method ?? '',
      path: request.url ?? '',
      status: 0,
      encoding: '',
    };
    requests.push(entry);
    response.on('finish', () => {
      entry.status = response.statusCode;
      entry.encoding = String(response.getHeader('content-encoding') ?? '');
    });
    for (const [name, value] of documented(path)) response.setHeader(name, value);
    const more = Object.entries(options.headers?.(path) ?? {});
    for (const [name, value] of more) response.setHeader(name, value);
    const refused = options.refuse?.(path);
    if (refused === undefined) return files(request, response);
    response.writeHead(refused).end();
  });
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject);
    server.listen(options.port ?? 0, '127.0.0.1', resolve);
  });
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}/`,
    requests,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/** The folder's own, as a host would read it; the project's for a folder that is no whole site. */
function shippedHeaders(folder: string): string {
  const own = join(folder, '_headers');
  return readFileSync(existsSync(own) ? own : join(PROJECT_ROOT, 'public/_headers'), 'utf8');
}
