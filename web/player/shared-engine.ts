import { createEngine } from '../engine/client.ts';
import type { Engine } from '../engine/types.ts';

/** An engine that several players use. */
export interface BorrowedEngine {
  readonly engine: Engine;
  /** Gives it back; the last one to do so ends the engine, its worker and its models. Once only. */
  release(): void;
}

const engines = new Map<string, { readonly engine: Engine; users: number }>();

/**
 * The page's engine for one place of models: players that name the same place share its worker and models.
 * @param models as in `EngineOptions`; empty for the module's own
 * @throws DeciWatchError `bad-option`
 */
export function borrowEngine(models: string): BorrowedEngine {
  const known = models !== '' && URL.canParse(models, document.baseURI);
  const key = known ? new URL(models, document.baseURI).href : models;
  let shared = engines.get(key);
  if (!shared) {
    shared = { engine: createEngine(models ? { models } : {}), users: 0 };
    engines.set(key, shared);
  }
  const { engine } = shared;
  shared.users++;
  let returned = false;
  return {
    engine,
    release() {
      if (returned) return;
      returned = true;
      const entry = engines.get(key);
      if (!entry || --entry.users > 0) return;
      engines.delete(key);
      engine.close();
    },
  };
}
