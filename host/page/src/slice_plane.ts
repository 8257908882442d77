// A plane through the field: colours for the distance, thin lines a voxel apart, a bold one at the surface.
import { BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, FloatType, Mesh, NearestFilter, RedFormat, ShaderMaterial, Vector2 } from 'three';
import type { Colours } from './messages';

const kShader = /* glsl */ `
  uniform sampler2D distances;
  uniform vec2 samples;
  uniform float voxel, band;
  uniform vec3 steps[7];
  varying vec2 at;
  float texel(vec2 p) { return texelFetch(distances, ivec2(clamp(p, vec2(0.0), samples - 1.0)), 0).r; }
  void main() {
    vec2 p = at * (samples - 1.0), low = floor(p), t = p - low;
    float d = mix(mix(texel(low), texel(low + vec2(1, 0)), t.x), mix(texel(low + vec2(0, 1)), texel(low + vec2(1, 1)), t.x), t.y);
    if (d > 0.98 * band) discard; // far outside: the object behind is to be seen
    float place = clamp((d / band + 1.0) / 2.0, 0.0, 1.0) * 6.0;
    int first = min(int(place), 5);
    vec3 colour = mix(steps[first], steps[first + 1], place - float(first));
    float width = fwidth(d), line = d / voxel;
    float thin = abs(line - floor(line + 0.5)) * voxel / max(width, 1e-6);
    if (abs(d) < 0.98 * band && thin < 0.6 && width < 0.5 * voxel) colour = mix(colour, vec3(0.0), 0.35);
    if (abs(d) / max(width, 1e-6) < 1.4) colour = vec3(0.0);
    gl_FragColor = sRGBTransferOETF(vec4(colour, 1.0));
  }`;

export class SlicePlane {
  readonly mesh: Mesh;
  private readonly material: ShaderMaterial;

  constructor(colours: Colours) {
    this.material = new ShaderMaterial({
      vertexShader: /* glsl */ `
        varying vec2 at;
        void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
      fragmentShader: kShader,
      side: DoubleSide,
      uniforms: {
        distances: { value: null },
        samples: { value: new Vector2(2, 2) },
        voxel: { value: 1 },
        band: { value: 1 },
        steps: { value: colours.distance.map((colour) => new Color(colour)) },
      },
    });
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** As scene.h sends it. */
  set(view: DataView, voxel: number, band: number): void {
    const columns = view.getUint32(0, true);
    const rows = view.getUint32(4, true);
    const corner = (n: number): number[] => [0, 4, 8].map((byte) => view.getFloat32(8 + 12 * n + byte, true));
    const [first, right, up] = [corner(0), corner(1), corner(2)];
    const far = right.map((value, axis) => value + (up[axis] ?? 0) - (first[axis] ?? 0));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([...first, ...right, ...far, ...up]), 3));
    geometry.setAttribute('uv', new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const texture = new DataTexture(new Float32Array(view.buffer, view.byteOffset + 44, columns * rows), columns, rows, RedFormat, FloatType);
    texture.minFilter = texture.magFilter = NearestFilter;
    texture.needsUpdate = true;
    const uniforms = this.material.uniforms as Record<string, { value: unknown }>;
    (uniforms['distances']?.value as DataTexture | null)?.dispose();
    Object.assign(uniforms['distances'] ?? {}, { value: texture });
    Object.assign(uniforms['samples'] ?? {}, { value: new Vector2(columns, rows) });
    Object.assign(uniforms['voxel'] ?? {}, { value: voxel });
    Object.assign(uniforms['band'] ?? {}, { value: band });
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
}
