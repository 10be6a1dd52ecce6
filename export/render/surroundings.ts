import {
  AmbientLight,
  BoxGeometry,
  CanvasTexture,
  Color,
  DirectionalLight,
  Group,
  Mesh,
  MeshLambertMaterial,
  PlaneGeometry,
  RepeatWrapping,
  SRGBColorSpace,
  type Texture,
} from 'three';
import type { Colour, Surroundings } from './job.ts';

const TILE = 256;

/** Light, floor, backdrop and occluders of one clip; whoever builds it disposes of it. */
export class Place {
  readonly group = new Group();
  readonly backdrop: Texture;
  private readonly owned: { dispose(): void }[] = [];

  constructor(around: Surroundings) {
    const random = mulberry32(around.seed);
    const colour = ([r, g, b]: Colour) => new Color().setRGB(r, g, b, SRGBColorSpace);
    this.backdrop = this.own(pattern(random, around.sky));
    this.group.add(new AmbientLight(0xffffff, around.ambient));
    const sun = new DirectionalLight(colour(around.sunColour), around.sun);
    sun.position.set(...around.sunDirection);
    this.group.add(sun);
    if (around.hasFloor) {
      const map = this.own(pattern(random, around.floor));
      map.wrapS = map.wrapT = RepeatWrapping;
      map.repeat.set(12, 12);
      const floor = this.mesh(new PlaneGeometry(40, 40), new MeshLambertMaterial({ map }));
      floor.rotation.x = -Math.PI / 2;
    }
    for (const { centre, size, yaw, colour: paint } of around.occluders) {
      const material = new MeshLambertMaterial({ color: colour(paint) });
      const box = this.mesh(new BoxGeometry(...size), material);
      box.position.set(...centre);
      box.rotation.y = yaw;
    }
  }

  dispose(): void {
    for (const thing of this.owned) thing.dispose();
  }

  private own<T extends { dispose(): void }>(thing: T): T {
    this.owned.push(thing);
    return thing;
  }

  private mesh(geometry: PlaneGeometry | BoxGeometry, material: MeshLambertMaterial): Mesh {
    const mesh = new Mesh(this.own(geometry), this.own(material));
    this.group.add(mesh);
    return mesh;
  }
}

/** Shapes of colours near one, at random: a room, a street, a wall, to an estimator's eye. */
function pattern(random: () => number, base: Colour): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = TILE;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('this browser draws no 2D canvas');
  const paint = (spread: number) =>
    `rgb(${base.map((part) => Math.round(255 * (part + spread * (random() - 0.5)))).join(' ')})`;
  const gradient = context.createLinearGradient(0, 0, TILE * (random() - 0.5), TILE);
  gradient.addColorStop(0, paint(0.3));
  gradient.addColorStop(1, paint(0.3));
  context.fillStyle = gradient;
  context.fillRect(0, 0, TILE, TILE);
  const shapes = Math.floor(random() * 40);
  const contrast = random();
  for (let i = 0; i < shapes; i++) {
    context.fillStyle = paint(contrast);
    const [x, y] = [random() * TILE, random() * TILE];
    const [w, h] = [TILE * random() ** 2, TILE * random() ** 2];
    if (random() < 0.7) context.fillRect(x, y, w, h);
    else {
      context.beginPath();
      context.ellipse(x, y, w / 2 + 1, h / 2 + 1, random() * Math.PI, 0, 2 * Math.PI);
      context.fill();
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** Uniform numbers in [0, 1) from a seed, the same on every machine. */
function mulberry32(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
