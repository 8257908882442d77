// The object: its surface, with hatches where nobody scanned it and where a wall is thin, its points as small discs, the rim of an open scan, and a
// bristle at each point whose normal was turned.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  LineSegments,
  Mesh,
  Points,
  ShaderMaterial,
  Vector4,
} from 'three';
import type { Colours } from './messages';

const kVertexBytes = 16; // scene.h: three floats, three signed bytes of the normal, marks

/** A vertex of the server is read as it lies: no copy, no conversion. */
function withVertices(geometry: BufferGeometry, view: DataView, start: number, count: number): BufferGeometry {
  const words = new Float32Array(view.buffer, view.byteOffset + start, (count * kVertexBytes) / 4);
  const bytes = new Int8Array(view.buffer, view.byteOffset + start, count * kVertexBytes);
  geometry.setAttribute('position', new InterleavedBufferAttribute(new InterleavedBuffer(words, kVertexBytes / 4), 3, 0));
  const small = new InterleavedBuffer(bytes, kVertexBytes);
  geometry.setAttribute('normal', new InterleavedBufferAttribute(small, 3, 12, true));
  geometry.setAttribute('mark', new InterleavedBufferAttribute(small, 1, 15));
  return geometry;
}

/** Everything on the eye's side of a plane is cut away: dot(xyz, place) > w. */
export const noCut = (): Vector4 => new Vector4(0, 0, 0, 1);

const kVertexShader = /* glsl */ `
  attribute float mark;
  varying vec3 place, outward;
  varying float invented, thin;
  void main() {
    place = position;
    outward = normal;
    invented = mod(mark, 2.0);
    thin = floor(mark / 2.0);
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const kSurfaceShader = /* glsl */ `
  uniform vec3 colour, hatched, hatchedThin, eye;
  uniform vec4 cut;
  uniform float pixelRatio;
  varying vec3 place, outward;
  varying float invented, thin;
  void main() {
    if (dot(cut.xyz, place) > cut.w) discard;
    vec3 n = normalize(outward), view = normalize(eye - place);
    vec3 base = colour;
    if (invented > 0.5) {
      float across = mod((gl_FragCoord.x + gl_FragCoord.y) / (pixelRatio * 1.414), 9.0);
      base = mix(base, hatched, across < 3.5 ? 1.0 : 0.12);
    }
    if (thin > 0.5) {
      float across = mod((gl_FragCoord.x - gl_FragCoord.y) / (pixelRatio * 1.414), 9.0);
      base = mix(base, hatchedThin, across < 2.5 ? 1.0 : 0.0);
    }
    if (!gl_FrontFacing) { base *= 0.45; n = -n; }
    vec3 light = normalize(vec3(-0.35, 0.8, 0.55));
    float lit = 0.42 + 0.5 * max(dot(n, light), 0.0) + 0.16 * max(dot(n, view), 0.0);
    gl_FragColor = sRGBTransferOETF(vec4(base * lit, 1.0)); // as the screen has it, also in a kept picture
  }`;

const kPointVertexShader = /* glsl */ `
  uniform vec3 eye;
  uniform vec4 cut;
  uniform float size;
  varying float lit, hidden;
  void main() {
    vec3 view = normalize(eye - position);
    float facing = dot(normalize(normal), view);
    lit = 0.55 + 0.45 * max(dot(normal, normalize(vec3(-0.35, 0.8, 0.55))), 0.0);
    hidden = dot(cut.xyz, position) > cut.w || facing < 0.0 ? 1.0 : 0.0;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_PointSize = size / gl_Position.w;
  }`;

const kPointShader = /* glsl */ `
  uniform vec3 colour;
  varying float lit, hidden;
  void main() {
    if (hidden > 0.5 || length(gl_PointCoord - 0.5) > 0.5) discard;
    gl_FragColor = sRGBTransferOETF(vec4(colour * lit, 1.0));
  }`;

function lines(colour: string): LineSegments {
  const material = new ShaderMaterial({
    vertexShader: 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
    fragmentShader: 'uniform vec3 colour; void main() { gl_FragColor = sRGBTransferOETF(vec4(colour, 1.0)); }',
    uniforms: { colour: { value: new Color(colour) } },
  });
  return new LineSegments(new BufferGeometry(), material);
}

function setLines(of: LineSegments, view: DataView): void {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(view.buffer, view.byteOffset + 4, 6 * view.getUint32(0, true)), 3));
  of.geometry.dispose();
  of.geometry = geometry;
}

export class ObjectView {
  readonly group = new Group();
  private readonly surface: ShaderMaterial;
  private readonly dots: ShaderMaterial;
  private readonly surfaceMesh = new Mesh(new BufferGeometry());
  private readonly points = new Points(new BufferGeometry());
  private readonly rim: LineSegments;
  private readonly turned: LineSegments;

  constructor(colours: Colours) {
    const shared = { eye: { value: this.group.position.clone() }, cut: { value: noCut() } };
    this.surface = new ShaderMaterial({
      vertexShader: kVertexShader,
      fragmentShader: kSurfaceShader,
      side: DoubleSide,
      uniforms: {
        ...shared,
        colour: { value: new Color(colours.surface) },
        hatched: { value: new Color(colours.invented) },
        hatchedThin: { value: new Color(colours.thin) },
        pixelRatio: { value: 1 },
      },
    });
    this.dots = new ShaderMaterial({
      vertexShader: kPointVertexShader,
      fragmentShader: kPointShader,
      uniforms: { ...shared, colour: { value: new Color(colours.distance[5] ?? colours.proxy) }, size: { value: 1 } },
    });
    this.surfaceMesh.material = this.surface;
    this.points.material = this.dots;
    this.rim = lines(colours.rim);
    this.turned = lines(colours.turned);
    for (const part of [this.surfaceMesh, this.points, this.rim, this.turned]) {
      part.frustumCulled = false;
      this.group.add(part);
    }
    this.points.visible = false;
  }

  setSurface(view: DataView): void {
    const vertices = view.getUint32(0, true);
    const faces = view.getUint32(4, true);
    const geometry = withVertices(new BufferGeometry(), view, 8, vertices);
    geometry.setIndex(new BufferAttribute(new Uint32Array(view.buffer, view.byteOffset + 8 + kVertexBytes * vertices, 3 * faces), 1));
    this.surfaceMesh.geometry.dispose();
    this.surfaceMesh.geometry = geometry;
  }

  setPoints(view: DataView): void {
    this.points.geometry.dispose();
    this.points.geometry = withVertices(new BufferGeometry(), view, 4, view.getUint32(0, true));
  }

  setRim(view: DataView): void {
    setLines(this.rim, view);
  }

  setTurned(view: DataView): void {
    setLines(this.turned, view);
  }

  show(surface: boolean, points: boolean): void {
    this.surfaceMesh.visible = surface;
    this.points.visible = points;
  }

  /** Before a picture. `dot` is the size of a point, mm, at a distance of one in the picture's units. */
  update(eye: { x: number; y: number; z: number }, cut: Vector4, pixelRatio: number, dot: number): void {
    (this.surface.uniforms['eye'] as { value: { copy(v: unknown): void } }).value.copy(eye);
    (this.surface.uniforms['cut'] as { value: Vector4 }).value.copy(cut);
    (this.surface.uniforms['pixelRatio'] as { value: number }).value = pixelRatio;
    (this.dots.uniforms['size'] as { value: number }).value = dot;
  }
}
