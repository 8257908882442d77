// The object's picture, kept with its depths. While only a hand moves, it is put behind the hand again instead of being drawn again.
import {
  AlwaysDepth,
  BufferAttribute,
  BufferGeometry,
  type Camera,
  CustomBlending,
  DepthTexture,
  LinearFilter,
  type MagnificationTextureFilter,
  Mesh,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  type Scene,
  ShaderMaterial,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

const kSamples = 4; // of a pixel of the fine picture

/** Its colours are those of the screen (sRGB), its opacity is premultiplied: what is free of the object shows what is behind the mesh. */
function target(samples: number, filter: MagnificationTextureFilter): WebGLRenderTarget {
  const made = new WebGLRenderTarget(1, 1, { samples, minFilter: filter, magFilter: filter });
  made.depthTexture = new DepthTexture(1, 1);
  return made;
}

export class Backdrop {
  /** Fills whatever it is drawn into with the kept picture; drawn first. */
  readonly mesh: Mesh;
  private readonly fine = target(kSamples, NearestFilter); // always as large as what it is put into
  private readonly quick = target(0, LinearFilter);
  private readonly material: ShaderMaterial;

  constructor() {
    this.material = new ShaderMaterial({
      vertexShader: /* glsl */ `
        varying vec2 at;
        void main() { at = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }`,
      fragmentShader: /* glsl */ `
        uniform sampler2D picture, depths;
        varying vec2 at;
        void main() { gl_FragColor = texture2D(picture, at); gl_FragDepth = texture2D(depths, at).r; }`,
      uniforms: { picture: { value: null }, depths: { value: null } },
      depthFunc: AlwaysDepth,
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    });
    const triangle = new BufferGeometry();
    triangle.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    this.mesh = new Mesh(triangle, this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
  }

  /**
   * Draws and keeps another picture.
   *
   * @param width pixels, as height
   * @param smooth with smooth edges, which takes longer
   */
  draw(renderer: WebGLRenderer, scene: Scene, camera: Camera, width: number, height: number, smooth: boolean): void {
    const into = smooth ? this.fine : this.quick;
    into.setSize(Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
    renderer.setRenderTarget(into);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    Object.assign(this.material.uniforms['picture'] ?? {}, { value: into.texture });
    Object.assign(this.material.uniforms['depths'] ?? {}, { value: into.depthTexture });
  }
}
