import type { EstimatorManifest } from '../../estimators/manifest.ts';
import { ESTIMATOR_NAMES } from '../../estimators/names.ts';
import type { ModelManifest } from '../../recovery/manifest.ts';
import { type Bundle, chunkOf, reachable } from './bundle.ts';
import type { Budget, SizeGroup } from './sizes.ts';

/** The sources that the two entries are known by. */
const DEMO = '/web/app/main.ts';
const WIDGET = '/web/player/player.ts';

/** Bytes, brotli; MB are millions. */
export interface Limits {
  readonly widget: number;
  readonly firstUse: number;
}

export const LIMITS: Limits = { widget: 250e3, firstUse: 12e6 };

/** The parts of the site, and what of them has a budget. */
export interface SiteParts {
  readonly groups: readonly SizeGroup[];
  readonly budgets: readonly Budget[];
}

/** Sorts the site's files: code by the build's own graph, models by their manifests. */
export function siteParts(
  bundle: Bundle,
  { pairs }: Pick<ModelManifest, 'pairs'>,
  { estimators }: Pick<EstimatorManifest, 'estimators'>,
  limits: Limits,
): SiteParts {
  const runtime = [...bundle.assets.keys()].filter((file) => isRuntime(bundle, file));
  const code = (source: string) => {
    const chunk = chunkOf(bundle, source);
    if (!chunk) throw new Error(`The build has nothing of ${source}.`);
    return [...reachable(bundle, chunk.file)].filter((file) => !isRuntime(bundle, file));
  };
  const widget = code(WIDGET);
  const demo = [...code(DEMO), 'index.html', 'sw.js'];
  const listed = Object.values(pairs);
  const nets = listed.flatMap(({ denoise, recover }) => [denoise, recover]).map(model);
  const forecasts = listed.flatMap(({ forecast }) => (forecast ? [model(forecast)] : []));
  const manifests = ['models/manifest.json', 'estimators/manifest.json'];
  const bundles = ESTIMATOR_NAMES.map((name) => ({
    name: `estimator, ${name}`,
    files: [`estimators/${estimators[name].file}`],
  }));
  const lite = `estimators/${estimators.lite.file}`;
  return {
    groups: [
      { name: 'widget code', files: widget },
      { name: 'runtime (ONNX Runtime, MediaPipe)', files: runtime },
      { name: 'nets', files: nets },
      { name: 'forecasts', files: forecasts },
      { name: 'manifests', files: manifests },
      ...bundles,
      { name: 'code of the demo alone', files: demo.filter((file) => !widget.includes(file)) },
    ],
    budgets: [
      { name: 'widget before any model', files: widget, limit: limits.widget },
      {
        name: 'first use with lite',
        files: [...widget, ...runtime, ...nets, ...manifests, lite],
        limit: limits.firstUse,
      },
    ],
  };
}

const model = ({ file }: { readonly file: string }) => `models/${file}`;

/** WebAssembly and its loaders are copied from their packages; workers and styles are compiled. */
function isRuntime({ assets }: Bundle, file: string): boolean {
  return assets.get(file)?.includes('node_modules/') ?? false;
}
