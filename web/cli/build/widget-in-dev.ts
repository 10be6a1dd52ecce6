import type { Plugin } from 'vite';

/** Serves the widget in development where the built site has it, so that a page works with both. */
export function widgetInDev(source: string): Plugin {
  return {
    name: 'deciwatch-widget-in-dev',
    apply: 'serve',
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        if (request.url?.split('?')[0] !== '/widget.js') return next();
        response.setHeader('Content-Type', 'text/javascript');
        // Other origins' pages may have it, as of a real host.
        response.setHeader('Access-Control-Allow-Origin', '*');
        response.end(`export * from ${JSON.stringify(source)};\n`);
      });
    },
  };
}
