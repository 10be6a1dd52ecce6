import { COCO_JOINTS } from './coco17.ts';
import { type Skeleton, skeletonFrom } from './skeleton.ts';

/**
 * Halpe's 26 keypoints: COCO's 17, then head, neck, mid-hip and feet. RTMPose's body models give them.
 * @see https://github.com/Fang-Haoshu/Halpe-FullBody
 */
export const HALPE_26: Skeleton = skeletonFrom(
  'halpe-26',
  [
    ...COCO_JOINTS,
    'head',
    'neck',
    'hip',
    'left_big_toe',
    'right_big_toe',
    'left_small_toe',
    'right_small_toe',
    'left_heel',
    'right_heel',
  ],
  [
    [0, 1],
    [0, 2],
    [1, 3],
    [2, 4],
    [17, 18],
    [18, 5],
    [18, 6],
    [5, 7],
    [7, 9],
    [6, 8],
    [8, 10],
    [18, 19],
    [19, 11],
    [19, 12],
    [11, 13],
    [13, 15],
    [12, 14],
    [14, 16],
    [15, 20],
    [15, 22],
    [15, 24],
    [16, 21],
    [16, 23],
    [16, 25],
  ],
);
