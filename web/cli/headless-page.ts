import { createEngine } from '../engine/client.ts';
import type { RecoverProgress } from '../engine/types.ts';
import { DeciWatchError } from '../errors.ts';
import type { EstimatorName } from '../estimators/names.ts';
import { stringifyPoseFile, toPoseFile } from '../formats/pose-file.ts';

/** What the page answers for one clip; it crosses to Node as JSON. */
export type HeadlessAnswer =
  | { readonly ok: true; readonly poseFile: string }
  | { readonly ok: false; readonly code: string; readonly message: string };

declare global {
  interface Window {
    /** Recovers the clip chosen in the page's file input. */
    recoverChosenClip?: (every: number, estimator: EstimatorName) => Promise<HeadlessAnswer>;
    /** Given by Node. */
    reportProgress?: (progress: RecoverProgress) => void;
  }
}

const engine = createEngine();
const input = document.querySelector<HTMLInputElement>('#clip')!;

window.recoverChosenClip = async (every, estimator) => {
  const clip = input.files?.[0];
  if (!clip) return { ok: false, code: 'bad-option', message: 'No clip was chosen.' };
  try {
    const recovered = await engine.recover(clip, clip.name, {
      every,
      estimator,
      onProgress: (progress) => window.reportProgress?.(progress),
    });
    return { ok: true, poseFile: stringifyPoseFile(toPoseFile(recovered)) };
  } catch (error) {
    if (error instanceof DeciWatchError) {
      return { ok: false, code: error.code, message: error.message };
    }
    throw error;
  }
};
