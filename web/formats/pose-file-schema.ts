import * as v from 'valibot';
import type { Recovery } from '../engine/types.ts';
import type { PoseFile } from './pose-file-types.ts';

/** What the first field of every pose file says. */
export const POSE_FILE_FORMAT = 'deciwatch-poses/1';

const RECOVERIES = ['nets', 'cubic'] as const satisfies readonly Recovery[];

// The messages say what belongs in the place; the reader puts the place and what it found to them.
const finite = v.pipe(v.number('a number'), v.finite('a finite number'));
const notNegative = v.pipe(finite, v.minValue(0, 'a number not below 0'));
const score = v.pipe(notNegative, v.maxValue(1, 'a number from 0 to 1'));
const whole = (least: number) => {
  const words = `a whole number from ${least} on`;
  return v.pipe(v.number(words), v.safeInteger(words), v.minValue(least, words));
};
const text = v.string('a text');

const costParts = {
  estimator: notNegative,
  denoise: notNegative,
  recover: notNegative,
  total: notNegative,
};

const cost = v.object(
  {
    frames: whole(1),
    estimatorCalls: whole(0),
    flopsPerFrame: v.object(costParts, 'an object'),
    everyFrameFlopsPerFrame: notNegative,
    /** Null where the estimator's FLOPs are not known. */
    flopsRatio: v.nullable(notNegative),
    msPerFrame: v.object({ ...costParts, decode: notNegative }, 'an object'),
    msPerEstimatorCall: notNegative,
    wallMs: notNegative,
  },
  'an object',
);

const frame = v.object(
  {
    index: whole(0),
    time: finite,
    watched: v.boolean('true or false'),
    keypoints2d: v.nullable(
      v.array(v.strictTuple([finite, finite], 'a list [x, y]'), 'a list of [x, y], or null'),
    ),
    keypoints3d: v.nullable(
      v.array(
        v.strictTuple([finite, finite, finite], 'a list [x, y, z]'),
        'a list of [x, y, z], or null',
      ),
    ),
    scores: v.nullable(v.array(score, 'a list of scores, or null')),
  },
  'an object',
);

/** {@link PoseFile} as it is checked; the two must say the same. */
export const PoseFileSchema = v.object(
  {
    format: v.literal(POSE_FILE_FORMAT, `"${POSE_FILE_FORMAT}"`),
    source: v.object(
      {
        name: text,
        width: whole(1),
        height: whole(1),
        fps: notNegative,
        frames: whole(1),
        duration: notNegative,
      },
      'an object',
    ),
    skeleton: v.object(
      {
        name: text,
        joints: v.pipe(
          v.array(text, 'a list of joint names'),
          v.minLength(1, 'at least one joint'),
        ),
        bones: v.array(
          v.strictTuple([whole(0), whole(0)], 'a pair of joint indices'),
          'a list of pairs of joint indices',
        ),
      },
      'an object',
    ),
    interval: whole(1),
    estimator: v.object({ name: text, flops: notNegative }, 'an object'),
    /** Files of before there was a choice do not say it. */
    recovery: v.optional(v.picklist(RECOVERIES, '"nets" or "cubic"')),
    cost,
    frames: v.pipe(v.array(frame, 'a list of frames'), v.minLength(1, 'at least one frame')),
  },
  'an object',
) satisfies v.GenericSchema<unknown, PoseFile>;
