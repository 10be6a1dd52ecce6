import { expect, it } from 'vitest';
import { RecordedEstimator } from '../../web/estimators/recorded.ts';
import { parsePoseFile, posesFromFile, toPoseFile } from '../../web/formats/pose-file.ts';
import { recoveredClip } from './recovered-clip.ts';

const clip = recoveredClip(12, [5]);
const K = clip.poses2d.skeleton.joints.length;
const estimator = new RecordedEstimator(clip);

it('answers with what was recorded at that time, as arrays of its own', async () => {
  const answer = (await estimator.estimate(null, (3 / 30) * 1000))!;
  expect(answer.keypoints2d).toEqual(clip.poses2d.values.slice(3 * K * 2, 4 * K * 2));
  expect(answer.keypoints3d).toEqual(clip.poses3d!.values.slice(3 * K * 3, 4 * K * 3));
  expect(answer.scores).toEqual(clip.poses2d.scores.slice(3 * K, 4 * K));
  answer.keypoints2d.fill(0);
  expect(clip.poses2d.values[3 * K * 2]).not.toBe(0);
});

it.each<[number, number | null]>([
  [-0.6, null],
  [-0.4, 0],
  [2.4, 2],
  [2.6, 3],
  [4.6, null], // The nearest frame is one in which nobody was seen.
  [11.4, 11],
  [11.6, null],
])('at frame %f it has frame %o', async (at, frame) => {
  const answer = await estimator.estimate(null, (at / 30) * 1000);
  expect(answer?.keypoints2d[0]).toEqual(
    frame === null ? undefined : clip.poses2d.values[frame * K * 2],
  );
});

it('has no pose in a pause of the recording', async () => {
  const times = clip.poses2d.times.map((time, t) => (t < 6 ? time : time + 1));
  const paused = new RecordedEstimator({ poses2d: { ...clip.poses2d, times }, poses3d: null });
  expect(await paused.estimate(null, 700)).toBeNull();
  expect(await paused.estimate(null, times[6]! * 1000)).not.toBeNull();
});

it('knows a skeleton, a name and FLOPs, and has no 3D where the recording has none', async () => {
  expect(estimator).toMatchObject({
    name: 'recorded',
    flops: 0,
    skeleton: { name: 'blazepose-33' },
  });
  const flat = new RecordedEstimator({ ...clip, poses3d: null }, { name: 'mocap', flops: 7 });
  expect(flat).toMatchObject({ name: 'mocap', flops: 7 });
  expect((await flat.estimate(null, 0))!.keypoints3d).toBeNull();
});

it('replays a pose file', async () => {
  const file = parsePoseFile(JSON.parse(JSON.stringify(toPoseFile(clip))));
  const answer = (await new RecordedEstimator(posesFromFile(file)).estimate(null, 100))!;
  expect(answer.keypoints2d[0]).toBeCloseTo(clip.poses2d.values[3 * K * 2]!, 1);
});

it('of a single frame has that frame', async () => {
  const { poses2d } = recoveredClip(1);
  const one = new RecordedEstimator({ poses2d, poses3d: null });
  expect(await one.estimate(null, 10)).not.toBeNull();
  expect(await one.estimate(null, 20)).toBeNull();
});
