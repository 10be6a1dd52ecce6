import * as ort from 'onnxruntime-web/wasm';
import clips from '../fixtures/clips.json';

/** What `clips.json` says of a test clip, measured when it was made. */
export interface TestClip {
  readonly width?: number;
  readonly height?: number;
  /** Frames that can be decoded. */
  readonly frames: number;
  /** Seconds. */
  readonly times: readonly number[];
}

export type ClipName = keyof typeof clips.clips;

/** What is known of a clip in `tests/fixtures`. */
export function known(name: ClipName): TestClip {
  return clips.clips[name];
}

/** A file of `tests/fixtures`. */
export function fixture(name: string): Promise<Blob> {
  return fetchBlob(new URL(`../fixtures/${name}`, import.meta.url));
}

/** The bundled sample: one person who walks. */
export function walk(): Promise<Blob> {
  return fetchBlob('/samples/walk.mp4');
}

/** A session of one of the two models that find colours, which `fixture_estimators.py` wrote. */
export async function colourSession(kind: 'heatmap' | 'simcc'): Promise<ort.InferenceSession> {
  const blob = await fetchBlob(`/tests/fixtures/onnx-estimators/${kind}.onnx`);
  const model = new Uint8Array(await blob.arrayBuffer());
  return ort.InferenceSession.create(model, { executionProviders: ['wasm'] });
}

async function fetchBlob(url: string | URL): Promise<Blob> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} is missing`);
  return response.blob();
}
