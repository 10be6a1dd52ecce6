import { describe, expect, test } from 'vitest';
import { cachePrefix, digestIn, isImmutable, scopeOf } from '../../web/app/offline/addresses.ts';
import {
  estimatorWords,
  failureWords,
  spokenProgress,
} from '../../web/app/offline/offline-words.ts';
import { bytesOf, entriesFor, type Release } from '../../web/app/offline/release.ts';

const scope = scopeOf('https://host.test/some/folder/index.html?a=1#b');

describe('addresses of a page that is kept', () => {
  test('the scope is the page’s folder, and so are its caches', () => {
    expect(scope.href).toBe('https://host.test/some/folder/');
    expect(cachePrefix(scope)).not.toBe(cachePrefix(scopeOf('https://host.test/some/')));
  });

  test.each([
    ['assets/demo-1234.js', true],
    ['models/a.onnx?0123456789abcdef', true],
    ['models/a.onnx', false],
    ['models/manifest.json', false],
    ['./', false],
    ['./?utm=0123456789abcdef', false],
    ['samples/assets/walk.mp4', false],
  ])('%s never changes: %s', (file, immutable) => {
    expect(isImmutable(new URL(file, scope), scope)).toBe(immutable);
  });

  test('a digest is read from the query', () => {
    expect(digestIn(new URL('a?0123456789abcdef', scope))).toBe('0123456789abcdef');
    expect(digestIn(new URL('a?v=1', scope))).toBe('');
  });
});

test('a release for some estimators leaves the others out', () => {
  const file = (name: string, bytes: number) => ({ file: name, bytes, sha256: '' });
  const release: Release = {
    format: 'deciwatch-offline/1',
    release: '0123456789abcdef',
    files: [
      file('./', 1),
      { ...file('lite', 10), estimator: 'lite' },
      { ...file('heavy', 100), estimator: 'heavy' },
    ],
  };
  expect(bytesOf(entriesFor(release, []))).toBe(1);
  expect(bytesOf(entriesFor(release, ['heavy']))).toBe(101);
});

describe('words', () => {
  test('progress is said at each quarter', () => {
    const said = Array.from({ length: 101 }, (_, done) => spokenProgress(done, 100));
    expect(new Set(said).size).toBe(5);
    expect(said[60]).toMatch(/50 %/);
  });

  test('one estimator or several', () => {
    expect(estimatorWords(['full'])).toBe('the full estimator');
    expect(estimatorWords(['lite', 'full', 'heavy'])).toBe('the lite, full, and heavy estimators');
  });

  test('each failure says what to do, in one sentence', () => {
    const reasons = ['no-room', 'no-answer', 'another-file', 'no-worker', 'busy'] as const;
    for (const why of reasons) expect(failureWords(why)).toMatch(/^[A-Z][^.]*: [^.]*\.$/);
  });
});
