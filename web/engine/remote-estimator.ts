import * as Comlink from 'comlink';
import { DeciWatchError } from '../errors.ts';
import type { EstimatorImage, PoseEstimate, PoseEstimator } from '../estimators/estimator.ts';
import type { Skeleton } from '../pose/skeleton.ts';
import type { CallerEstimatorMessage, Look } from './messages.ts';

/** The worker's half of an estimator that lives on the caller's thread. */
export class RemoteEstimator implements PoseEstimator {
  readonly name: string;
  readonly flops: number;
  readonly skeleton: Skeleton;

  /** @param signal ends the wait for an answer, which may never come */
  constructor(
    { name, flops, skeleton }: CallerEstimatorMessage,
    private readonly look: Look,
    private readonly signal: AbortSignal,
  ) {
    this.name = name;
    this.flops = flops;
    this.skeleton = skeleton;
  }

  /** @throws DeciWatchError `estimator-failed`; the signal's reason when aborted */
  async estimate(image: EstimatorImage, timeMs: number): Promise<PoseEstimate | null> {
    this.signal.throwIfAborted();
    // A picture of its own: the clip draws its next frame on this one.
    const picture = await createImageBitmap(image);
    const answer = await this.#unlessAborted(
      this.look(Comlink.transfer(picture, [picture]), timeMs),
    );
    if (answer.kind === 'seen') return answer.estimate;
    throw new DeciWatchError('estimator-failed', answer.message);
  }

  close(): void {}

  #unlessAborted<T>(answer: Promise<T>): Promise<T> {
    const { signal } = this;
    return new Promise((resolve, reject) => {
      const abort = () => reject(signal.reason);
      signal.addEventListener('abort', abort, { once: true });
      answer.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
    });
  }
}
