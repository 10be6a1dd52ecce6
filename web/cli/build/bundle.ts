import type { Rolldown } from 'vite';

/** A chunk of JavaScript, and all that it may load. */
export interface BuiltChunk {
  readonly file: string;
  /** Chunks that it imports, at once or later. */
  readonly imports: readonly string[];
  /** Style sheets, workers, WebAssembly: whatever it names beside chunks. */
  readonly assets: readonly string[];
  /** The source files in it: absolute paths. */
  readonly modules: readonly string[];
}

/** What a build consists of, without the files that are copied as they are. */
export interface Bundle {
  /** By file name, relative to the site's folder. */
  readonly chunks: ReadonlyMap<string, BuiltChunk>;
  /** The source file of each asset that has one: a copy, not compiled. */
  readonly assets: ReadonlyMap<string, string | undefined>;
}

/** A bundle as the sizes and the offline copy see it. */
export function describeBundle(
  output: readonly (Rolldown.OutputChunk | Rolldown.OutputAsset)[],
): Bundle {
  const chunks = new Map<string, BuiltChunk>();
  const assets = new Map<string, string | undefined>();
  for (const item of output) {
    if (item.type === 'asset') {
      assets.set(item.fileName, item.originalFileNames[0]);
      continue;
    }
    const { importedAssets = [], importedCss = [] } = item.viteMetadata ?? {};
    chunks.set(item.fileName, {
      file: item.fileName,
      imports: [...item.imports, ...item.dynamicImports],
      assets: [...importedAssets, ...importedCss],
      modules: item.moduleIds,
    });
  }
  return { chunks, assets };
}

/** Every file that a chunk can load, itself included: chunks first, then what they name. */
export function reachable({ chunks }: Pick<Bundle, 'chunks'>, entry: string): Set<string> {
  const files = new Set([entry]);
  // A set that grows while it is gone through is gone through to its new end.
  for (const file of files) for (const next of chunks.get(file)?.imports ?? []) files.add(next);
  for (const file of [...files])
    for (const asset of chunks.get(file)?.assets ?? []) files.add(asset);
  return files;
}

/** The chunk that a source file was made into. */
export function chunkOf(
  { chunks }: Pick<Bundle, 'chunks'>,
  source: string,
): BuiltChunk | undefined {
  return [...chunks.values()].find(({ modules }) => modules.some((id) => id.endsWith(source)));
}

/** The modules among all that a chunk can load which match: those that should not be there, say. */
export function modulesMatching(bundle: Bundle, entry: string, pattern: RegExp): string[] {
  return [...reachable(bundle, entry)]
    .flatMap((file) => bundle.chunks.get(file)?.modules ?? [])
    .filter((id) => pattern.test(id));
}
