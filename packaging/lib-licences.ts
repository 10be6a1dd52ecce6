import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { PROJECT_ROOT } from '../web/cli/site.ts';

const PACKAGE = /\/node_modules\/((?:@[^/]+\/)?[^/]+)\//;

const MIT = `Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.`;

/** What packages say that come without a licence's text. */
const TEXTS: Readonly<Record<string, string>> = {
  '@mediapipe/tasks-vision':
    'Copyright The MediaPipe Authors.\n\nThe Apache License, Version 2.0: the text is in the file LICENSE of this package.',
  'onnxruntime-web': `MIT License\n\nCopyright (c) Microsoft Corporation\n\n${MIT}`,
};

/**
 * Writes the licences of all packages that are bundled, or copied, into `LICENSES.md`. To be given to the
 * worker's build too: Vite's own option knows nothing of that.
 */
export function libLicences(): { readonly page: Plugin; readonly worker: () => Plugin[] } {
  const found = new Set<string>();
  const collect: Plugin['generateBundle'] = (_, bundle) => {
    for (const output of Object.values(bundle)) {
      const files = output.type === 'chunk' ? output.moduleIds : output.originalFileNames;
      for (const file of files) {
        const name = PACKAGE.exec(`/${file}`)?.[1];
        if (name) found.add(name);
      }
    }
  };
  const page: Plugin = {
    name: 'deciwatch:lib-licences',
    generateBundle(options, bundle, isWrite) {
      collect.call(this, options, bundle, isWrite);
      const sections = [...found].sort().map(section);
      const head =
        'The code of these packages is part of the files here. Models and clips: THIRD_PARTY.md.\n';
      const source = `# Licences\n\n${head}\n${sections.join('\n')}`;
      this.emitFile({ type: 'asset', fileName: 'LICENSES.md', source });
    },
  };
  const inWorker: Plugin = { name: 'deciwatch:worker-licences', generateBundle: collect };
  return { page, worker: () => [inWorker] };
}

function section(name: string): string {
  const folder = join(PROJECT_ROOT, 'node_modules', name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  const text = TEXTS[name] ?? (file && readFileSync(join(folder, file), 'utf8'));
  if (!text)
    throw new Error(`${name} comes without its licence's text: find it, and name it here.`);
  return `## ${name} ${version} (${license})\n\n\`\`\`\`text\n${text.trim()}\n\`\`\`\`\n`;
}
