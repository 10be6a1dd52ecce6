import { DeciWatchError } from '../errors.ts';

/** The smallest module with a SIMD instruction (`i32.const 0`, `i8x16.splat`, `i8x16.popcnt`). */
const SIMD_MODULE = Uint8Array.of(
  0,
  97,
  115,
  109,
  1,
  0,
  0,
  0,
  1,
  5,
  1,
  96,
  0,
  1,
  123,
  3,
  2,
  1,
  0,
  10,
  10,
  1,
  8,
  0,
  65,
  0,
  253,
  15,
  253,
  98,
  11,
);

/**
 * Checks that this browser has what the engine is built on.
 * @param scope the global scope to look in
 * @throws DeciWatchError `browser-unsupported`, naming the first thing that is missing
 */
export function checkSupport(scope: object = globalThis): void {
  const missing = firstMissing(scope);
  if (!missing) return;
  throw new DeciWatchError(
    'browser-unsupported',
    `This browser has no ${missing} for this page: open it over https in a current Chrome, Edge, Firefox or Safari.`,
  );
}

function firstMissing(scope: object): string | null {
  // Browsers give WebCodecs to secure contexts only.
  if (!('VideoDecoder' in scope)) return 'WebCodecs';
  if (!('OffscreenCanvas' in scope)) return 'OffscreenCanvas';
  if (!('WebAssembly' in scope)) return 'WebAssembly';
  if (!WebAssembly.validate(SIMD_MODULE)) return 'WebAssembly SIMD';
  return null;
}
