import { Mesh, MeshBasicMaterial, RingGeometry } from 'three';
import type { Palette } from './palette.ts';

/** Frames over which the ring fades after a watched one, so that playback pulses rather than flickers. */
const FADE_FRAMES = 8;

/** The ring on the ground round a watched frame's feet. */
export class WatchedRing {
  readonly object: Mesh;
  readonly #geometry = new RingGeometry(0.47, 0.49, 72).rotateX(-Math.PI / 2);
  readonly #material = new MeshBasicMaterial({ transparent: true, depthWrite: false });

  constructor(palette: Palette) {
    this.object = new Mesh(this.#geometry, this.#material);
    this.object.position.y = 0.004;
    this.setPalette(palette);
  }

  setPalette(palette: Palette): void {
    this.#material.color.set(palette.watched);
  }

  /** @param framesSince frames since the last watched one: 0 on a watched frame */
  update(framesSince: number): void {
    const fade = Math.max(0, 1 - framesSince / FADE_FRAMES);
    this.#material.opacity = framesSince === 0 ? 1 : 0.45 * fade * fade;
    this.object.visible = this.#material.opacity > 0;
    this.object.scale.setScalar(framesSince === 0 ? 1 : 1 + 0.25 * (1 - fade));
  }

  dispose(): void {
    this.object.removeFromParent();
    this.#geometry.dispose();
    this.#material.dispose();
  }
}
