import { MeshoptSimplifier } from 'meshoptimizer';
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  type Group,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  type MeshStandardMaterial,
  type Object3D,
} from 'three';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** Inside the mouth and behind the lids: never seen at these sizes. */
const HIDDEN = /teeth|gland/i;
/** Triangles that are left of each hundred: a person is some three hundred pixels tall here. */
const KEPT_SHARE = 0.15;
const LARGEST_ERROR = 0.01;

/** A rigged person whose bones are moved by matrices. */
export class Avatar {
  private readonly nodes = new Map<string, Object3D>();

  private constructor(readonly scene: Group) {
    scene.traverse((node) => {
      node.updateMatrix();
      node.matrixAutoUpdate = false;
      node.frustumCulled = false;
      this.nodes.set(node.name, node);
      if (node instanceof Mesh) prepare(node);
    });
  }

  static async load(url: string): Promise<Avatar> {
    await MeshoptSimplifier.ready;
    const { scene } = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync(url);
    return new Avatar(scene);
  }

  /** Sets node-to-parent matrices: 16 numbers for each of `names`, column by column. */
  pose(names: readonly string[], matrices: Float32Array): void {
    for (const [index, name] of names.entries()) {
      const node = this.nodes.get(name);
      if (!node) throw new Error(`the avatar has no node called ${name}`);
      node.matrix.fromArray(matrices, index * 16);
    }
    this.scene.updateMatrixWorld(true);
  }
}

function prepare(mesh: Mesh): void {
  const { map, transparent, alphaTest } = mesh.material as MeshStandardMaterial;
  if (HIDDEN.test(mesh.name)) {
    mesh.visible = false;
    return;
  }
  mesh.material = new MeshLambertMaterial({ map, transparent, alphaTest, side: DoubleSide });
  const { index, attributes } = mesh.geometry;
  const position = attributes.position as BufferAttribute | undefined;
  if (!index || !position || index.count < 3000) return;
  const places = new Float32Array(position.count * 3);
  for (let i = 0; i < position.count; i++) {
    places.set([position.getX(i), position.getY(i), position.getZ(i)], i * 3);
  }
  const target = Math.floor((index.count * KEPT_SHARE) / 3) * 3;
  const [simple] = MeshoptSimplifier.simplify(
    Uint32Array.from(index.array),
    places,
    3,
    target,
    LARGEST_ERROR,
  );
  mesh.geometry.dispose();
  mesh.geometry = compact(mesh.geometry, simple);
}

/** The triangles `indices` of a geometry and their vertices alone. */
function compact(whole: BufferGeometry, indices: Uint32Array): BufferGeometry {
  const places = new Map<number, number>();
  for (const vertex of indices) if (!places.has(vertex)) places.set(vertex, places.size);
  const geometry = new BufferGeometry();
  for (const name of ['position', 'normal', 'uv', 'skinIndex', 'skinWeight']) {
    const from = whole.getAttribute(name) as BufferAttribute | undefined;
    if (!from) continue;
    const to = new BufferAttribute(new Float32Array(places.size * from.itemSize), from.itemSize);
    for (const [vertex, place] of places) {
      for (let part = 0; part < from.itemSize; part++) {
        to.setComponent(place, part, from.getComponent(vertex, part));
      }
    }
    geometry.setAttribute(name, to);
  }
  geometry.setIndex(Array.from(indices, (vertex) => places.get(vertex)!));
  return geometry;
}

/** A matrix from 16 numbers, column by column, at `offset`. */
export function matrixAt(numbers: Float32Array, offset: number): Matrix4 {
  return new Matrix4().fromArray(numbers, offset);
}
