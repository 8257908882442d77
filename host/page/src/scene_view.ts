// The picture: one object, and one or two panes with a hand each, side by side, seen by the same eye. It is drawn only when something changed, and the
// object only when it or the eye did.
import { Box2, Color, Scene, Vector2, Vector3, Vector4, WebGLRenderer } from 'three';
import { Backdrop } from './backdrop';
import { Orbit } from './camera';
import { isOnOneGrid, type Colours, type SceneSummary } from './messages';
import { noCut, ObjectView } from './object';
import { kFinest, Sharpness } from './sharpness';
import { SlicePlane } from './slice_plane';
import { TouchMarks } from './touch_marks';

const kRestMs = 200; // after the last movement the object is drawn finely
const kPane = new Box2(new Vector2(-1, -1), new Vector2(1, 1));
const kMargin = 2; // pixels round what a hand covers: lines and smooth edges
const kZero = new Vector2();
const half = new Vector2();

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
  private readonly behind = new Scene(); // the object
  private readonly front = new Scene(); // its picture, and the hands
  private readonly backdrop = new Backdrop();
  private readonly sharpness = new Sharpness();
  private readonly paper = new Color();
  private size = { width: 0, height: 0 };
  private shownPanes = 1;
  private wanted = false;
  private readonly covered = [new Box2(), new Box2()]; // by the hands, when they were drawn last
  private readonly covers = new Box2();
  private whole = true; // everything is to be drawn, not only where a hand is or was
  private stale: 'no' | 'moving' | 'at rest' = 'moving';
  private rest: ReturnType<typeof setTimeout> | undefined;
  private sliced: { axis: Axis; at: number } | null = null;
  private summary: SceneSummary | null = null;

  /** fails: throws where there is no WebGL */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    colours: Colours,
  ) {
    // What was drawn stays, so that a picture costs no more than what has moved in it.
    const context = canvas.getContext('webgl2', { alpha: false, antialias: true, preserveDrawingBuffer: true, powerPreference: 'high-performance' });
    if (!context) throw new Error('there is no WebGL');
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.autoClear = false;
    this.object = new ObjectView(colours);
    this.slice = new SlicePlane(colours);
    this.panes = [new TouchMarks(colours), new TouchMarks(colours)];
    this.behind.add(this.object.group, this.slice.mesh);
    this.front.add(this.backdrop.mesh, ...this.panes.map((pane) => pane.group));
    this.orbit = new Orbit(() => this.change());
    new ResizeObserver(() => {
      this.size = { width: canvas.clientWidth, height: canvas.clientHeight };
      this.change();
    }).observe(canvas);
    canvas.addEventListener('webglcontextrestored', () => this.change());
    for (const query of ['(prefers-color-scheme: dark)', '(prefers-contrast: more)'])
      matchMedia(query).addEventListener('change', () => this.takeColours());
    this.takeColours();
  }

  /** How many hands are seen side by side: 1 or 2. */
  setPanes(count: number): void {
    this.shownPanes = count;
    this.panes.slice(count).forEach((pane) => pane.clear());
    this.change();
  }

  setScene(summary: SceneSummary): void {
    const grows = this.summary !== null && isOnOneGrid(summary, this.summary);
    this.summary = summary;
    if (grows) return this.change(); // the eye stays where it is
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
    this.sliced = shown ? { axis, at } : null;
    this.change();
  }

  /** The eye's side is another one where it has walked round the object. */
  private cut(): Vector4 {
    if (!this.sliced) return noCut();
    const { axis, at } = this.sliced;
    const normal = new Vector3(Number(axis === 'x'), Number(axis === 'y'), Number(axis === 'z'));
    const side = this.orbit.camera.position[axis] < at ? -1 : 1;
    return new Vector4(side * normal.x, side * normal.y, side * normal.z, side * at + 1e-3);
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

  /** The object or the eye is another one: draws both at the next occasion. */
  change(): void {
    this.stale = 'moving';
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.stale = 'at rest';
      this.moved();
    }, kRestMs);
    delete document.body.dataset['rests'];
    this.moved();
  }

  /** A hand has moved: draws it at the next occasion. */
  moved(): void {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame((now) => {
      this.wanted = false;
      this.beforePicture();
      this.draw(now);
    });
  }

  private takeColours(): void {
    const style = getComputedStyle(this.canvas);
    this.paper.set(style.backgroundColor);
    for (const pane of this.panes) pane.ink(style.color);
    this.whole = true;
    this.moved();
  }

  private draw(now: number): void {
    const { width, height } = this.size;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(devicePixelRatio, 2);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    if (this.canvas.width !== Math.floor(width * ratio) || this.canvas.height !== Math.floor(height * ratio)) this.renderer.setSize(width, height, false);
    const wide = width / this.shownPanes;
    if (this.stale !== 'no') this.drawObject(now, wide * ratio, height * ratio, ratio);
    this.renderer.setClearColor(this.paper, 1);
    this.renderer.setScissorTest(true);
    for (let pane = 0; pane < this.shownPanes; ++pane) {
      this.renderer.setViewport(pane * wide, 0, wide, height);
      if (!this.aim(pane, wide, height)) continue;
      this.renderer.clear();
      this.panes.forEach((marks, number) => (marks.group.visible = number === pane && marks.known));
      this.renderer.render(this.front, this.orbit.camera);
    }
    this.whole = false;
    this.pictures += 1;
    if (this.summary) document.body.dataset['drawn'] ??= performance.now().toFixed(0); // ms after the page was asked for
  }

  /** Confines drawing to where the hand of a pane is and was. False where there is nothing to draw. */
  private aim(pane: number, wide: number, height: number): boolean {
    const covered = this.covered[pane] ?? new Box2();
    const area = this.panes[pane]?.covers(this.orbit.camera, this.covers).clone().union(covered) ?? this.covers;
    covered.copy(this.covers);
    area.intersect(kPane);
    if (this.whole) area.copy(kPane);
    if (area.isEmpty()) return false;
    const low = area.min.addScalar(1).multiply(half.set(wide / 2, height / 2)).subScalar(kMargin).floor().max(kZero);
    const high = area.max.addScalar(1).multiply(half).addScalar(kMargin).ceil();
    this.renderer.setScissor(pane * wide + low.x, low.y, Math.min(high.x, wide) - low.x, Math.min(high.y, height) - low.y);
    return true;
  }

  private drawObject(now: number, width: number, height: number, ratio: number): void {
    const { share, smooth } = this.stale === 'at rest' ? kFinest : this.sharpness.next(now);
    this.orbit.aspect(width / height);
    const dotMm = this.summary ? 0.9 * Math.max(this.summary.voxel_mm * 2.2, 0.4) : 1;
    const dot = (dotMm * height * share) / (2 * Math.tan((this.orbit.camera.fov * Math.PI) / 360));
    this.object.update(this.orbit.camera.position, this.cut(), ratio * share, dot);
    this.backdrop.draw(this.renderer, this.behind, this.orbit.camera, width * share, height * share, smooth);
    if (this.stale === 'at rest') document.body.dataset['rests'] = 'yes';
    this.stale = 'no';
    this.whole = true;
  }
}
