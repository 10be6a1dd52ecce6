import { type Skeleton, skeletonFrom } from './skeleton.ts';

/** In COCO's order, with which other skeletons begin too. */
export const COCO_JOINTS = [
  'nose',
  'left_eye',
  'right_eye',
  'left_ear',
  'right_ear',
  'left_shoulder',
  'right_shoulder',
  'left_elbow',
  'right_elbow',
  'left_wrist',
  'right_wrist',
  'left_hip',
  'right_hip',
  'left_knee',
  'right_knee',
  'left_ankle',
  'right_ankle',
] as const;

/**
 * COCO's 17 keypoints, which most 2D models give: HRNet, ViTPose, RTMPose, YOLO-Pose, MoveNet.
 * @see https://cocodataset.org/#keypoints-2020
 */
export const COCO_17: Skeleton = skeletonFrom('coco-17', COCO_JOINTS, [
  [0, 1],
  [0, 2],
  [1, 2],
  [1, 3],
  [2, 4],
  [3, 5],
  [4, 6],
  [5, 6],
  [5, 7],
  [7, 9],
  [6, 8],
  [8, 10],
  [5, 11],
  [6, 12],
  [11, 12],
  [11, 13],
  [13, 15],
  [12, 14],
  [14, 16],
]);
