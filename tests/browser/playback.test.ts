import { expect, test } from 'vitest';
import { Playback } from '../../web/player/parts/playback.ts';

/** A `<video>` that presents what the test says. */
class Presented {
  readonly element = document.createElement('video');
  #deliver: VideoFrameRequestCallback | null = null;

  constructor() {
    this.element.src = '/samples/walk.mp4';
    this.element.preload = 'none';
    this.element.requestVideoFrameCallback = (callback) => {
      this.#deliver = callback;
      return 1;
    };
  }

  frame(mediaTime: number, currentTime = mediaTime): void {
    Object.defineProperty(this.element, 'currentTime', { value: currentTime, configurable: true });
    this.#deliver!(0, { mediaTime } as VideoFrameCallbackMetadata);
  }
}

test('a video whose clock begins elsewhere than its file is in step, also after it was moved', () => {
  const video = new Presented();
  const times = Float64Array.of(0, 0.1, 0.2, 0.3);
  let frame = -1;
  const play = () => {
    const playback = new Playback(video.element, (state) => {
      frame = state.frame;
    });
    playback.setTimes(times);
    return playback;
  };
  const first = play();
  video.frame(1, 0);
  video.frame(1.2);
  expect(frame).toBe(2);
  first.dispose();
  // As when a player is put elsewhere on the page.
  const second = play();
  video.frame(1.1);
  expect(frame).toBe(1);
  // Another file has another first frame.
  video.element.dispatchEvent(new Event('loadstart'));
  second.setTimes(times);
  video.frame(0, 0);
  video.frame(0.3);
  expect(frame).toBe(3);
  second.dispose();
});
