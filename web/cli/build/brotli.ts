import { createHash } from 'node:crypto';
import { mkdir, readFile, rename, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants } from 'node:zlib';

const compress = promisify(brotliCompress);

/** As hard as it goes: done once for each release, read by everybody. */
const QUALITY = 11;

/**
 * Compresses, or looks up what was compressed before: a minute for the WebAssembly, which hardly ever
 * changes. Several calls at once share zlib's threads.
 * @param cache a folder, made where missing
 */
export async function brotli(bytes: Uint8Array, cache: string): Promise<Uint8Array> {
  const digest = createHash('sha256').update(bytes).digest('hex');
  const kept = join(cache, `${digest}-q${QUALITY}.br`);
  try {
    return await readFile(kept);
  } catch {
    // Not compressed before.
  }
  const compressed = await compress(bytes, {
    params: {
      [constants.BROTLI_PARAM_QUALITY]: QUALITY,
      // The widest window that every browser reads.
      [constants.BROTLI_PARAM_LGWIN]: constants.BROTLI_MAX_WINDOW_BITS,
      [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
    },
  });
  await mkdir(cache, { recursive: true });
  // Renamed when whole: another build may be reading.
  const unfinished = `${kept}.${process.pid}`;
  await writeFile(unfinished, compressed);
  await rename(unfinished, kept);
  return compressed;
}
