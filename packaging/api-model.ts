import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Extractor, ExtractorConfig, ExtractorLogLevel } from '@microsoft/api-extractor';
import { type ApiEntryPoint, ApiModel } from '@microsoft/api-extractor-model';
import { PROJECT_ROOT } from '../web/cli/site.ts';
import { writeTypes } from './lib-types.ts';

/** What the package's declarations say: each entry's exports, and the text they come from. */
export interface PublicApi {
  readonly index: ApiEntryPoint;
  readonly player: ApiEntryPoint;
  readonly text: string;
}

/** Reads the declarations that the package would have now. */
export async function readPublicApi(): Promise<PublicApi> {
  const folder = await mkdtemp(join(tmpdir(), 'deciwatch-api-'));
  try {
    await writeTypes(folder);
    const files = await readdir(folder, { recursive: true });
    const texts = files
      .filter((file) => file.endsWith('.d.ts'))
      .map((file) => readFile(join(folder, file), 'utf8'));
    const index = extract(folder, 'index', []);
    const inIndex = index.members.map(({ displayName }) => displayName);
    return {
      index,
      player: extract(folder, 'player', inIndex),
      text: (await Promise.all(texts)).join('\n'),
    };
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

/** @param elsewhere names of types that another entry exports */
function extract(folder: string, entry: string, elsewhere: readonly string[]): ApiEntryPoint {
  const declarations = join(folder, `${entry}.d.ts`);
  const apiJsonFilePath = join(folder, `${entry}.api.json`);
  const compilerOptions = {
    target: 'es2022',
    lib: ['es2023', 'dom', 'dom.iterable'],
    module: 'esnext',
    moduleResolution: 'bundler',
    strict: true,
    types: [],
  };
  const config = ExtractorConfig.prepare({
    configObject: {
      mainEntryPointFilePath: declarations,
      projectFolder: PROJECT_ROOT,
      compiler: { overrideTsconfig: { compilerOptions, files: [declarations] } },
      docModel: { enabled: true, apiJsonFilePath },
    },
    configObjectFullPath: undefined,
    packageJsonFullPath: join(PROJECT_ROOT, 'package.json'),
  });
  const complaints: string[] = [];
  Extractor.invoke(config, {
    localBuild: true,
    messageCallback: (message) => {
      message.handled = true;
      const isGrave =
        message.logLevel === ExtractorLogLevel.Error ||
        message.logLevel === ExtractorLogLevel.Warning ||
        (message.messageId === 'ae-forgotten-export' &&
          !elsewhere.some((name) => message.text.includes(`"${name}"`)));
      if (isGrave) complaints.push(message.formatMessageWithLocation(PROJECT_ROOT));
    },
  });
  if (complaints.length > 0) throw new Error(complaints.join('\n'));
  return new ApiModel().loadPackage(apiJsonFilePath).entryPoints[0]!;
}
