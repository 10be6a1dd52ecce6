import * as Comlink from 'comlink';
import { DeciWatchError } from '../errors.ts';
import type { EstimatorName } from '../estimators/names.ts';
import { BLAZEPOSE_33 } from '../pose/blazepose33.ts';
import { haveSameJoints } from '../pose/skeleton.ts';
import { openFile } from '../sources/file.ts';
import type { Failure, WatchAnswer } from './live/messages.ts';
import { PictureCanvas } from './live/picture-canvas.ts';
import { LiveWork } from './live/work.ts';
import type { EngineWorker, JobMessage, Look, Outcome, ProgressListener } from './messages.ts';
import { type BorrowedEstimator, Models } from './models.ts';
import { ProgressReporter } from './progress.ts';
import { recoverClip } from './recover-clip.ts';
import { RemoteEstimator } from './remote-estimator.ts';
import { checkSupport } from './support.ts';
import type { RecoveredClip } from './types.ts';

let models: Models | undefined;
let current: AbortController | undefined;
let live: LiveWork | undefined;
const pictures = new PictureCanvas();

async function run(
  { file, name, every, estimator, files }: JobMessage,
  look: Look | null,
  progress: ProgressReporter,
  signal: AbortSignal,
): Promise<RecoveredClip> {
  checkSupport();
  // Opened first: a file that cannot be used costs no download.
  const clip = await openFile(file, name, signal);
  let borrowed: BorrowedEstimator | undefined;
  try {
    const { frameCount } = clip.info;
    models ??= new Models(files);
    progress.report('loading', 0, 0, frameCount);
    const caller =
      typeof estimator === 'string' ? null : new RemoteEstimator(estimator, look!, signal);
    // What the nets cannot take costs no download of them.
    const needsNets = !caller || haveSameJoints(caller.skeleton, BLAZEPOSE_33);
    const recoverer = needsNets ? await models.recoverer(signal) : null;
    signal.throwIfAborted();
    progress.report('loading', 0.5, 0, frameCount);
    if (!caller) borrowed = await models.borrow(estimator as EstimatorName, signal);
    signal.throwIfAborted();
    const used = caller ?? borrowed!.estimator;
    return await recoverClip({ clip, estimator: used, recoverer, every, progress, signal });
  } finally {
    borrowed?.release();
    clip.close();
  }
}

function failure(error: unknown, signal: AbortSignal): Outcome {
  return signal.aborted ? { kind: 'aborted' } : failureOf(error);
}

function failureOf(error: unknown): Failure {
  if (error instanceof DeciWatchError) {
    return { kind: 'failed', code: error.code, message: error.message };
  }
  return { kind: 'crashed', message: error instanceof Error ? error.message : String(error) };
}

const engine: EngineWorker = {
  async recover(job, onProgress, look) {
    const controller = new AbortController();
    const { signal } = controller;
    current = controller;
    const progress = new ProgressReporter(onProgress);
    try {
      const clip = await run(job, look, progress, signal);
      // Progress and the result go by different ports, which keep no order between them.
      await progress.finish(clip.source.frameCount);
      return Comlink.transfer<Outcome>({ kind: 'done', clip }, buffersOf(clip));
    } catch (error) {
      return failure(error, signal);
    } finally {
      current = undefined;
      for (const proxy of [onProgress, look]) release(proxy);
    }
  },
  abort() {
    current?.abort();
  },
  async prepareLive(needs) {
    try {
      checkSupport();
      models ??= new Models(needs.files);
      live ??= new LiveWork(models);
      return { kind: 'ready', estimatorFlops: await live.prepare(needs) };
    } catch (error) {
      return failureOf(error);
    }
  },
  async watch(image, request) {
    try {
      if (!live) throw new Error('live playback has not been prepared');
      const picture = pictures.draw(image);
      // Before the look, which takes long: the camera has few frames to lend.
      image.close();
      const answer = await live.watch(picture, request);
      return Comlink.transfer(answer, chunkBuffers(answer));
    } catch (error) {
      return failureOf(error);
    } finally {
      image.close();
    }
  },
  async recoverStretch(stretch) {
    try {
      models ??= new Models(stretch.files);
      live ??= new LiveWork(models);
      const clip = await live.recoverStretch(stretch);
      return Comlink.transfer<Outcome>({ kind: 'done', clip }, buffersOf(clip));
    } catch (error) {
      return failureOf(error);
    }
  },
  stopLive() {
    live?.stop();
  },
};

/** Closes the port that a function of the page's is reached by. */
function release(proxy: ProgressListener | Look | null): void {
  (proxy as Partial<Comlink.ProxyMethods> | null)?.[Comlink.releaseProxy]?.();
}

function buffersOf({ poses2d, poses3d }: RecoveredClip): Transferable[] {
  const sequences = poses3d ? [poses2d, poses3d] : [poses2d];
  const arrays = sequences.flatMap((p) => [p.times, p.values, p.scores, p.watched]);
  // The two sequences share some of them, and a buffer can be handed over once only.
  return [...new Set(arrays.map(({ buffer }) => buffer as ArrayBuffer))];
}

function chunkBuffers(answer: WatchAnswer): Transferable[] {
  if (answer.kind !== 'watched' || !answer.chunk) return [];
  const { values2d, values3d, scores } = answer.chunk;
  return [values2d, values3d, scores].map(({ buffer }) => buffer as ArrayBuffer);
}

Comlink.expose(engine);
