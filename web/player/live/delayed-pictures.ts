/** Wide enough to look at, small enough to copy thirty times a second. */
const MAX_WIDTH = 640;

/** At most so many pictures wait; the longest delay at 60 frames a second is not much longer. */
const MOST = 64;

interface Picture {
  readonly time: number;
  readonly canvas: HTMLCanvasElement;
}

/**
 * Keeps the last pictures of a camera, so that a skeleton that is shown late lies over the picture that
 * it belongs to. Canvases are used again and again: their number grows with the delay alone.
 */
export class DelayedPictures {
  #waiting: Picture[] = [];
  #free: HTMLCanvasElement[] = [];

  /** @param time seconds */
  add(video: HTMLVideoElement, time: number): void {
    const scale = Math.min(1, MAX_WIDTH / video.videoWidth);
    const width = Math.round(video.videoWidth * scale);
    const height = Math.round(video.videoHeight * scale);
    if (width === 0 || height === 0) return;
    const spare = this.#waiting.length >= MOST ? this.#waiting.shift()?.canvas : this.#free.pop();
    const canvas = spare ?? document.createElement('canvas');
    if (canvas.width !== width || canvas.height !== height)
      Object.assign(canvas, { width, height });
    canvas.getContext('2d', { alpha: false })?.drawImage(video, 0, 0, width, height);
    this.#waiting.push({ time, canvas });
  }

  /** The picture that was captured last before a time in seconds; lets go of all older ones. */
  at(time: number): HTMLCanvasElement | null {
    while (this.#waiting.length > 1 && this.#waiting[1]!.time <= time) {
      this.#free.push(this.#waiting.shift()!.canvas);
    }
    return this.#waiting[0]?.canvas ?? null;
  }

  clear(): void {
    this.#waiting = [];
    this.#free = [];
  }
}
