/**
 * `npm run docs:api` writes `docs/api.md` from the comments of what the package exports; with `--check`
 * it only says whether that has been done.
 */
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { PROJECT_ROOT } from '../web/cli/site.ts';
import { apiMarkdown, inOrder } from './api-markdown.ts';
import { readPublicApi } from './api-model.ts';
import { topicsIn } from './api-topics.ts';

const FILE = 'docs/api.md';

const HEAD = `# The API

<!-- Written by \`npm run docs:api\` from the comments in web/: change those. -->

All that \`deciwatch-web\` exports; [library.md](library.md) is the guide.

One frame in N is watched. K joints, D dimensions, T frames, S samples. Typed arrays are flat, the last index
fastest: \`values[(t * K + k) * D + d]\`. What is thrown is a [\`DeciWatchError\`](#deciwatcherror) with the code that
is named, unless another error is.
`;

async function main(): Promise<void> {
  const api = await readPublicApi();
  const chapters = [
    {
      heading: '`deciwatch-web`',
      words: 'The engine. All of `deciwatch-web/poses` can be had from here too.',
      entry: api.index,
      topics: topicsIn('web/player/library.ts'),
    },
    {
      heading: '`deciwatch-web/poses`',
      words: 'What needs no engine, and runs in Node and in workers too.',
      entry: api.index,
      topics: topicsIn('web/player/poses.ts'),
    },
    {
      heading: '`deciwatch-web/player`',
      words: 'Importing it registers `<deciwatch-player>`.',
      entry: api.player,
      topics: [
        {
          heading: 'The element',
          names: inOrder(api.player.members, api.text).map(({ displayName }) => displayName),
        },
      ],
    },
  ];
  const text = apiMarkdown(HEAD, chapters, api);
  const file = join(PROJECT_ROOT, FILE);
  if (!process.argv.includes('--check')) return writeFile(file, text);
  if ((await readFile(file, 'utf8').catch(() => '')) === text) return;
  process.stderr.write(`${FILE} is not what the comments say now: run npm run docs:api.\n`);
  process.exitCode = 1;
}

await main();
