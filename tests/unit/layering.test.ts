import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { importsIn, violation } from './layers.ts';

const web = new URL('../../web/', import.meta.url);

it('lets no folder of web/ import from one above it', () => {
  const files = readdirSync(web, { recursive: true, encoding: 'utf8' });
  const modules = files.filter((file) => file.endsWith('.ts') && !file.endsWith('.d.ts'));
  expect(modules.length).toBeGreaterThan(20);
  const violations = modules.flatMap((file) =>
    importsIn(readFileSync(new URL(file, web), 'utf8')).map((imported) =>
      violation(file, imported),
    ),
  );
  expect(violations.filter(Boolean)).toEqual([]);
});

it('would see an import from above', () => {
  expect(violation('pose/a.ts', '../sampling/b.ts')).toMatch(/stands above/);
  expect(violation('engine/a/b.ts', '../../stage/c.ts')).toMatch(/stands above/);
  expect(violation('pose/a.ts', '../download.ts')).toMatch(/stands above/);
  expect(violation('errors.ts', './pose/skeleton.ts')).toMatch(/stands above/);
  expect(violation('pose/a.ts', '../helpers/b.ts')).toMatch(/no known layer/);
  expect(violation('helpers/b.ts', '../pose/a.ts')).toMatch(/no known layer/);
});

it('lets imports from below, from beside and from outside web/ pass', () => {
  expect(violation('engine/a.ts', '../pose/b.ts')).toBeUndefined();
  expect(violation('engine/a.ts', './b.ts')).toBeUndefined();
  expect(violation('pose/a.ts', '../errors.ts')).toBeUndefined();
  expect(violation('app/a.ts', '../../public/b.json')).toBeUndefined();
});

it('finds every kind of import', () => {
  const text = `
    import { a } from './a.ts';
    import type {
      B,
    } from "./b.ts";
    import './c.ts';
    export * from './d.ts';
    const e = await import('./e.ts');
    const f = new Worker(new URL('./f.ts', import.meta.url));
    import g from './g.wasm?url';
    import { html } from 'lit';
  `;
  expect(importsIn(text)).toEqual(
    ['a.ts', 'b.ts', 'c.ts', 'd.ts', 'e.ts', 'f.ts', 'g.wasm'].map((name) => `./${name}`),
  );
});
