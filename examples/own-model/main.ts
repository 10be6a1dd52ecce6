import { COCO_17, HALPE_26, OnnxPoseEstimator, skeletonFrom } from 'deciwatch-web';
import 'deciwatch-web/player';
import * as ort from 'onnxruntime-web/wasm';

const player = document.querySelector('deciwatch-player')!;
const form = document.querySelector('form')!;
const output = document.querySelector('output')!;

form.addEventListener('submit', async (event) => {
  event.preventDefault();
  const chosen = new FormData(form);
  const model = chosen.get('model') as File;
  try {
    const session = await ort.InferenceSession.create(await model.arrayBuffer());
    player.estimator = new OnnxPoseEstimator({
      name: model.name,
      session,
      Tensor: ort.Tensor,
      input: {
        name: session.inputNames[0]!,
        width: Number(chosen.get('width')),
        height: Number(chosen.get('height')),
      },
      decode: chosen.get('decode') as 'simcc' | 'heatmap',
      skeleton: skeletonWith(jointsOf(session)),
    });
    player.every = Number(chosen.get('every'));
    player.srcObject = chosen.get('video') as File;
    await player.play();
  } catch (error) {
    output.value = `This model cannot be used: ${(error as Error).message}`;
  }
});

player.addEventListener('load', ({ detail: { cost, recovery, poses2d } }) => {
  output.value = `${cost.frames} frames of ${poses2d.skeleton.name} from ${cost.estimatorCalls} looks (${recovery}).`;
});
player.addEventListener('error', ({ detail }) => {
  output.value = detail.message;
});

/** K, the second dimension of what such a model gives. */
function jointsOf(session: ort.InferenceSession): number {
  const [output] = session.outputMetadata;
  const joints = output?.isTensor ? output.shape[1] : undefined;
  if (typeof joints === 'number') return joints;
  throw new Error('it does not say how many joints it finds');
}

function skeletonWith(joints: number) {
  if (joints === 17) return COCO_17;
  if (joints === 26) return HALPE_26;
  const names = Array.from({ length: joints }, (_, k) => `joint_${k}`);
  return skeletonFrom(`${joints} joints`, names, []);
}
