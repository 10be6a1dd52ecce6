import * as ort from 'onnxruntime-web/wasm';

// One thread: the nets are small, and a page need not be cross-origin isolated.
ort.env.wasm.numThreads = 1;

/** Where onnxruntime-web's two files are: absolute addresses. */
export interface RuntimeFiles {
  readonly mjs: string;
  readonly wasm: string;
}

/** To be called before the first net is made. */
export function setRuntimeFiles(files: RuntimeFiles): void {
  ort.env.wasm.wasmPaths = { ...files };
}

/** A float32 array and its shape. */
export interface Matrix {
  readonly data: Float32Array;
  readonly dims: readonly number[];
}

/** onnxruntime-web fails when two sessions run at a time, so that every run waits for the one before. */
let lastRun: Promise<unknown> = Promise.resolve();

/** One ONNX net on the CPU (WebAssembly). */
export class Net {
  private constructor(private readonly session: ort.InferenceSession) {}

  /** @param model the bytes of an ONNX file */
  static async create(model: Uint8Array): Promise<Net> {
    return new Net(await ort.InferenceSession.create(model, { executionProviders: ['wasm'] }));
  }

  /** Runs the net; inputs and outputs by their names in the graph. */
  run(inputs: Readonly<Record<string, Matrix>>): Promise<Record<string, Matrix>> {
    const run = lastRun.then(() => this.runNow(inputs));
    lastRun = run.catch(() => {});
    return run;
  }

  async dispose(): Promise<void> {
    await this.session.release();
  }

  private async runNow(inputs: Readonly<Record<string, Matrix>>): Promise<Record<string, Matrix>> {
    const feeds = mapValues(inputs, ({ data, dims }) => new ort.Tensor('float32', data, dims));
    const fetched = await this.session.run(feeds);
    // The data is a copy on the JavaScript side, which outlives its tensor.
    const outputs = mapValues(fetched, ({ data, dims }) => ({ data: data as Float32Array, dims }));
    for (const tensor of [...Object.values(feeds), ...Object.values(fetched)]) tensor.dispose();
    return outputs;
  }
}

function mapValues<A, B>(record: Readonly<Record<string, A>>, map: (value: A) => B) {
  return Object.fromEntries(Object.entries(record).map(([key, value]) => [key, map(value)]));
}
