/** What stands between a pointer and the core: when ticks are due, and where the hand is in each. Pure; the caller has the clock. */

/** Says how many ticks are due, so that a timer that wakes late is caught up with. */
export class Pace {
  readonly #period: number;
  readonly #maxLate: number;
  #next: number;
  /** Ticks that were left out, because the page was held up for longer than can be caught up with. */
  skipped = 0;

  /**
   * @param now ms
   * @param period ms from tick to tick
   * @param maxLate ms that are caught up with at once
   */
  constructor(now: number, period = 1, maxLate = 100) {
    this.#next = now;
    this.#period = period;
    this.#maxLate = maxLate;
  }

  /** Ticks that are due at `now`; they count as done. */
  due(now: number): number {
    const late = Math.floor((now - this.#next) / this.#period) + 1;
    if (late <= 0) return 0;
    const taken = Math.min(late, Math.floor(this.#maxLate / this.#period));
    this.skipped += late - taken;
    this.#next += late * this.#period;
    return taken;
  }
}

/** A place, mm. */
export type Place = readonly [number, number, number];

/**
 * Follows a pointer, which reports its place sixty times a second or less, as a hand moves: smoothly, and never faster than a hand.
 */
export class FollowingHand {
  #at: [number, number, number] | null = null;
  #target: Place = [0, 0, 0];
  readonly #share: number;
  readonly #maxMove: number;

  /**
   * @param ticks time constant, in ticks
   * @param maxMove mm in a tick; 1 at 1 kHz is 1 m/s
   */
  constructor(ticks = 12, maxMove = 1) {
    this.#share = 1 - Math.exp(-1 / ticks);
    this.#maxMove = maxMove;
  }

  /** Where the pointer is; the first place is taken at once. */
  moveTo(target: Place): void {
    this.#target = target;
    this.#at ??= [...target];
  }

  /** Takes the pointer up: the next place is taken at once. */
  lift(): void {
    this.#at = null;
  }

  /** Is there a hand? */
  get isThere(): boolean {
    return this.#at !== null;
  }

  /** The hand's place in the next ticks: x, y, z of each. */
  next(ticks: number): Float64Array {
    const places = new Float64Array(3 * ticks);
    const at = this.#at ?? [...this.#target];
    for (let tick = 0; tick < ticks; ++tick) {
      const move = this.#target.map((target, axis) => (target - at[axis]!) * this.#share);
      const length = Math.hypot(...move);
      const part = length > this.#maxMove ? this.#maxMove / length : 1;
      for (let axis = 0; axis < 3; ++axis) at[axis] = at[axis]! + move[axis]! * part;
      places.set(at, 3 * tick);
    }
    return places;
  }
}
