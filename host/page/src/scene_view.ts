// The picture: one object, and one or two panes with a hand each, side by side, seen by the same eye. It is drawn only when something changed.
import { Color, Scene, Vector3, Vector4, WebGLRenderer } from 'three';
import { Orbit } from './camera';
import type { Colours, SceneSummary } from './messages';
import { noCut, ObjectView } from './object';
import { SlicePlane } from './slice_plane';
import { TouchMarks } from './touch_marks';

export type Axis = 'x' | 'y' | 'z';

export class SceneView {
  readonly orbit: Orbit;
  readonly object: ObjectView;
  readonly slice: SlicePlane;
  readonly panes: TouchMarks[];
  /** Pictures drawn so far. */
  pictures = 0;
  /** Called before a picture is drawn. */
  beforePicture: () => void = () => {};
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private shownPanes = 1;
  private wanted = false;
  private cut: Vector4 = noCut();
  private summary: SceneSummary | null = null;

  /** fails: throws where there is no WebGL */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    colours: Colours,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.autoClear = false;
    this.object = new ObjectView(colours);
    this.slice = new SlicePlane(colours);
    this.panes = [new TouchMarks(colours), new TouchMarks(colours)];
    this.scene.add(this.object.group, this.slice.mesh, ...this.panes.map((pane) => pane.group));
    this.orbit = new Orbit(() => this.change());
    new ResizeObserver(() => this.change()).observe(canvas);
    canvas.addEventListener('webglcontextrestored', () => this.change());
    for (const query of ['(prefers-color-scheme: dark)', '(prefers-contrast: more)'])
      matchMedia(query).addEventListener('change', () => this.change());
  }

  /** How many hands are seen side by side: 1 or 2. */
  setPanes(count: number): void {
    this.shownPanes = count;
    this.panes.slice(count).forEach((pane) => pane.clear());
    this.change();
  }

  setScene(summary: SceneSummary): void {
    this.summary = summary;
    const low = new Vector3(...summary.low_mm);
    const high = new Vector3(...summary.high_mm);
    const radius = low.distanceTo(high) / 2;
    this.orbit.frame(low.clone().add(high).multiplyScalar(0.5), 0.78 * radius);
    this.panes.forEach((pane) => pane.size(radius / 52));
    this.change();
  }

  /** Cuts away what is on the eye's side of the slice. */
  setSlice(shown: boolean, axis: Axis, at: number): void {
    this.slice.mesh.visible = shown;
    if (shown) {
      const normal = new Vector3(Number(axis === 'x'), Number(axis === 'y'), Number(axis === 'z'));
      const side = this.orbit.towardsEye().dot(normal) < 0 ? -1 : 1;
      this.cut.set(side * normal.x, side * normal.y, side * normal.z, side * at + 1e-3);
    } else {
      this.cut = noCut();
    }
    this.change();
  }

  /** Where on an axis through the object's middle the pointer is, mm. */
  placeOnAxis(event: PointerEvent, axis: Axis): number {
    const { from, along } = this.ray(event);
    const middle = this.orbit.middle;
    const direction = new Vector3(Number(axis === 'x'), Number(axis === 'y'), Number(axis === 'z'));
    const between = middle.clone().sub(from);
    const b = along.dot(direction);
    const t = (b * between.dot(along) - between.dot(direction)) / Math.max(1 - b * b, 1e-3); // nearest place of the axis to the ray
    return middle[axis] + t;
  }

  /** The ray through the pointer. */
  ray(event: { clientX: number; clientY: number }): { from: Vector3; along: Vector3 } {
    const box = this.canvas.getBoundingClientRect();
    const wide = box.width / this.shownPanes;
    const x = (((event.clientX - box.left) % wide) / wide) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    const from = this.orbit.camera.position.clone();
    const along = new Vector3(x, y, 0.5).unproject(this.orbit.camera).sub(from).normalize();
    return { from, along };
  }

  /** Something is different: draws at the next occasion. */
  change(): void {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.beforePicture();
      this.draw();
    });
  }

  private draw(): void {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(devicePixelRatio, 2);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    const size = this.renderer.getSize(new Vector4() as never) as unknown as { x: number; y: number };
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    const style = getComputedStyle(this.canvas);
    this.renderer.setClearColor(new Color(style.backgroundColor));
    for (const pane of this.panes) pane.ink(style.color);
    const wide = width / this.shownPanes;
    this.orbit.aspect(wide / height);
    const dotMm = this.summary ? 0.9 * Math.max(this.summary.voxel_mm * 2.2, 0.4) : 1;
    const dot = (dotMm * height * ratio) / (2 * Math.tan((this.orbit.camera.fov * Math.PI) / 360));
    this.object.update(this.orbit.camera.position, this.cut, ratio, dot);
    this.renderer.setScissorTest(true);
    for (let pane = 0; pane < this.shownPanes; ++pane) {
      this.renderer.setViewport(pane * wide, 0, wide, height);
      this.renderer.setScissor(pane * wide, 0, wide, height);
      this.renderer.clear();
      const kept = this.panes.map((marks) => marks.group.visible);
      this.panes.forEach((marks, number) => (marks.group.visible = number === pane && (kept[number] ?? false)));
      this.renderer.render(this.scene, this.orbit.camera);
      this.panes.forEach((marks, number) => (marks.group.visible = kept[number] ?? false));
    }
    this.pictures += 1;
    if (this.summary) document.body.dataset['drawn'] ??= performance.now().toFixed(0); // ms after the page was asked for
  }
}
