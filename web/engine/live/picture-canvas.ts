/** A canvas that camera frames are drawn on for the estimator, made anew when their size changes. */
export class PictureCanvas {
  #canvas: OffscreenCanvas | undefined;

  /** The frame as it is displayed. Valid until the next one is drawn. */
  draw(frame: VideoFrame): OffscreenCanvas {
    const { displayWidth: width, displayHeight: height } = frame;
    if (this.#canvas?.width !== width || this.#canvas.height !== height) {
      this.#canvas = new OffscreenCanvas(width, height);
    }
    const context = this.#canvas.getContext('2d', { alpha: false });
    if (!context) throw new Error(`no canvas of ${width} × ${height} pixels`);
    context.drawImage(frame, 0, 0, width, height);
    return this.#canvas;
  }
}
