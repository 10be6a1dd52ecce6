import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { buildSite } from '../../web/cli/site.ts';

/** The whole site in a folder of its own: the demo, the widget and the models, uncompressed. */
export interface WholeSite {
  readonly folder: string;
  remove(): Promise<void>;
}

/** Builds the site as `npm run build` does. */
export async function buildWholeSite(): Promise<WholeSite> {
  const folder = await mkdtemp(join(tmpdir(), 'deciwatch-whole-'));
  const remove = () => rm(folder, { recursive: true, force: true });
  try {
    await buildSite(folder);
    return { folder, remove };
  } catch (error) {
    await remove();
    throw error;
  }
}
