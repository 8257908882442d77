// One recording: its ticks are fetched in blocks as they are shown, its curves for whatever part of it is seen.
import type { TraceEvent, TraceSummary, Words } from './messages';
import { isKnown, type RowReader, type Tick, type Vector } from './rows';

const kBlock = 2048; // ticks
const kKept = 24; // blocks
const kTrailSeconds = 0.5;
const kTrailPlaces = 100;
const kRounding = 1e-6; // of a piece: equal times may differ in their last bit

/** Where a recording comes from: the server, or the page's own trace. */
export interface Source {
  trace(number: number): Promise<TraceSummary>;
  rows(number: number, from: number, count: number): Promise<DataView>;
  curves(number: number, from: number, to: number, pieces: number): Promise<DataView>;
  words(number: number, tick: number): Promise<Words>;
}

export interface Curves {
  times: number[]; // s
  force: number[];
  penetration: number[];
  energy: number[];
}

/**
 * A curve in the pieces of another one: of its own pieces that lie in each the largest force or penetration, or the last energy. Null behind its end.
 *
 * @param times where the other one's pieces begin, s
 */
export function inPieces(times: number[], curves: Curves, name: 'force' | 'penetration' | 'energy'): (number | null)[] {
  const stepOf = (of: number[]): number => (of[1] ?? 1) - (of[0] ?? 0);
  const first = curves.times[0] ?? 0;
  const step = stepOf(curves.times);
  return times.map((time) => {
    const from = Math.floor((time - first) / step + kRounding);
    const to = Math.ceil((time + stepOf(times) - first) / step - kRounding);
    const inside = curves[name].slice(from, Math.max(from + 1, to));
    return (name === 'energy' ? inside.at(-1) : inside.length > 0 ? Math.max(...inside) : null) ?? null;
  });
}

export class Recording {
  private readonly blocks = new Map<number, DataView>();
  private readonly asked = new Set<number>();

  private constructor(
    readonly number: number,
    readonly summary: TraceSummary,
    private readonly source: Source,
    private readonly reader: RowReader,
    private readonly came: () => void,
  ) {}

  static async open(number: number, source: Source, reader: RowReader, came: () => void): Promise<Recording> {
    return new Recording(number, await source.trace(number), source, reader, came);
  }

  get period(): number {
    return this.summary.period_ns * 1e-9;
  }

  /** Null until its block has come; `came` says so. */
  tick(number: number): Tick | null {
    if (number < 0 || number >= this.summary.ticks) return null;
    const block = this.block(Math.floor(number / kBlock));
    const row = number % kBlock;
    return block && (row + 1) * this.reader.bytes <= block.byteLength ? this.reader.read(block, row, number) : null;
  }

  trail(to: number): Vector[] {
    const places: Vector[] = [];
    const ticks = Math.round(kTrailSeconds / this.period);
    const step = Math.max(1, Math.round(ticks / kTrailPlaces));
    for (let tick = to - ticks; tick <= to; tick += step) {
      const known = this.tick(tick);
      if (known && isKnown(known.hip)) places.push(known.hip);
    }
    return places;
  }

  words(tick: number): Promise<Words> {
    return this.source.words(this.number, tick);
  }

  async curves(pieces: number): Promise<Curves> {
    const view = await this.source.curves(this.number, 0, this.summary.ticks, pieces);
    const [from, step, count] = [view.getUint32(0, true), view.getUint32(4, true), view.getUint32(8, true)];
    const curves: Curves = { times: [], force: [], penetration: [], energy: [] };
    for (let piece = 0; piece < count; ++piece) {
      const at = 12 + 16 * piece;
      curves.times.push((from + piece * step) * this.period);
      curves.force.push(view.getFloat32(at, true));
      curves.penetration.push(view.getFloat32(at + 4, true));
      curves.energy.push(view.getFloat32(at + 8, true));
    }
    return curves;
  }

  /** The next event of a kind behind a tick; from the beginning where there is none. */
  nextEvent(kind: string, behind: number): TraceEvent | null {
    const all = this.summary.events.filter((event) => event.kind === kind);
    return all.find((event) => event.tick > behind) ?? all[0] ?? null;
  }

  lastEvent(at: number): TraceEvent | null {
    let last: TraceEvent | null = null;
    for (const event of this.summary.events) if (event.tick <= at) last = event;
    return last;
  }

  private block(number: number): DataView | null {
    const known = this.blocks.get(number);
    if (known) return known;
    if (!this.asked.has(number)) {
      this.asked.add(number);
      this.source
        .rows(this.number, number * kBlock, kBlock)
        .then((rows) => {
          if (this.blocks.size >= kKept) this.blocks.delete(this.blocks.keys().next().value as number);
          this.blocks.set(number, rows);
          this.came();
        })
        .catch(() => {}) // it is asked for again
        .finally(() => this.asked.delete(number));
    }
    return null;
  }
}
