/** The worker's work, without a worker: messages in, messages out, a clock and a timer from the caller. */
import { FollowingHand, Pace } from "./hand.js";
import { NUMBERS_OF_A_TICK, Touch, TouchError } from "./touch.js";
import type { FromWorker, ToWorker } from "./touch_messages.js";

/** What the worker stands on. */
export interface Surroundings {
  /** ms, monotonic */
  now(): number;
  /** Calls back once, as soon as it can be after about a millisecond. */
  soon(call: () => void): void;
  post(message: FromWorker, transferred?: Transferable[]): void;
}

const MS_BETWEEN_REPORTS = 16;

export class TouchServer {
  readonly #around: Surroundings;
  #touch: Touch | null = null;
  readonly #hand = new FollowingHand();
  #buttons = 0;
  #pace: Pace | null = null;
  #runs = false;
  #ticks: Float64Array[] = [];
  #count = 0;
  #skipped = 0;
  #busy = 0;
  #reported = 0;

  constructor(around: Surroundings) {
    this.#around = around;
  }

  /** Handles one message. What is refused is answered by `refused`; it never throws. */
  async take(message: ToWorker): Promise<void> {
    try {
      if (message.kind === "begin") await this.#begin(message.module);
      else this.#obey(message, this.#begun());
    } catch (error) {
      this.#refuse(message.kind, error);
    }
  }

  async #begin(module: WebAssembly.Module): Promise<void> {
    this.#touch = await Touch.create(module);
    this.#around.post({ kind: "ready", settings: this.#touch.settings });
  }

  #begun(): Touch {
    if (this.#touch === null) throw new TouchError("the first message must be 'begin'");
    return this.#touch;
  }

  #obey(message: Exclude<ToWorker, { kind: "begin" }>, touch: Touch): void {
    switch (message.kind) {
      case "load":
        this.#around.post({ kind: "loaded", field: touch.load(message.image, message.name) });
        break;
      case "hand":
        this.#hand.moveTo(message.place);
        this.#buttons = message.buttons ?? 0;
        this.#start();
        break;
      case "lift":
        this.#hand.lift();
        touch.lift();
        break;
      case "set":
        touch.set(message.name, message.value);
        this.#around.post({ kind: "set", name: message.name, value: touch.setting(message.name) });
        break;
      case "record":
        touch.record(message.maxTicks);
        break;
      case "save": {
        const bytes = touch.trace();
        this.#around.post({ kind: "trace", bytes, ticks: touch.recorded }, [bytes.buffer as ArrayBuffer]);
        break;
      }
      case "sample": {
        const distances = touch.sample(message.places);
        this.#around.post({ kind: "distances", distances, ticket: message.ticket }, [distances.buffer as ArrayBuffer]);
        break;
      }
    }
  }

  /** Ticks run while there are a hand and a field. */
  #start(): void {
    if (this.#runs || this.#touch?.field == null) return;
    this.#runs = true;
    this.#pace = new Pace(this.#around.now());
    this.#reported = this.#around.now();
    this.#wake();
  }

  #wake(): void {
    if (!this.#hand.isThere || this.#touch?.field == null || this.#pace === null) {
      this.#runs = false;
      if (this.#touch !== null && this.#ticks.length > 0) this.#report(this.#around.now());
      return;
    }
    const now = this.#around.now();
    const skippedBefore = this.#pace.skipped;
    const due = this.#pace.due(now);
    this.#skipped += this.#pace.skipped - skippedBefore;
    try {
      if (due > 0) this.#ticks.push(this.#touch.run(this.#hand.next(due), this.#buttons));
    } catch (error) {
      this.#hand.lift();
      this.#refuse("hand", error);
    }
    this.#count += due;
    const done = this.#around.now();
    this.#busy += done - now;
    if (done - this.#reported >= MS_BETWEEN_REPORTS) this.#report(done);
    this.#around.soon(() => this.#wake());
  }

  #report(now: number): void {
    const touch = this.#begun();
    const ticks = new Float64Array(this.#ticks.reduce((sum, part) => sum + part.length, 0));
    this.#ticks.reduce((at, part) => (ticks.set(part, at), at + part.length), 0);
    this.#ticks = [];
    const busy = this.#busy / Math.max(now - this.#reported, 1);
    this.#busy = 0;
    this.#reported = now;
    if (ticks.length < NUMBERS_OF_A_TICK) return;
    const { recorded, waiting } = touch;
    this.#around.post({ kind: "felt", ticks, count: this.#count, skipped: this.#skipped, recorded, waiting, busy }, [ticks.buffer as ArrayBuffer]);
  }

  #refuse(of: ToWorker["kind"], error: unknown): void {
    const sentence = error instanceof Error ? error.message : String(error);
    this.#around.post({ kind: "refused", of, sentence });
  }
}
