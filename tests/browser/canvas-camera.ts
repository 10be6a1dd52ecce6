import type { LiveSession } from '../../web/engine/live/types.ts';
import { watchCameraFrames } from '../../web/sources/camera-frames.ts';
import { openFile } from '../../web/sources/file.ts';
import { walk } from './fixtures.ts';

const WIDTH = 640;

/** A canvas as a camera: it shows a real person walking, or an empty room. */
export class CanvasCamera {
  readonly video = document.createElement('video');
  /** Nobody is in view. */
  empty = false;
  /** No frame comes, as in a hidden tab. */
  silent = false;
  #frame = 0;
  #timer = 0;
  #stop: (() => void) | null = null;

  private constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly pictures: readonly ImageBitmap[],
  ) {}

  /** @param rate frames a second */
  static async start(rate = 30): Promise<CanvasCamera> {
    const clip = await openFile(await walk(), 'walk.mp4');
    const height = 2 * Math.round((WIDTH * clip.info.height) / clip.info.width / 2);
    const pictures: ImageBitmap[] = [];
    // The middle of the clip, there and back, so that it never jumps.
    const wanted = Array.from({ length: 50 }, (_, i) => 20 + i);
    for await (const { image } of clip.frames(wanted)) {
      pictures.push(
        await createImageBitmap(image as OffscreenCanvas, {
          resizeWidth: WIDTH,
          resizeHeight: height,
        }),
      );
    }
    clip.close();
    const canvas = Object.assign(document.createElement('canvas'), { width: WIDTH, height });
    const camera = new CanvasCamera(canvas, pictures);
    camera.video.muted = true;
    camera.video.srcObject = canvas.captureStream(rate);
    camera.video.style.width = '320px';
    document.body.append(camera.video);
    camera.#timer = setInterval(() => camera.#draw(), 1000 / rate) as unknown as number;
    await camera.video.play();
    return camera;
  }

  /** Hands every frame to a session. */
  feed(session: LiveSession): void {
    this.#stop?.();
    this.#stop = watchCameraFrames(this.video, (frame) => session.frame(this.video, frame));
  }

  close(): void {
    clearInterval(this.#timer);
    this.#stop?.();
    for (const track of (this.video.srcObject as MediaStream).getTracks()) track.stop();
    this.video.remove();
    for (const picture of this.pictures) picture.close();
  }

  #draw(): void {
    if (this.silent) return;
    const context = this.canvas.getContext('2d')!;
    const count = this.pictures.length;
    const at = this.#frame++ % (2 * count - 2);
    if (this.empty) {
      // A little noise, or the browser would take two frames for one.
      context.fillStyle = `rgb(90, 110, ${100 + (this.#frame % 5)})`;
      context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    } else {
      context.drawImage(this.pictures[at < count ? at : 2 * count - 2 - at]!, 0, 0);
    }
  }
}
