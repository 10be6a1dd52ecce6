import type { Plugin } from 'vite';

/** Where Vite keeps the function that it puts around every `import()`. */
const HELPER = '\0vite/preload-helper.js';

/**
 * Makes Vite's function around `import()` do nothing but that. Its own fetches styles and modules ahead, which
 * there are none of here; and Vite cannot bundle a module that has been through it once: both bring that name.
 */
export function plainImports(): Plugin {
  return {
    name: 'deciwatch:plain-imports',
    enforce: 'pre',
    load(id) {
      if (id !== HELPER) return null;
      return 'const imported = (load) => load();\nexport { imported as __vitePreload };';
    },
  };
}
