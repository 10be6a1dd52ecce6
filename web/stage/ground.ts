import { CircleGeometry, Color, Mesh, ShaderMaterial } from 'three';
import type { Palette } from './palette.ts';

/** Metres from the person to where the ground has faded away. */
const RADIUS_M = 4;

/** Lines every metre, finer ones every quarter, both of constant width on screen, fading with distance. */
const FRAGMENT = /* glsl */ `
  uniform vec3 floorColour;
  uniform vec3 gridColour;
  varying vec2 place;
  float lines(vec2 at, float width) {
    vec2 d = abs(fract(at - 0.5) - 0.5) / fwidth(at);
    return 1.0 - min(min(d.x, d.y) / width, 1.0);
  }
  void main() {
    float far = 1.0 - smoothstep(0.25, 1.0, length(place) / ${RADIUS_M.toFixed(1)});
    float grid = max(lines(place, 1.4) * 0.9, lines(place * 4.0, 1.0) * 0.22);
    vec3 colour = mix(floorColour, gridColour, grid);
    gl_FragColor = vec4(colour, far);
    #include <colorspace_fragment>
  }
`;

const VERTEX = /* glsl */ `
  varying vec2 place;
  void main() {
    place = position.xy;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

/** A disc of floor with a metre grid, at y = 0. */
export class Ground {
  readonly object: Mesh;
  readonly #geometry = new CircleGeometry(RADIUS_M, 48);
  readonly #material = new ShaderMaterial({
    uniforms: { floorColour: { value: new Color() }, gridColour: { value: new Color() } },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
  });

  constructor(palette: Palette) {
    this.object = new Mesh(this.#geometry, this.#material);
    this.object.rotation.x = -Math.PI / 2;
    this.object.renderOrder = -2;
    this.setPalette(palette);
  }

  setPalette(palette: Palette): void {
    (this.#material.uniforms.floorColour!.value as Color).set(palette.floor);
    (this.#material.uniforms.gridColour!.value as Color).set(palette.grid);
  }

  dispose(): void {
    this.object.removeFromParent();
    this.#geometry.dispose();
    this.#material.dispose();
  }
}
