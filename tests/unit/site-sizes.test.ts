import { describe, expect, test } from 'vitest';
import {
  type BuiltChunk,
  type Bundle,
  chunkOf,
  modulesMatching,
  reachable,
} from '../../web/cli/build/bundle.ts';
import { type Limits, siteParts } from '../../web/cli/build/parts.ts';
import { exceeded, type Size, sizeTable, total } from '../../web/cli/build/sizes.ts';

function chunk(file: string, more: Partial<BuiltChunk> = {}): [string, BuiltChunk] {
  return [file, { file, imports: [], assets: [], modules: [], ...more }];
}

/** A demo and a widget that share one chunk, and load another later; one of the demo's own. */
const bundle: Bundle = {
  chunks: new Map([
    chunk('demo.js', {
      imports: ['shared.js', 'stage.js', 'record.js'],
      assets: ['demo.css'],
      modules: ['/x/web/app/main.ts'],
    }),
    chunk('widget.js', { imports: ['shared.js'], modules: ['/x/web/player/player.ts'] }),
    chunk('shared.js', {
      imports: ['stage.js'],
      assets: ['worker.js', 'net.wasm'],
      modules: ['/x/web/engine/client.ts'],
    }),
    // Chunks may import one another.
    chunk('stage.js', { imports: ['shared.js'], modules: ['/x/node_modules/three/three.js'] }),
    chunk('record.js', { modules: ['/x/node_modules/mediabunny/index.js'] }),
  ]),
  assets: new Map([
    ['demo.css', 'index.html'],
    ['worker.js', undefined],
    ['net.wasm', 'node_modules/runtime/net.wasm'],
  ]),
};

const entry = (file: string) => ({ file }) as never;
const models = {
  pairs: {
    '3d': {
      denoise: entry('3d-denoise.onnx'),
      recover: entry('3d-recover.onnx'),
      forecast: entry('3d-forecast.onnx'),
    },
    '2d': { denoise: entry('2d-denoise.onnx'), recover: entry('2d-recover.onnx') },
  } as never,
};
const estimators = {
  estimators: {
    lite: entry('lite.task'),
    full: entry('full.task'),
    heavy: entry('heavy.task'),
  } as never,
};

const FILES = [
  ...bundle.chunks.keys(),
  ...bundle.assets.keys(),
  ...['index.html', 'sw.js', 'models/manifest.json', 'estimators/manifest.json'],
  ...['3d-denoise', '3d-recover', '3d-forecast', '2d-denoise', '2d-recover'].map(
    (net) => `models/${net}.onnx`,
  ),
  ...['lite', 'full', 'heavy'].map((name) => `estimators/${name}.task`),
];
/** Every file is 100 bytes, 10 with brotli. */
const sizes = new Map<string, Size>(FILES.map((file) => [file, { raw: 100, brotli: 10 }]));

describe('the build’s graph', () => {
  test('gives all that an entry can load, now or later, through circles, and nothing else', () => {
    expect([...reachable(bundle, 'widget.js')].sort()).toEqual(
      ['net.wasm', 'shared.js', 'stage.js', 'widget.js', 'worker.js'].sort(),
    );
    expect(reachable(bundle, 'record.js')).toEqual(new Set(['record.js']));
  });

  test('finds an entry by its source, whatever its chunk is called', () => {
    expect(chunkOf(bundle, '/web/player/player.ts')?.file).toBe('widget.js');
    expect(chunkOf(bundle, '/web/nothing.ts')).toBeUndefined();
  });

  test('shows what an entry should not load', () => {
    const pattern = /mediabunny/;
    expect(modulesMatching(bundle, 'widget.js', pattern)).toEqual([]);
    expect(modulesMatching(bundle, 'demo.js', pattern)).toHaveLength(1);
  });
});

describe('sizes', () => {
  const parts = (limits: Limits) => siteParts(bundle, models, estimators, limits);
  const generous = { widget: 1000, firstUse: 1000 };

  test('every file is in one group', () => {
    const { groups } = parts(generous);
    const grouped = groups.flatMap(({ files }) => files);
    expect([...grouped].sort()).toEqual([...FILES].sort());
  });

  test('first use is code, runtime, nets, manifests and one estimator; forecasts come later', () => {
    const first = parts(generous).budgets.find(({ name }) => name === 'first use with lite')!;
    expect([...first.files].sort()).toEqual(
      [
        ...['widget.js', 'shared.js', 'stage.js', 'worker.js', 'net.wasm'],
        ...['3d-denoise', '3d-recover', '2d-denoise', '2d-recover'].map((n) => `models/${n}.onnx`),
        ...['models/manifest.json', 'estimators/manifest.json', 'estimators/lite.task'],
      ].sort(),
    );
  });

  test('a budget that is kept says nothing; each that is not, one sentence', () => {
    expect(exceeded(parts({ widget: 40, firstUse: 120 }).budgets, sizes)).toEqual([]);
    expect(exceeded(parts({ widget: 39, firstUse: 1000 }).budgets, sizes)).toEqual([
      '"widget before any model" is 0.0 kB with brotli, 0.0 kB over its budget of 0.0 kB.',
    ]);
    expect(exceeded(parts({ widget: 1, firstUse: 1 }).budgets, sizes)).toHaveLength(2);
  });

  test('a file counts once, and one that is missing is no zero', () => {
    expect(total(['demo.js', 'demo.js'], sizes)).toEqual({ raw: 100, brotli: 10 });
    expect(() => total(['gone.js'], sizes)).toThrow(/gone\.js/);
  });

  test('the table has kilobytes and megabytes, and what a budget allows', () => {
    const some = new Map([['a', { raw: 2_500_000, brotli: 12_345 }]]);
    const table = sizeTable(
      [{ name: 'code', files: ['a'] }],
      [{ name: 'all', files: ['a'], limit: 250e3 }],
      some,
    );
    expect(table).toMatch(/^code +2\.50 MB +12\.3 kB$/m);
    expect(table).toMatch(/^all +2\.50 MB +12\.3 kB +of 250\.0 kB$/m);
  });
});
