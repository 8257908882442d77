// Touch with the pointer: the hand, its controls beside the picture, and what it felt.
import { element, make, toggle } from './dom';
import { Live } from './live';
import type { SceneSummary } from './messages';
import type { SceneView } from './scene_view';
import type { Server } from './server';
import { TouchHand, type Felt } from './touch_hand';
import { TouchSound } from './touch_sound';

const kBeginsAt = 0.8; // of the object's radius before its middle

export class TouchPanel {
  readonly touched = new Live();
  private readonly sound = new TouchSound();
  private readonly depth = make('input', { type: 'range', id: 'depth', step: '0.1' });
  private readonly depthText = make('output', { htmlFor: 'depth' } as object);
  private hand: TouchHand | null = null;
  private felt: Felt | null = null;
  private name = 'touch';

  /** `moved`: the hand has felt something new. */
  constructor(private readonly server: Server, private readonly moved: () => void, private readonly notice: (sentence: string) => void) {
    const save = make('button', { type: 'button', textContent: 'Save as trace' });
    save.addEventListener('click', () => void this.saveTrace());
    this.depth.addEventListener('input', () => this.hand?.toDepth(-Number(this.depth.value)));
    element('touch').append(
      make('p', { textContent: 'The pointer is your hand. Turn the wheel, press Page down, or move the slider to press it into the object.' }),
      make('label', {}, 'Depth of the hand, from the middle of the object, mm ', this.depth, ' ', this.depthText),
      save,
      toggle('Sound', '', false, (on) => this.sound.turn(on)),
    );
  }

  /** Without a view there is no hand. */
  attach(view: SceneView, canvas: HTMLCanvasElement): void {
    this.hand = new TouchHand(view, canvas, (felt) => this.feel(felt), this.notice, () => this.sound.rest(), (mm) => {
      this.depth.value = String(-mm);
      this.depthText.textContent = (-mm).toFixed(1);
    });
  }

  get on(): boolean {
    return this.hand?.on ?? false;
  }

  key(key: string): boolean {
    return this.hand?.key(key) ?? false;
  }

  /** `isWanted`: asked once the object is loaded, because another source or object may have been chosen meanwhile. */
  async begin(summary: SceneSummary, isWanted: () => boolean): Promise<void> {
    if (!this.hand) return;
    this.hand.end();
    this.touched.clear();
    await this.load(summary);
    if (!isWanted()) return;
    const half = summary.high_mm.map((high, axis) => (high - (summary.low_mm[axis] ?? 0)) / 2);
    const radius = Math.hypot(...half);
    this.depth.min = String(-radius);
    this.depth.max = String(radius);
    this.hand.begin(kBeginsAt * radius);
  }

  end(): void {
    this.hand?.end();
  }

  /** Whether the core in this page has this object. */
  has(object: SceneSummary): boolean {
    return this.hand?.loaded === object;
  }

  /** Distances by the core in this page. */
  async sample(of: SceneSummary, places: Float64Array): ReturnType<TouchHand['sample']> {
    if (!this.hand) throw new Error('there is no object');
    if (!this.has(of)) await this.load(of);
    return this.hand.sample(places);
  }

  /** What the table shows beside the tick. */
  numbers(): [string, string][] {
    return [
      ['Ticks in the trace', `${this.felt?.recorded ?? 0}`],
      ['Ticks left out, because the page was held up', `${this.felt?.skipped ?? 0}`],
      ['Time that the core computes', `${(100 * (this.felt?.busy ?? 0)).toFixed(1)} %`],
    ];
  }

  private async load(summary: SceneSummary): Promise<void> {
    this.name = summary.name;
    await this.hand?.load((await this.server.part('field', summary)).buffer as ArrayBuffer, summary);
  }

  private feel(felt: Felt): void {
    if (!this.on) return; // of a hand that has left: another object is being loaded
    const before = this.touched.newest;
    for (const tick of felt.ticks) this.touched.add(tick, 1);
    const last = felt.ticks[felt.ticks.length - 1];
    if (last) this.sound.follow(before, last, (last.tick - (before?.tick ?? last.tick)) * this.touched.period);
    this.felt = felt;
    this.moved();
  }

  private async saveTrace(): Promise<void> {
    const { bytes, ticks } = (await this.hand?.save()) ?? { bytes: new Uint8Array(), ticks: 0 };
    if (ticks === 0) {
      this.notice('There is no tick to save yet; move the hand over the picture first.');
      return;
    }
    this.notice('');
    const link = make('a', { href: URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>])), download: `${this.name}.trace` });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}
