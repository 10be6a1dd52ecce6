import { readFileSync } from 'node:fs';

/** A file of numbers that `python -m deciwatch fixtures` wrote, in the shape that it has there. */
export function readFixture<T>(name: string): T {
  return readJson(`tests/fixtures/${name}`);
}

/** A JSON file of the repository. */
export function readJson<T>(path: string): T {
  return JSON.parse(readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8')) as T;
}
