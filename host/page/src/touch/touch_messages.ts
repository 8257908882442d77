/** What page and worker say to each other. Every message is one of these, and `kind` tells which. */
import type { Field, Setting } from "./touch.js";

export type ToWorker =
  /** first of all: the compiled touch.wasm; answered by `ready` or `refused` */
  | { readonly kind: "begin"; readonly module: WebAssembly.Module }
  /** a field's image, which may be transferred; answered by `loaded` or `refused` */
  | { readonly kind: "load"; readonly image: Uint8Array; readonly name: string }
  /** where the pointer is, mm, and the buttons held; ticks run from the first one on */
  | { readonly kind: "hand"; readonly place: readonly [number, number, number]; readonly buttons?: number }
  /** the pointer left: ticks pause until the next `hand` */
  | { readonly kind: "lift" }
  /** answered by `set`, or `refused` */
  | { readonly kind: "set"; readonly name: string; readonly value: number }
  /** begins a trace of at most that many ticks, 0 ends recording; answered by `refused` if it was */
  | { readonly kind: "record"; readonly maxTicks: number }
  /** answered by `trace` */
  | { readonly kind: "save" }
  /** distances at places, mm; answered by `distances` with the same `ticket`, or `refused` */
  | { readonly kind: "sample"; readonly places: Float64Array; readonly ticket: number };

export type FromWorker =
  | { readonly kind: "ready"; readonly settings: readonly Setting[] }
  | { readonly kind: "loaded"; readonly field: Field }
  | { readonly kind: "set"; readonly name: string; readonly value: number }
  /** about sixty times a second while there is a hand */
  | {
      readonly kind: "felt";
      /** every tick since the last such message, see `At` in touch.ts; transferred */
      readonly ticks: Float64Array;
      /** ticks so far */
      readonly count: number;
      /** ticks that were left out because the page was held up */
      readonly skipped: number;
      /** ticks in the trace */
      readonly recorded: number;
      /** the trace begins when the hand touches nothing */
      readonly waiting: boolean;
      /** share of the time that the core computed */
      readonly busy: number;
    }
  | { readonly kind: "trace"; readonly bytes: Uint8Array; readonly ticks: number }
  | { readonly kind: "distances"; readonly distances: Float64Array; readonly ticket: number }
  /** one sentence for a person; `of` is the message that was refused */
  | { readonly kind: "refused"; readonly of: ToWorker["kind"]; readonly sentence: string };
