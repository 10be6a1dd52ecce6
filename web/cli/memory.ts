import type { CDPSession, Page } from 'playwright-core';

/** What a page and its workers hold after a forced garbage collection. */
export interface Memory {
  /** Bytes of JavaScript objects. */
  readonly heap: number;
  /** Bytes of WebAssembly memories. */
  readonly wasm: number;
  /** `VideoFrame`s that nobody has closed. */
  readonly openFrames: number;
  /** Workers that are alive. */
  readonly workers: number;
}

type Send = (method: string, params?: object) => Promise<Record<string, unknown>>;

/** Asks a page and its workers by the browser's debugging protocol. */
export class MemoryProbe {
  readonly #workers = new Map<string, Send>();

  private constructor(private readonly session: CDPSession) {}

  static async attach(page: Page): Promise<MemoryProbe> {
    const session = await page.context().newCDPSession(page);
    const probe = new MemoryProbe(session);
    session.on('Target.attachedToTarget', ({ sessionId, targetInfo }) => {
      if (targetInfo.type === 'worker')
        probe.#workers.set(sessionId, workerSend(session, sessionId));
    });
    session.on('Target.detachedFromTarget', ({ sessionId }) => probe.#workers.delete(sessionId));
    await session.send('Target.setAutoAttach', {
      autoAttach: true,
      waitForDebuggerOnStart: false,
      flatten: false,
    });
    return probe;
  }

  /** Workers that are alive now. */
  get workers(): number {
    return this.#workers.size;
  }

  async measure(): Promise<Memory> {
    const page: Send = (method, params) =>
      this.session.send(method as 'Runtime.enable', params as never) as never;
    const parts = await Promise.all([page, ...this.#workers.values()].map(measureOne));
    const sum = (key: 'heap' | 'wasm' | 'openFrames') =>
      parts.reduce((total, part) => total + part[key], 0);
    return {
      heap: sum('heap'),
      wasm: sum('wasm'),
      openFrames: sum('openFrames'),
      workers: this.#workers.size,
    };
  }
}

async function measureOne(send: Send) {
  await send('HeapProfiler.enable');
  // Twice: what one collection finalises, the next one frees.
  await send('HeapProfiler.collectGarbage');
  await send('HeapProfiler.collectGarbage');
  const { usedSize } = (await send('Runtime.getHeapUsage')) as { usedSize: number };
  const wasm = await overAll(
    send,
    'WebAssembly.Memory',
    'function() { return this.reduce((sum, memory) => sum + memory.buffer.byteLength, 0); }',
  );
  const openFrames = await overAll(
    send,
    'globalThis.VideoFrame',
    'function() { return this.filter((frame) => frame.codedWidth > 0).length; }',
  );
  await send('HeapProfiler.disable');
  return { heap: usedSize, wasm, openFrames };
}

/** Calls a function on the array of all objects of a class. */
async function overAll(send: Send, name: string, functionDeclaration: string): Promise<number> {
  const group = { objectGroup: 'memory' };
  const prototype = (await send('Runtime.evaluate', {
    expression: `${name}.prototype`,
    ...group,
  })) as { result: { objectId?: string } };
  const { objectId: prototypeObjectId } = prototype.result;
  if (!prototypeObjectId) return 0;
  const { objects } = (await send('Runtime.queryObjects', { prototypeObjectId, ...group })) as {
    objects: { objectId: string };
  };
  const { result } = (await send('Runtime.callFunctionOn', {
    objectId: objects.objectId,
    functionDeclaration,
    returnByValue: true,
  })) as { result: { value: number } };
  await send('Runtime.releaseObjectGroup', group);
  return result.value;
}

/** Sends to a worker by way of its page. */
function workerSend(session: CDPSession, sessionId: string): Send {
  let last = 0;
  const waiting = new Map<number, (answer: Record<string, unknown>) => void>();
  session.on('Target.receivedMessageFromTarget', ({ sessionId: from, message }) => {
    if (from !== sessionId) return;
    const { id, result } = JSON.parse(message);
    waiting.get(id)?.(result ?? {});
    waiting.delete(id);
  });
  return (method, params = {}) =>
    new Promise((resolve, reject) => {
      const id = ++last;
      waiting.set(id, resolve);
      const message = JSON.stringify({ id, method, params });
      session.send('Target.sendMessageToTarget', { message, sessionId }).catch(reject);
    });
}
