/**
 * Counts the VideoFrames that nobody has closed: those that decoders give, and those made from others.
 * A decoder stalls when too many are kept from it.
 */
export class OpenFrames {
  readonly #open = new Set<VideoFrame>();
  readonly #VideoFrame = globalThis.VideoFrame;
  readonly #VideoDecoder = globalThis.VideoDecoder;
  readonly #close = VideoFrame.prototype.close;
  readonly #clone = VideoFrame.prototype.clone;
  /** All that there ever were, so that a count of none open means something. */
  seen = 0;

  constructor() {
    const add = (frame: VideoFrame) => {
      this.seen++;
      this.#open.add(frame);
      return frame;
    };
    const remove = (frame: VideoFrame) => this.#open.delete(frame);
    const close = this.#close;
    const clone = this.#clone;
    VideoFrame.prototype.close = function () {
      remove(this);
      close.call(this);
    };
    VideoFrame.prototype.clone = function () {
      return add(clone.call(this));
    };
    globalThis.VideoFrame = new Proxy(this.#VideoFrame, {
      construct: (target, args) => add(Reflect.construct(target, args)),
    });
    globalThis.VideoDecoder = new Proxy(this.#VideoDecoder, {
      construct: (target, [init]: [VideoDecoderInit]) =>
        new target({ ...init, output: (frame) => init.output(add(frame)) }),
    });
  }

  get count(): number {
    // One that was handed to a worker has no pixels here any more.
    return [...this.#open].filter(({ codedWidth }) => codedWidth > 0).length;
  }

  restore(): void {
    this.#VideoFrame.prototype.close = this.#close;
    this.#VideoFrame.prototype.clone = this.#clone;
    globalThis.VideoFrame = this.#VideoFrame;
    globalThis.VideoDecoder = this.#VideoDecoder;
  }
}
