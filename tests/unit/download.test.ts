import * as v from 'valibot';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { fetchListed, fetchManifest } from '../../web/download.ts';

const SET = { manifest: 'https://host/models/manifest.json' };
const ENTRY = { file: 'net.onnx', bytes: 8, sha256: 'a'.repeat(64) };

afterEach(() => vi.unstubAllGlobals());

function answer(body: BodyInit): void {
  vi.stubGlobal('fetch', async () => new Response(body));
}

/** Sends half of it, and breaks off. */
function broken(): ReadableStream {
  return new ReadableStream({
    start(controller) {
      controller.enqueue(new TextEncoder().encode('{"pai'));
      controller.error(new TypeError('network error'));
    },
  });
}

describe('what breaks off half-way', () => {
  test('is missing: neither a crash nor another file', async () => {
    answer(broken());
    const file = fetchListed(SET, ENTRY);
    await expect(file).rejects.toMatchObject({ code: 'model-missing' });
    await expect(file).rejects.toThrow(/net\.onnx.*broke off half-way/);
    answer(broken());
    await expect(fetchManifest(SET, v.object({}))).rejects.toMatchObject({ code: 'model-missing' });
  });

  test('says so when it was aborted', async () => {
    answer(broken());
    const signal = AbortSignal.abort(new DOMException('enough', 'AbortError'));
    await expect(fetchListed(SET, ENTRY, signal)).rejects.toMatchObject({ name: 'AbortError' });
  });
});

test('a manifest that is no JSON, or another one, is told as such', async () => {
  answer('<html>');
  await expect(fetchManifest(SET, v.object({}))).rejects.toThrow(/it is not JSON/);
  answer('{"pairs": 3}');
  const schema = v.object({ pairs: v.string() });
  await expect(fetchManifest(SET, schema)).rejects.toMatchObject({ code: 'model-mismatch' });
});
