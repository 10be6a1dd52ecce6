import { expect, it } from 'vitest';
import { checkSupport } from '../../web/engine/support.ts';

const FULL = { VideoDecoder: class {}, OffscreenCanvas: class {}, WebAssembly };

it('lets a browser pass that has everything', () => {
  expect(() => checkSupport(FULL)).not.toThrow();
});

it.each([
  ['VideoDecoder', /WebCodecs/],
  ['OffscreenCanvas', /OffscreenCanvas/],
  ['WebAssembly', /WebAssembly/],
] as const)('names what is missing: %s', (feature, name) => {
  const { [feature]: _, ...rest } = FULL;
  expect(() => checkSupport(rest)).toThrow(name);
  expect(() => checkSupport(rest)).toThrow(
    expect.objectContaining({ code: 'browser-unsupported' }),
  );
});
