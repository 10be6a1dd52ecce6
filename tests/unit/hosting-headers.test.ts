import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { parseHeadersFile } from '../e2e/headers-file.ts';

describe('a _headers file', () => {
  test('adds up the rules that match, and joins a header that is given twice', () => {
    const headers = parseHeadersFile(
      '# all\n/*\n  A: 1\n  B: x: y\n\n/a/*.js\n  A: 2\n/a\n  C: 3\n',
    );
    expect([...headers('/a/b.js')]).toEqual([
      ['a', '1, 2'],
      ['b', 'x: y'],
    ]);
    expect(headers('/a').get('c')).toBe('3');
    expect(headers('/a/b_js').get('a')).toBe('1');
  });

  test('the shipped one gives no header twice, and caches for ever only what has a digest', () => {
    const text = readFileSync(new URL('../../public/_headers', import.meta.url), 'utf8');
    const headers = parseHeadersFile(text);
    const caching = (path: string) => headers(path).get('cache-control');
    for (const path of ['/assets/a-1234.wasm', '/models/a.onnx', '/estimators/a.task']) {
      expect(caching(path)).toBe('public, max-age=31536000, immutable');
    }
    const named = ['/', '/index.html', '/widget.js', '/sw.js', '/offline.json'];
    for (const path of [...named, '/models/manifest.json', '/estimators/manifest.json']) {
      expect(caching(path)).toBe('no-cache');
    }
    for (const path of ['/', '/assets/a.js', '/models/a.onnx', '/samples/walk.mp4']) {
      expect(headers(path).get('access-control-allow-origin')).toBe('*');
    }
  });
});
