// The slice: which axis, where, and that it follows the mouse. One request at a time; the newest wish wins.
import { Choice, element } from './dom';
import { isOnOneGrid, type SceneSummary } from './messages';
import type { Axis, SceneView } from './scene_view';

const kSamples = 160;
const kAxes: Axis[] = ['x', 'y', 'z'];

export class SliceControl {
  shown = false;
  private axis: Axis = 'z';
  private at = 0;
  private summary: SceneSummary | null = null;
  private asking = false;
  private again = false;
  private readonly range = element<HTMLInputElement>('slice-at');
  private readonly choice: Choice;

  constructor(
    private readonly view: SceneView,
    private readonly fetch: (of: SceneSummary, axis: string, at: number, samples: number) => Promise<DataView>,
  ) {
    this.choice = new Choice(element('slice-axes'), (name) => {
      this.axis = name as Axis;
      this.limits();
      this.move(this.at);
    });
    for (const axis of kAxes) this.choice.add(axis, axis);
    this.range.addEventListener('input', () => this.move(Number(this.range.value)));
  }

  setScene(summary: SceneSummary): void {
    if (!this.summary || !isOnOneGrid(summary, this.summary)) this.at = 0;
    this.summary = summary;
    this.choice.choose(this.axis);
  }

  show(shown: boolean): void {
    this.shown = shown;
    element('slice').hidden = !shown;
    if (shown) this.move(this.at);
    else this.view.setSlice(false, this.axis, this.at);
  }

  choose(axis: Axis): void {
    this.choice.choose(axis);
  }

  follow(event: PointerEvent): void {
    if (this.shown && event.buttons === 0) this.move(this.view.placeOnAxis(event, this.axis));
  }

  step(voxels: number): void {
    this.move(this.at + voxels * (this.summary?.voxel_mm ?? 1));
  }

  private limits(): void {
    const number = kAxes.indexOf(this.axis);
    this.range.min = String(this.summary?.low_mm[number] ?? -1);
    this.range.max = String(this.summary?.high_mm[number] ?? 1);
  }

  private move(at: number): void {
    this.at = Math.max(Number(this.range.min), Math.min(Number(this.range.max), at));
    this.range.value = String(this.at);
    element('slice-text').textContent = `${this.axis} = ${this.at.toFixed(1)} mm`;
    if (this.shown) void this.ask();
  }

  private async ask(): Promise<void> {
    const summary = this.summary;
    if (!summary) return;
    this.again = this.asking;
    if (this.asking) return;
    this.asking = true;
    const { axis, at } = this;
    try {
      const distances = await this.fetch(summary, axis, at, kSamples);
      if (this.shown && summary === this.summary) {
        this.view.slice.set(distances, summary.voxel_mm, summary.band_mm);
        this.view.setSlice(true, axis, at);
      }
    } catch {
      this.again = summary !== this.summary; // else the server is gone, and the page says so, or a newer object comes by itself
    }
    this.asking = false;
    if (this.again && this.shown) void this.ask();
  }
}
