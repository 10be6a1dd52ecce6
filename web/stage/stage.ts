import { DirectionalLight, Group, HemisphereLight, Scene } from 'three';
import { hasPose, type PoseSequence, poseAt } from '../pose/sequence.ts';
import type { Skeleton } from '../pose/skeleton.ts';
import { CameraRig, type StageView } from './camera-rig.ts';
import { ContactShadow } from './contact-shadow.ts';
import { Ground } from './ground.ts';
import { estimateStanding, type Standing } from './ground-level.ts';
import { LiveStanding } from './live-standing.ts';
import { paletteFor, type Theme } from './palette.ts';
import { SkeletonMesh } from './skeleton-mesh.ts';
import { Trails } from './trails.ts';
import { WatchedRing } from './watched-ring.ts';
import { createRenderer, type StageRenderer } from './webgl.ts';

export interface StageOptions {
  readonly theme?: Theme;
  /** Told when the graphics card drops the picture, and when it is back. */
  readonly onContext?: (state: 'lost' | 'restored') => void;
}

/** One moment of live playback, as the stage takes it. */
export interface StagePose {
  /** K·3 metres relative to the mid-hip. */
  readonly values: Float32Array;
  /** K, 0 to 1. */
  readonly scores: Float32Array;
  /** 0 to 1. */
  readonly presence: number;
  /** Seconds. */
  readonly time: number;
}

/** What is drawn of live playback. */
interface LiveCast {
  readonly standing: LiveStanding;
  readonly body: SkeletonMesh;
  readonly shadow: ContactShadow;
}

/** What is drawn of one sequence. */
interface Cast {
  readonly sequence: PoseSequence;
  readonly standing: Standing;
  readonly body: SkeletonMesh;
  readonly shadow: ContactShadow;
  readonly trails: Trails;
}

/**
 * Draws a 3D pose sequence, one frame at a time, in a container that it fills. A picture is drawn only
 * when something has changed. The stage owns its canvas and frees all it made in {@link dispose}.
 */
export class Stage {
  readonly camera: CameraRig;
  readonly #container: HTMLElement;
  readonly #gl: StageRenderer;
  readonly #scene = new Scene();
  readonly #actors = new Group();
  readonly #ground: Ground;
  readonly #ring: WatchedRing;
  readonly #resizes: ResizeObserver;
  readonly #onContext: StageOptions['onContext'];
  #theme: Theme;
  #cast: Cast | null = null;
  #live: LiveCast | null = null;
  #frame = 0;
  #trailsShown = true;
  #pending = 0;

  /** @throws DeciWatchError `webgl-unavailable` where there is no WebGL 2 */
  constructor(container: HTMLElement, options: StageOptions = {}) {
    this.#gl = createRenderer();
    this.#container = container;
    this.#onContext = options.onContext;
    this.#theme = options.theme ?? 'light';
    const palette = paletteFor(this.#theme);
    this.#ground = new Ground(palette);
    this.#ring = new WatchedRing(palette);
    this.#ring.object.visible = false;
    const key = new DirectionalLight(0xffffff, 1.9);
    key.position.set(1.2, 2.6, 2);
    const sky = new HemisphereLight(0xffffff, 0x9aa4b0, 1.9);
    this.#scene.add(key, sky, this.#ground.object, this.#ring.object, this.#actors);

    const { domElement } = this.#gl.renderer;
    domElement.style.cssText = 'display:block;width:100%;height:100%';
    domElement.addEventListener('webglcontextlost', this.#lost);
    domElement.addEventListener('webglcontextrestored', this.#restored);
    container.append(domElement);
    this.camera = new CameraRig(domElement, this.#invalidate);
    this.#resizes = new ResizeObserver(this.#resize);
    this.#resizes.observe(container);
    this.#resize();
  }

  /**
   * Shows another sequence (3D), or an empty stage.
   * @param mirrored as in a mirror: what is on the person's right is on the right
   */
  setSequence(sequence: PoseSequence | null, mirrored = false): void {
    const wasLive = this.#live !== null;
    this.#dismiss();
    if (wasLive) this.#resize();
    this.#actors.scale.x = mirrored ? -1 : 1;
    if (sequence) {
      const palette = paletteFor(this.#theme);
      const standing = estimateStanding(sequence);
      const body = new SkeletonMesh(sequence.skeleton, palette);
      const shadow = new ContactShadow(sequence.skeleton.joints.length);
      const trails = new Trails(sequence.skeleton, palette);
      this.#actors.add(body.object, trails.object, shadow.object);
      const [x, z] = standing.feet;
      this.#actors.position.set(-x * this.#actors.scale.x, 0, -z);
      this.#cast = { sequence, standing, body, shadow, trails };
      this.camera.setStature(standing.stature);
    }
    this.showFrame(0);
  }

  /**
   * Takes poses one by one from now on ({@link showPose}) instead of a sequence.
   * @param mirrored as in a mirror: what is on the person's right is on the right
   */
  setLive(skeleton: Skeleton, mirrored: boolean): void {
    this.#dismiss();
    const palette = paletteFor(this.#theme);
    const body = new SkeletonMesh(skeleton, palette, this.#gl.software);
    const shadow = new ContactShadow(skeleton.joints.length);
    this.#live = { standing: new LiveStanding(), body, shadow };
    this.#actors.add(body.object, shadow.object);
    this.#actors.scale.x = mirrored ? -1 : 1;
    this.#actors.visible = false;
    this.#ring.object.visible = false;
    this.#resize();
  }

  /** Shows somebody at one moment of live playback, or nobody. */
  showPose(pose: StagePose | null): void {
    if (!this.#live) return;
    const { standing, body, shadow } = this.#live;
    const shown = pose !== null && pose.presence > 0;
    // An empty stage stays as it is.
    if (!shown && !this.#actors.visible) return;
    this.#actors.visible = shown;
    this.#ring.object.visible = false;
    if (shown) {
      standing.follow(pose.values, pose.time);
      body.update({ ...pose, watched: false });
      body.object.position.y = standing.hipHeight;
      shadow.object.visible = pose.presence > 0.5;
      shadow.update(pose.values, standing.hipHeight);
      const [x, z] = standing.feet;
      this.#actors.position.set(-x * this.#actors.scale.x, 0, -z);
      this.camera.setStature(standing.stature);
    } else {
      standing.reset();
    }
    this.#invalidate();
  }

  /** Whether pictures are drawn by the processor: each costs much. */
  get isSoftware(): boolean {
    return this.#gl.software;
  }

  /** Shows one frame of the sequence; where nobody was seen in it, an empty stage. */
  showFrame(frame: number): void {
    this.#frame = frame;
    this.#pose();
    this.#invalidate();
  }

  setTheme(theme: Theme): void {
    this.#theme = theme;
    const palette = paletteFor(theme);
    this.#ground.setPalette(palette);
    this.#ring.setPalette(palette);
    this.#cast?.body.setPalette(palette);
    this.#cast?.trails.setPalette(palette);
    this.#live?.body.setPalette(palette);
    this.showFrame(this.#frame);
  }

  /** Shows or hides the recent paths of wrists and ankles. */
  setTrails(shown: boolean): void {
    this.#trailsShown = shown;
    this.showFrame(this.#frame);
  }

  /** Goes to a named view. */
  view(view: StageView): void {
    this.camera.view(view);
  }

  /** Frees geometries, materials and the WebGL context, and takes the canvas away. */
  dispose(): void {
    cancelAnimationFrame(this.#pending);
    this.#resizes.disconnect();
    this.camera.dispose();
    this.#dismiss();
    this.#ground.dispose();
    this.#ring.dispose();
    const { renderer } = this.#gl;
    renderer.domElement.removeEventListener('webglcontextlost', this.#lost);
    renderer.domElement.removeEventListener('webglcontextrestored', this.#restored);
    renderer.dispose();
    renderer.forceContextLoss();
    renderer.domElement.remove();
  }

  #dismiss(): void {
    this.#cast?.body.dispose();
    this.#cast?.shadow.dispose();
    this.#cast?.trails.dispose();
    this.#cast = null;
    this.#live?.body.dispose();
    this.#live?.shadow.dispose();
    this.#live = null;
    this.#actors.scale.x = 1;
  }

  #pose(): void {
    if (this.#live) return;
    const cast = this.#cast;
    const shown = cast !== null && hasPose(cast.sequence, this.#frame);
    this.#actors.visible = shown;
    this.#ring.object.visible = shown;
    if (!cast || !shown) return;
    const { sequence, standing, body, shadow, trails } = cast;
    const frame = this.#frame;
    const joints = sequence.skeleton.joints.length;
    const values = poseAt(sequence, frame);
    const hipHeight = standing.hipHeights[frame]!;
    body.update({
      values,
      scores: sequence.scores.subarray(frame * joints, (frame + 1) * joints),
      watched: sequence.watched[frame] === 1,
    });
    body.object.position.y = hipHeight;
    shadow.update(values, hipHeight);
    this.#ring.update(framesSinceWatched(sequence.watched, frame));
    trails.object.visible = this.#trailsShown;
    if (this.#trailsShown) trails.update(sequence, standing.hipHeights, frame);
  }

  readonly #invalidate = () => {
    this.#pending ||= requestAnimationFrame(this.#draw);
  };

  readonly #draw = (now: number) => {
    this.#pending = 0;
    this.camera.update(now);
    if (!this.#gl.renderer.getContext().isContextLost()) {
      this.#gl.renderer.render(this.#scene, this.camera.camera);
    }
  };

  readonly #resize = () => {
    const { clientWidth: width, clientHeight: height } = this.#container;
    if (width === 0 || height === 0) return;
    const { renderer, maxPixelRatio, livePixelRatio, software } = this.#gl;
    const most = this.#live ? livePixelRatio : maxPixelRatio;
    renderer.setPixelRatio(software ? most : Math.min(devicePixelRatio, most));
    renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    // At once: setting the size has emptied the canvas.
    this.#draw(performance.now());
  };

  readonly #lost = (event: Event) => {
    // Without this the browser would never give the context back.
    event.preventDefault();
    this.#onContext?.('lost');
  };

  readonly #restored = () => {
    this.#onContext?.('restored');
    this.#invalidate();
  };
}

/** Frames from the last watched one up to `frame`; infinite where there is none. */
export function framesSinceWatched(watched: Uint8Array, frame: number): number {
  const last = watched.lastIndexOf(1, frame);
  return last < 0 ? Number.POSITIVE_INFINITY : frame - last;
}
