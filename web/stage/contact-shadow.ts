import {
  Color,
  CustomBlending,
  InstancedMesh,
  Matrix4,
  OneFactor,
  PlaneGeometry,
  Quaternion,
  ReverseSubtractEquation,
  ShaderMaterial,
  Vector3,
} from 'three';
import { instancesChanged } from './instances.ts';

/** At this height above the ground a joint no longer darkens it. */
const REACH_M = 1.7;
const LIFT_M = 0.002;

const VERTEX = /* glsl */ `
  varying vec2 at;
  varying float strength;
  void main() {
    at = uv * 2.0 - 1.0;
    strength = instanceColor.r;
    gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  }
`;

const FRAGMENT = /* glsl */ `
  varying vec2 at;
  varying float strength;
  void main() {
    float fall = max(0.0, 1.0 - dot(at, at));
    gl_FragColor = vec4(vec3(strength * fall * fall), 0.0);
  }
`;

/**
 * A soft shadow where the body is near the ground: one blurred spot under each joint, wider and fainter
 * the higher the joint. No shadow map, so it costs next to nothing on a software renderer.
 */
export class ContactShadow {
  readonly object: InstancedMesh;
  readonly #geometry = new PlaneGeometry(2, 2).rotateX(-Math.PI / 2);
  readonly #material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
    // The picture minus the spot: overlapping spots add up without edges.
    blending: CustomBlending,
    blendEquation: ReverseSubtractEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
  });

  /** @param joints K */
  constructor(joints: number) {
    this.object = new InstancedMesh(this.#geometry, this.#material, joints);
    this.object.frustumCulled = false;
    this.object.renderOrder = -1;
  }

  /**
   * @param values K·3 metres relative to the mid-hip
   * @param hipHeight metres above the ground
   */
  update(values: Float32Array, hipHeight: number): void {
    for (let joint = 0; joint < this.object.count; joint++) {
      const height = Math.max(0, values[joint * 3 + 1]! + hipHeight);
      const near = Math.max(0, 1 - height / REACH_M);
      place.set(values[joint * 3]!, LIFT_M, values[joint * 3 + 2]!);
      size.setScalar(0.09 + 0.13 * height);
      this.object.setMatrixAt(joint, matrix.compose(place, NO_TURN, size));
      strength.setScalar(0.01 + 0.07 * near ** 3);
      this.object.setColorAt(joint, strength);
    }
    instancesChanged(this.object);
  }

  dispose(): void {
    this.object.removeFromParent();
    this.object.dispose();
    this.#geometry.dispose();
    this.#material.dispose();
  }
}

const matrix = new Matrix4();
const place = new Vector3();
const size = new Vector3();
const strength = new Color();
const NO_TURN = new Quaternion();
