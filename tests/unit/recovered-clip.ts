import { CostMeter } from '../../web/cost/meter.ts';
import type { RecoveredClip } from '../../web/engine/types.ts';
import { BLAZEPOSE_33 } from '../../web/pose/blazepose33.ts';
import type { Dimensions, PoseSequence } from '../../web/pose/sequence.ts';
import { seededRandom } from './random.ts';

/** A clip of frames at 30 a second, watched at N = 10, in which nobody is seen in some frames. */
export function recoveredClip(frames: number, unseen: readonly number[] = []): RecoveredClip {
  const random = seededRandom(frames);
  const joints = BLAZEPOSE_33.joints.length;
  const times = Float64Array.from({ length: frames }, (_, t) => t / 30);
  const watched = Uint8Array.from(times, (_, t) => (t % 10 === 0 || t === frames - 1 ? 1 : 0));
  const scores = Float32Array.from({ length: frames * joints }, random);
  for (const t of unseen) scores.fill(0, t * joints, (t + 1) * joints);
  const sequence = (dims: Dimensions, reach: number): PoseSequence => {
    const size = joints * dims;
    const values = Float32Array.from({ length: frames * size }, () => (random() - 0.3) * reach);
    for (const t of unseen) values.fill(NaN, t * size, (t + 1) * size);
    return { skeleton: BLAZEPOSE_33, dims, times, values, scores, watched };
  };
  const meter = new CostMeter(1.563e9);
  meter.addEstimatorCall(61.5);
  return {
    source: {
      name: 'a "quoted" näme.mp4',
      width: 1280,
      height: 720,
      frameCount: frames,
      frameRate: 30,
      duration: frames / 30,
    },
    interval: 10,
    estimator: { name: 'full', flops: 1.563e9 },
    recovery: 'nets',
    poses2d: sequence(2, 900),
    poses3d: sequence(3, 2),
    cost: meter.report(frames, 1234.5),
  };
}
