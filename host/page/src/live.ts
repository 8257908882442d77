// The ticks of a running hand: the newest one, where it was, and coarse curves of the last seconds.
import { Playout } from './playout';
import { isKnown, length, type RowReader, type Tick, type Vector } from './rows';
import type { Data } from './plots';

const kSeconds = 10; // that the curves show
const kPiece = 0.01; // s; of each the largest force and penetration are kept
const kTrailSeconds = 0.6;
export const kSilentMs = 1000; // a tick that is older is not shown as if it were now
const kDelay = 0.08; // s, longer than a burst of a controller

interface Piece {
  time: number;
  force: number | null;
  penetration: number | null;
  energy: number | null;
}

export class Live {
  newest: Tick | null = null;
  private places: { tick: number; hip: Vector }[] = [];
  /** Ticks that did not come, because this page was too slow. */
  lost = 0;
  period = 1e-3; // s
  every = 1;
  private readonly playout = new Playout(kDelay);
  private pieces: Piece[] = [];
  private next = -1;
  private cameAt = 0; // ms, the newest batch

  clear(): void {
    this.newest = null;
    this.places = [];
    this.pieces = [];
    this.next = -1;
    this.lost = 0;
    this.playout.clear();
  }

  /** Seconds of the newest tick. */
  get time(): number {
    return (this.newest?.tick ?? 0) * this.period;
  }

  take(first: number, every: number, rows: DataView, reader: RowReader): void {
    this.every = every;
    this.cameAt = performance.now();
    const count = Math.floor(rows.byteLength / reader.bytes);
    for (let row = 0; row < count; ++row) this.add(reader.read(rows, row, first + row * every), every);
  }

  add(tick: Tick, every: number): void {
    if (tick.tick < this.next - every) this.clear(); // the controller has started again
    if (this.next >= 0 && tick.tick > this.next) {
      this.lost += (tick.tick - this.next) / every;
      this.pieces.push({ time: this.next * this.period, force: null, penetration: null, energy: null });
    }
    this.next = tick.tick + every;
    this.newest = tick;
    this.playout.add(tick);
    const time = tick.tick * this.period;
    const last = this.pieces[this.pieces.length - 1];
    if (last && last.force !== null && time - last.time < kPiece) {
      last.force = Math.max(last.force, length(tick.force));
      last.penetration = Math.max(last.penetration ?? 0, tick.penetration);
      last.energy = tick.energy;
      return;
    }
    this.pieces.push({ time, force: length(tick.force), penetration: tick.penetration, energy: tick.energy });
    if (isKnown(tick.hip)) this.places.push({ tick: tick.tick, hip: tick.hip });
    if (this.places.length > (2 * kTrailSeconds) / kPiece) this.places.shift();
    const old = this.pieces.findIndex((piece) => piece.time >= time - kSeconds);
    if (old > 100) this.pieces.splice(0, old);
  }

  /** Where the hand was in the moment before a tick. */
  trail(to: number): Vector[] {
    const from = to - kTrailSeconds / this.period;
    return this.places.filter(({ tick }) => tick > from && tick <= to).map(({ hip }) => hip);
  }

  /** Nothing has come for so long that nobody knows what is now. */
  get isSilent(): boolean {
    return performance.now() - this.cameAt >= kSilentMs;
  }

  /** The tick of this moment, a little later than it was; null where none is known. */
  shown(): Tick | null {
    if (this.isSilent) return null;
    return this.playout.at(performance.now() / 1000, this.period);
  }

  curves(): Data[] {
    const from = this.time - kSeconds;
    const shown = this.pieces.filter((piece) => piece.time >= from);
    const times = shown.map((piece) => piece.time);
    return [
      [times, shown.map((piece) => piece.force)],
      [times, shown.map((piece) => piece.penetration)],
      [times, shown.map((piece) => piece.energy)],
    ];
  }
}
