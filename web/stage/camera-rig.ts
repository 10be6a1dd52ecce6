import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** A named place to look from. `front` is where the video's camera stood. */
export type StageView = 'angle' | 'front' | 'side' | 'top';

/** [azimuth, polar angle] in degrees; azimuth 0 looks along the video camera's own direction. */
const VIEWS: Readonly<Record<StageView, readonly [number, number]>> = {
  angle: [24, 76],
  front: [0, 84],
  side: [90, 84],
  top: [0, 4],
};

/** Where the camera was put. */
export interface CameraPlace {
  /** Metres and radians, seen from the person. */
  readonly from: Spherical;
  /** A person has moved it. */
  readonly moved: boolean;
}

const FOV_DEG = 30;
/** Room round the person, as a share of their size: buttons lie over the picture's top and bottom. */
const MARGIN = 1.42;
const GLIDE_MS = 350;

/** The camera, and the ways to move it: pointer, keys and buttons, named views. */
export class CameraRig {
  readonly camera = new PerspectiveCamera(FOV_DEG, 1, 0.05, 40);
  readonly #controls: OrbitControls;
  readonly #onMove: () => void;
  #stature = 1.7;
  /** False once a person has moved the camera: from then on a resize leaves it where they put it. */
  #atHome = true;
  #glide: { from: Spherical; to: Spherical; start: number } | null = null;

  /** @param onMove called whenever a new picture is due */
  constructor(element: HTMLElement, onMove: () => void) {
    this.#onMove = onMove;
    this.#controls = new OrbitControls(this.camera, element);
    this.#controls.enableDamping = true;
    this.#controls.dampingFactor = 0.12;
    this.#controls.enablePan = false;
    // The wheel scrolls the page; buttons, keys and a pinch zoom.
    this.#controls.enableZoom = false;
    this.#controls.maxPolarAngle = MathUtils.degToRad(92);
    this.#controls.addEventListener('change', onMove);
    this.#controls.addEventListener('start', this.#taken);
    // After OrbitControls has set `none`: a finger moving up or down scrolls the page.
    element.style.touchAction = 'pan-y';
    this.reset(false);
  }

  /** Frames a person of this height, in metres. */
  setStature(stature: number): void {
    this.#stature = MathUtils.clamp(stature, 0.5, 2.6);
    if (this.#atHome) this.reset(false);
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.#atHome) this.reset(false);
    this.#onMove();
  }

  /** Goes to a named view, at the distance at which the person fits. */
  view(view: StageView, glide = true): void {
    this.#atHome = view === 'angle';
    const [azimuth, polar] = VIEWS[view];
    this.#go(
      new Spherical(this.#fitDistance(), MathUtils.degToRad(polar), MathUtils.degToRad(azimuth)),
      glide,
    );
  }

  reset(glide = true): void {
    this.view('angle', glide);
  }

  /** Turns round the person, by degrees: azimuth to the right, elevation up. */
  rotate(azimuth: number, elevation: number): void {
    this.#atHome = false;
    const to = this.#glide?.to.clone() ?? this.#current();
    to.theta += MathUtils.degToRad(azimuth);
    to.phi = MathUtils.clamp(
      to.phi - MathUtils.degToRad(elevation),
      MathUtils.degToRad(4),
      this.#controls.maxPolarAngle,
    );
    this.#go(to, true);
  }

  /** @param factor above 1 comes nearer */
  zoom(factor: number): void {
    this.#atHome = false;
    const to = this.#glide?.to.clone() ?? this.#current();
    to.radius = MathUtils.clamp(to.radius / factor, 1, 14);
    this.#go(to, true);
  }

  /** Where it is, or will be once it has come to rest. */
  get place(): CameraPlace {
    return { from: this.#glide?.to.clone() ?? this.#current(), moved: !this.#atHome };
  }

  /** Goes back to where another rig was. */
  put({ from, moved }: CameraPlace): void {
    if (!moved) return;
    this.#atHome = false;
    this.#go(from, false);
  }

  /** Advances gliding and damping. `onMove` is called where another picture will be needed. */
  update(now: number): void {
    if (this.#glide) {
      const done = Math.min(1, (now - this.#glide.start) / GLIDE_MS);
      const eased = 1 - (1 - done) ** 3;
      const { from, to } = this.#glide;
      this.#place(
        new Spherical(
          MathUtils.lerp(from.radius, to.radius, eased),
          MathUtils.lerp(from.phi, to.phi, eased),
          MathUtils.lerp(from.theta, to.theta, eased),
        ),
      );
      if (done === 1) this.#glide = null;
      else this.#onMove();
    }
    this.#controls.update();
  }

  dispose(): void {
    this.#controls.dispose();
  }

  readonly #taken = () => {
    this.#atHome = false;
    this.#glide = null;
  };

  #target(): Vector3 {
    return new Vector3(0, this.#stature * 0.51, 0);
  }

  #fitDistance(): number {
    const half = Math.tan(MathUtils.degToRad(FOV_DEG / 2));
    const forHeight = (this.#stature * MARGIN) / 2 / half;
    // Arms stretched out span about the stature; walking, about half of it.
    const forWidth = (this.#stature * 0.8) / 2 / (half * this.camera.aspect);
    return Math.max(forHeight, forWidth) + 0.25;
  }

  #current(): Spherical {
    return new Spherical().setFromVector3(this.camera.position.clone().sub(this.#controls.target));
  }

  #go(to: Spherical, glide: boolean): void {
    const still = globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches;
    if (!glide || still) {
      this.#glide = null;
      this.#place(to);
    } else {
      const from = this.#current();
      // The short way round.
      to.theta =
        from.theta +
        MathUtils.euclideanModulo(to.theta - from.theta + Math.PI, 2 * Math.PI) -
        Math.PI;
      this.#glide = { from, to, start: performance.now() };
    }
    this.#onMove();
  }

  #place(at: Spherical): void {
    this.#controls.target.copy(this.#target());
    this.camera.position.setFromSpherical(at).add(this.#controls.target);
    this.camera.lookAt(this.#controls.target);
  }
}
