import { DeciWatchError } from '../errors.ts';
import { faultIn } from '../estimators/check-estimate.ts';
import type { PoseEstimate, PoseEstimator } from '../estimators/estimator.ts';
import type { CallerEstimatorMessage, Look } from './messages.ts';

/** The last call of each estimator, over all jobs: one that was aborted leaves a call behind. */
const lastCalls = new WeakMap<PoseEstimator, Promise<unknown>>();

/**
 * The page's half of an estimator that the caller brought: it stays on the caller's thread, and the
 * worker sends it each watched frame.
 */
export class CallerEstimator {
  #failure: DeciWatchError | null = null;

  /** @throws DeciWatchError `bad-option` where it is none */
  constructor(
    private readonly estimator: PoseEstimator,
    private readonly signal: AbortSignal,
  ) {
    const fault = faultOf(estimator);
    if (!fault) return;
    throw new DeciWatchError(
      'bad-option',
      `The option estimator is neither a name nor a PoseEstimator: ${fault}.`,
    );
  }

  /** What the first call that failed failed with. */
  get failure(): DeciWatchError | null {
    return this.#failure;
  }

  /** What the worker has to know of it, in values that can be sent whatever the caller's are made of. */
  get message(): CallerEstimatorMessage {
    const { name, flops, skeleton } = this.estimator;
    return {
      name,
      flops,
      skeleton: {
        name: skeleton.name,
        joints: [...skeleton.joints],
        bones: skeleton.bones.map(([from, to]) => [from, to] as const),
        sides: [...skeleton.sides],
        root: [...skeleton.root],
      },
    };
  }

  /** What the worker calls. Never rejects: errors lose all but their message on the way. */
  readonly look: Look = async (image, timeMs) => {
    try {
      const answer = await this.#ask(image, timeMs);
      const fault = faultIn(answer, this.estimator.skeleton.joints.length);
      if (fault) throw new TypeError(fault);
      return { kind: 'seen', estimate: answer && copyOf(answer) };
    } catch (cause) {
      const { name } = this.estimator;
      const at = (timeMs / 1000).toFixed(2);
      const words = (cause instanceof Error ? cause.message : String(cause)).replace(/\.$/, '');
      this.#failure = new DeciWatchError(
        'estimator-failed',
        `The estimator ${name} failed on the frame at ${at} s (${words}): ` +
          'correct it, or choose another estimator.',
        { cause },
      );
      return { kind: 'failed', message: this.#failure.message };
    } finally {
      image.close();
    }
  };

  #ask(image: ImageBitmap, timeMs: number): Promise<PoseEstimate | null> {
    const before = lastCalls.get(this.estimator) ?? Promise.resolve();
    const call = before.then(() => {
      this.signal.throwIfAborted();
      return this.estimator.estimate(image, timeMs);
    });
    lastCalls.set(
      this.estimator,
      call.catch(() => {}),
    );
    return call;
  }
}

/** Its values alone: a view that is sent takes all of its buffer along. */
function copyOf({ keypoints2d, keypoints3d, scores }: PoseEstimate): PoseEstimate {
  return {
    keypoints2d: keypoints2d.slice(),
    keypoints3d: keypoints3d?.slice() ?? null,
    scores: scores.slice(),
  };
}

/** For callers whom no compiler has told. */
function faultOf(estimator: Partial<PoseEstimator> | null): string | null {
  if (typeof estimator !== 'object' || estimator === null) return `it is ${estimator}`;
  const { name, flops, skeleton, estimate } = estimator;
  if (typeof name !== 'string' || name === '') return 'it has no name';
  if (typeof estimate !== 'function') return `${name} has no method estimate`;
  if (!(typeof flops === 'number' && flops >= 0 && flops < Number.POSITIVE_INFINITY)) {
    return `the flops of ${name} are ${flops}; 0 where they are not known`;
  }
  const { joints, bones, sides, root } = skeleton ?? {};
  if (!joints?.length || !bones || sides?.length !== joints.length || !root) {
    return `${name} has no skeleton; skeletonFrom makes one`;
  }
  const unknown = [...bones.flat(), ...root].find((joint) => joints[joint] === undefined);
  return unknown === undefined ? null : `the skeleton of ${name} has no joint ${unknown}`;
}
