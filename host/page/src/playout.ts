// A controller passes ticks on in bursts, about every 50 ms. Played out a moment later at their own pace, every picture shows another tick.
import type { Tick } from './rows';

const kKept = 1500; // ticks

export class Playout {
  private ticks: Tick[] = [];
  private offset = Infinity; // from a tick's own time to the time of the page, where a tick came quickest, s

  /** `delay` is how much later than the quickest tick everything is shown, s. */
  constructor(private readonly delay: number) {}

  clear(): void {
    this.ticks = [];
    this.offset = Infinity;
  }

  add(tick: Tick): void {
    this.ticks.push(tick);
    if (this.ticks.length > kKept) this.ticks.splice(0, kKept / 3);
  }

  /** A burst has come whole. */
  came(now: number, period: number): void {
    const last = this.ticks[this.ticks.length - 1];
    if (!last) return;
    const offset = now - last.tick * period;
    this.offset = offset > this.offset + 1 ? offset : Math.min(offset, this.offset + 0.0005); // two clocks drift; a controller may have paused
  }

  /** The tick that is to be seen now; null where none has come. */
  at(now: number, period: number): Tick | null {
    const wanted = (now - this.offset - this.delay) / period;
    let low = 0;
    let high = this.ticks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.ticks[middle]?.tick ?? 0) <= wanted) low = middle;
      else high = middle - 1;
    }
    return this.ticks[low] ?? null;
  }
}
