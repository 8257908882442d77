// A controller passes ticks on in bursts, about every 50 ms. Played out a moment later and evenly, every picture shows another tick.
import type { Tick } from './rows';

const kKept = 1500; // ticks
const kSmooth = 0.5; // s; over this time bursts are even
const kFastest = 2; // times the controller's own pace, as kSlowest
const kSlowest = 0.5;
const kTooFar = 4; // times the delay; who is farther behind was asleep

export class Playout {
  private ticks: Tick[] = [];
  private place = -1; // where the playing is, in ticks and parts of one
  private waiting = 0; // ticks behind it, on average
  private before = 0; // s

  /** `delay` is how long a tick waits until it is shown, s: longer than a burst. */
  constructor(private readonly delay: number) {}

  clear(): void {
    this.ticks = [];
    this.place = -1;
  }

  add(tick: Tick): void {
    this.ticks.push(tick);
    if (this.ticks.length > kKept) this.ticks.splice(0, kKept / 3);
  }

  /**
   * The tick that is to be seen now; null where none has come. It is played faster while many wait and slower while few do, so that neither a controller
   * that is late nor another clock empties what waits.
   *
   * @param now s
   * @param period of the ticks, s
   */
  at(now: number, period: number): Tick | null {
    const last = this.ticks[this.ticks.length - 1];
    if (!last) return null;
    const wanted = this.delay / period;
    if (this.place < 0 || last.tick - this.place > kTooFar * wanted) {
      this.place = last.tick - wanted;
      this.waiting = wanted;
      this.before = now;
    }
    const passed = now - this.before;
    this.before = now;
    this.waiting += (last.tick - this.place - this.waiting) * (1 - Math.exp(-passed / kSmooth));
    const pace = Math.max(kSlowest, Math.min(kFastest, this.waiting / wanted));
    this.place = Math.max(0, Math.min(last.tick, this.place + (pace * passed) / period));
    return this.upTo(this.place);
  }

  /** The last tick that is not behind a place. */
  private upTo(place: number): Tick | null {
    let low = 0;
    let high = this.ticks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.ticks[middle]?.tick ?? 0) <= place) low = middle;
      else high = middle - 1;
    }
    return this.ticks[low] ?? null;
  }
}
