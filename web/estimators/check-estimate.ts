import type { PoseEstimate } from './estimator.ts';

/**
 * Says what is wrong with an estimator's answer, or nothing: `keypoints2d should be … , but is …`.
 * @param answer what came, whatever it is
 * @param joints K
 */
export function faultIn(answer: unknown, joints: number): string | null {
  if (answer === null) return null;
  if (typeof answer !== 'object') return `the answer should be a pose or null, but is ${answer}`;
  const { keypoints2d, keypoints3d, scores } = answer as Partial<PoseEstimate>;
  return (
    faultOf('keypoints2d', keypoints2d, joints * 2) ??
    (keypoints3d === null ? null : faultOf('keypoints3d', keypoints3d, joints * 3)) ??
    faultOf('scores', scores, joints) ??
    outOfRange(scores!)
  );
}

function faultOf(field: string, values: unknown, length: number): string | null {
  const wanted = `${field} should be a Float32Array of ${length} numbers`;
  if (!(values instanceof Float32Array)) return `${wanted}, but is ${kindOf(values)}`;
  if (values.length !== length) return `${wanted}, but has ${values.length}`;
  const bad = values.findIndex((value) => !Number.isFinite(value));
  return bad < 0 ? null : `${field} should be finite, but ${field}[${bad}] is ${values[bad]}`;
}

function outOfRange(scores: Float32Array): string | null {
  const bad = scores.findIndex((score) => score < 0 || score > 1);
  return bad < 0 ? null : `scores should be from 0 to 1, but scores[${bad}] is ${scores[bad]}`;
}

function kindOf(value: unknown): string {
  if (typeof value !== 'object' || value === null) return String(value);
  return `an ${value.constructor?.name ?? 'object'}`;
}
