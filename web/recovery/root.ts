import type { Skeleton } from '../pose/skeleton.ts';

/**
 * Moves every 3D pose so that its root (the mid-hip) is at the origin. In place; T·K·3 values. A skeleton
 * without a root stays where it is.
 */
export function centreOnRoot(values: Float32Array, { joints, root }: Skeleton): void {
  if (root.length === 0) return;
  const size = joints.length * 3;
  for (let start = 0; start < values.length; start += size) {
    for (let d = 0; d < 3; d++) {
      const middle =
        root.reduce((sum, joint) => sum + values[start + joint * 3 + d]!, 0) / root.length;
      for (let i = start + d; i < start + size; i += 3) values[i]! -= middle;
    }
  }
}
