import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { engineFiles } from '../../web/engine/files.ts';
import { MediaPipeEstimator } from '../../web/estimators/mediapipe.ts';
import type { EstimatorName } from '../../web/estimators/names.ts';
import { Avatar, matrixAt } from './avatar.ts';
import { ANSWER_SIZE, type Answer, type Job } from './job.ts';
import { Place } from './surroundings.ts';

declare global {
  interface Window {
    /** Draws a clip, shows every frame of it to the estimator, and gives back what it saw. */
    renderClip?: (jobUrl: string) => Promise<Answer>;
  }
}

const renderer = new WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
const camera = new PerspectiveCamera();
camera.matrixAutoUpdate = false;

/** All that have been drawn: loading one takes longer than drawing a clip. */
const avatars = new Map<string, Promise<Avatar>>();
const estimators = new Map<EstimatorName, Promise<MediaPipeEstimator>>();

function estimatorNamed(name: EstimatorName): Promise<MediaPipeEstimator> {
  let estimator = estimators.get(name);
  if (!estimator) {
    estimator = bytes(`/estimators/pose_landmarker_${name}.task`).then((bundle) =>
      MediaPipeEstimator.create({ name, flops: 0, bundle, files: engineFiles().mediapipe }),
    );
    estimators.set(name, estimator);
  }
  return estimator;
}

async function bytes(url: string): Promise<Uint8Array> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

function avatarFrom(url: string): Promise<Avatar> {
  let avatar = avatars.get(url);
  if (!avatar) {
    avatar = Avatar.load(url);
    avatars.set(url, avatar);
  }
  return avatar;
}

window.renderClip = async (jobUrl) => {
  const job = (await (await fetch(jobUrl)).json()) as Job;
  const numbers = new Float32Array((await bytes(job.data)).buffer);
  const person = await avatarFrom(job.avatar);
  const watching = await Promise.all(job.estimators.map(estimatorNamed));
  const place = new Place(job.surroundings);
  const scene = new Scene();
  scene.background = place.backdrop;
  scene.add(place.group, person.scene);
  renderer.setSize(job.width, job.height, false);
  camera.fov = job.fieldOfView;
  camera.aspect = job.width / job.height;
  camera.near = 0.05;
  camera.updateProjectionMatrix();
  const stride = 16 * (1 + job.nodes.length);
  const answers = watching.map(() => new Float32Array(job.frames * ANSWER_SIZE).fill(Number.NaN));
  const pictures: string[] = [];
  for (let frame = 0; frame < job.frames; frame++) {
    camera.matrix.copy(matrixAt(numbers, frame * stride));
    camera.matrixWorldNeedsUpdate = true;
    person.pose(job.nodes, numbers.subarray(frame * stride + 16, (frame + 1) * stride));
    renderer.render(scene, camera);
    const image = await createImageBitmap(renderer.domElement);
    for (const [index, estimator] of watching.entries()) {
      const answer = answers[index]!.subarray(frame * ANSWER_SIZE, (frame + 1) * ANSWER_SIZE);
      await look(estimator, image, answer);
    }
    image.close();
    if (job.pictures.includes(frame)) pictures.push(renderer.domElement.toDataURL('image/jpeg'));
  }
  place.dispose();
  return { estimates: answers.map(({ buffer }) => base64(new Uint8Array(buffer))), pictures };
};

async function look(
  estimator: MediaPipeEstimator,
  image: ImageBitmap,
  answer: Float32Array,
): Promise<void> {
  const begun = performance.now();
  const seen = await estimator.estimate(image);
  answer[ANSWER_SIZE - 1] = performance.now() - begun;
  if (!seen) return;
  answer.set(seen.keypoints3d, 0);
  answer.set(seen.keypoints2d, 99);
  answer.set(seen.scores, 165);
}

function base64(content: Uint8Array): string {
  let text = '';
  for (let start = 0; start < content.length; start += 0x8000) {
    text += String.fromCharCode(...content.subarray(start, start + 0x8000));
  }
  return btoa(text);
}
