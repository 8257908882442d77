/**
 * Touches a field in the page: `touch.wasm` is the controller's integer core without a device, and this class is its only caller.
 *
 * Frame: x right, y up, z towards the person. Lengths are mm, forces N, distances negative inside. What is refused throws a `TouchError` with one
 * sentence and changes nothing; the module itself never traps on bad input.
 */

/** Why something was refused, as a sentence for a person. */
export class TouchError extends Error {
  override name = "TouchError";
}

/** Bits of a tick's status, as `isotouch trace show` names them (shared/tick_io.h). "Limited" is no fault. */
export const Status = {
  /** the proxy is held by the surface, the force is that of contact */
  contact: 1 << 0,
  /** the proxy is on its way to the HIP in free space and has not arrived: no force */
  following: 1 << 1,
  /** the HIP is outside the sampled box */
  outsideGrid: 1 << 2,
  /** the HIP began inside the object: no force until it has left */
  heldInside: 1 << 3,
  /** the force is below its full value because contact did not begin at rest */
  ramping: 1 << 4,
  /** the force was shortened to its limit, its direction kept */
  forceLimited: 1 << 5,
  /** the HIP was outside ±512 mm and was moved to the border */
  inputClamped: 1 << 7,
  /** the passivity controller adds damping */
  damped: 1 << 24,
} as const;

/** Numbers of one tick in an array of ticks. */
export const NUMBERS_OF_A_TICK = 12;
/** Where each stands among them: HIP, proxy (mm) and force (N) with x, y, z; penetration (mm); work done on the hand (mJ); status bits. */
export const At = { hip: 0, proxy: 3, force: 6, penetration: 9, energy: 10, status: 11 } as const;

/** One number that decides how the field feels: a row of shared/settings_table.h. */
export interface Setting {
  readonly name: string;
  /** empty: a plain number */
  readonly unit: string;
  readonly meaning: string;
  readonly low: number;
  readonly high: number;
  /** the default */
  readonly standard: number;
  /** 0 is valid although it lies outside the range: nothing was set */
  readonly mayBeUnset: boolean;
}

/** The loaded field, as its header says. */
export interface Field {
  /** 16 hexadecimal digits, as `isotouch info` prints it */
  readonly hash: string;
  /** place of the first sample, mm */
  readonly origin: readonly [number, number, number];
  /** mm of a voxel */
  readonly edge: number;
  /** samples along each axis */
  readonly size: readonly [number, number, number];
  /** mm; no distance is larger */
  readonly band: number;
  /** N/mm, the largest; what is felt while the setting is unset */
  readonly stiffness: number;
}

/** What came out of a recording that was computed again. */
export interface Replayed {
  readonly ticks: number;
  /** as `isotouch replay` prints it */
  readonly hash: string;
  /** the first tick that is not answered as recorded; null when every bit is equal */
  readonly firstDifference: number | null;
}

/**
 * Exports of touch.wasm (host/touch/module/exports.cpp). Addresses are numbers; those of sentences are 0 when nothing was refused. JavaScript gets 32 bits as
 * a signed number: addresses and sizes are taken with `>>> 0`, because a memory may be larger than 2 GiB.
 */
interface Exports {
  readonly memory: WebAssembly.Memory;
  image_room(bytes: number): number;
  load(): number;
  field_numbers(): number;
  field_hash(): bigint;
  setting_count(): number;
  setting_name(number: number): number;
  setting_unit(number: number): number;
  setting_meaning(number: number): number;
  setting_low(number: number): number;
  setting_high(number: number): number;
  setting_standard(number: number): number;
  setting_may_be_unset(number: number): number;
  setting(number: number): number;
  set(number: number, value: number): number;
  set_period(ns: number): number;
  device_bytes(): number;
  standard_device(which: number): void;
  set_device(): number;
  batch(): number;
  places(): number;
  numbers(): number;
  run(count: number, buttons: number): number;
  lift(): void;
  sample(count: number): number;
  record_room(maxTicks: number): number;
  recorded(): number;
  waits(): number;
  trace_bytes(): number;
  trace_address(): number;
  replay_room(bytes: number, patchesBytes: number): number;
  replay(): number;
  replay_hash(): bigint;
}

const DEVICE_BYTES = 128;
/** Bytes: patches begin behind the recording at a multiple of it. */
const ALIGNMENT = 64;

export class Touch {
  /** Every setting that the core knows, in the order of their numbers. */
  readonly settings: readonly Setting[];
  readonly #exports: Exports;
  readonly #numberOf: ReadonlyMap<string, number>;
  readonly #batch: number;
  #field: Field | null = null;

  /** `module` is the compiled touch.wasm; it imports nothing. Each `Touch` has a memory of its own. */
  static async create(module: WebAssembly.Module): Promise<Touch> {
    const instance = await WebAssembly.instantiate(module, {});
    return new Touch(instance.exports as unknown as Exports);
  }

  private constructor(exports: Exports) {
    this.#exports = exports;
    this.#batch = exports.batch();
    this.settings = Array.from({ length: exports.setting_count() }, (_, number) => ({
      name: this.#text(exports.setting_name(number)),
      unit: this.#text(exports.setting_unit(number)),
      meaning: this.#text(exports.setting_meaning(number)),
      low: exports.setting_low(number),
      high: exports.setting_high(number),
      standard: exports.setting_standard(number),
      mayBeUnset: exports.setting_may_be_unset(number) !== 0,
    }));
    this.#numberOf = new Map(this.settings.map(({ name }, number) => [name, number]));
  }

  /** The field that is felt; null before `load`, and after an image was refused. */
  get field(): Field | null {
    return this.#field;
  }

  /**
   * Takes a field's image, which is what `isotouch export FIELD -o FIELD.itfi` writes (a packed .itf is not unpacked here). It is checked as completely
   * as a controller checks it. The field before, and its trace, are gone in any case.
   *
   * @param image its bytes; they are copied
   * @param name stands for the file in the sentence of a refusal
   */
  load(image: Uint8Array, name = "the field"): Field {
    this.#field = null;
    const room = this.#exports.image_room(image.byteLength) >>> 0;
    if (room === 0) throw new TouchError(`${name}: there is not enough memory for its ${image.byteLength} bytes`);
    new Uint8Array(this.#exports.memory.buffer).set(image, room);
    this.#check(this.#exports.load(), `${name}: `);
    this.#check(this.#exports.field_numbers());
    const [x, y, z, edge, nx, ny, nz, band, stiffness] = this.#numbers(9) as unknown as [
      number, number, number, number, number, number, number, number, number,
    ];
    this.#field = { hash: hashText(this.#exports.field_hash()), origin: [x, y, z], edge, size: [nx, ny, nz], band, stiffness };
    return this.#field;
  }

  /** The value that holds now, in the setting's unit. */
  setting(name: string): number {
    return this.#exports.setting(this.#number(name));
  }

  /**
   * Changes a setting at once, also in contact. The trace in memory ends: take it before with `trace`. The next one begins when the hand touches nothing.
   */
  set(name: string, value: number): void {
    this.#check(this.#exports.set(this.#number(name), value), `${name}: `);
  }

  /** Time from one tick to the next, 100,000 to 4,000,000 ns; 1,000,000 unless set. Ends the trace as `set` does. */
  setPeriod(ns: number): void {
    this.#check(this.#exports.set_period(ns), "the period: ");
  }

  /**
   * The device that the trace's header names: 128 bytes as shared/SPEC.md, section 5, has them, or one of the published sets. Without a device only its
   * play is felt. Ends the trace as `set` does.
   */
  setDevice(device: Uint8Array | "libnifalcon" | "martin-hillier"): void {
    if (typeof device === "string") {
      this.#exports.standard_device(device === "martin-hillier" ? 1 : 0);
    } else {
      if (device.byteLength !== DEVICE_BYTES) {
        throw new TouchError(`the device model has ${device.byteLength} bytes instead of ${DEVICE_BYTES}`);
      }
      new Uint8Array(this.#exports.memory.buffer).set(device, this.#exports.device_bytes() >>> 0);
    }
    this.#check(this.#exports.set_device());
  }

  /**
   * One tick for each place of the hand.
   *
   * @param places x, y, z of each, mm; the core rounds them to 2^-20 mm, and beyond ±512 mm takes the nearest place there
   * @param buttons bits 0 to 3, recorded with every tick
   * @returns NUMBERS_OF_A_TICK numbers for each tick, see `At`; exact, so that two runs can be compared to the bit
   * @throws TouchError without a field, and at the first coordinate that is no number; ticks before it have happened
   */
  run(places: ArrayLike<number>, buttons = 0): Float64Array {
    const answers = new Float64Array((countOf(places) * NUMBERS_OF_A_TICK));
    this.#inBatches(places, (count, done) => {
      this.#check(this.#exports.run(count, buttons));
      answers.set(this.#numbers(count * NUMBERS_OF_A_TICK), done * NUMBERS_OF_A_TICK);
    });
    return answers;
  }

  /** The hand leaves: its way to where it comes back is no way against a force. */
  lift(): void {
    this.#exports.lift();
  }

  /**
   * The field's distance at places, mm, at most `field.band`; for slices and pictures. Touching does not notice.
   *
   * @param places x, y, z of each, mm
   */
  sample(places: ArrayLike<number>): Float64Array {
    const distances = new Float64Array(countOf(places));
    this.#inBatches(places, (count, done) => {
      this.#check(this.#exports.sample(count));
      distances.set(this.#numbers(count), done);
    });
    return distances;
  }

  /**
   * Begins a trace of at most that many ticks (104 bytes each), 0 ends recording. The trace begins with the first tick whose hand touches nothing, because a
   * replay begins there, too. `waiting` is true until then.
   */
  record(maxTicks: number): void {
    this.#check(this.#exports.record_room(maxTicks));
  }

  /** Ticks in the trace. It has ended when this grows no more. */
  get recorded(): number {
    return this.#exports.recorded();
  }

  /** Does the trace wait until the hand touches nothing? */
  get waiting(): boolean {
    return this.#exports.waits() !== 0;
  }

  /** The trace so far as a whole file, which `isotouch replay --check FIELD TRACE` accepts; empty without a tick. Recording goes on. */
  trace(): Uint8Array {
    const bytes = this.#exports.trace_bytes() >>> 0;
    const address = this.#exports.trace_address() >>> 0;
    return new Uint8Array(this.#exports.memory.buffer).slice(address, address + bytes);
  }

  /**
   * Computes a recording again, of positions or of a device's packets, as `isotouch replay --check` does. The trace in memory ends; touching goes on as it was.
   *
   * @param trace the file's bytes, with outputs; recorded on the loaded field
   * @param name stands for the file in the sentence of a refusal
   * @param patches the bytes of the recording's `.patches`, if the field changed while it was felt
   */
  replay(trace: Uint8Array, name = "the recording", patches = new Uint8Array()): Replayed {
    const room = this.#exports.replay_room(trace.byteLength, patches.byteLength) >>> 0;
    if (room === 0) throw new TouchError(`${name}: there is not enough memory for its ${trace.byteLength + patches.byteLength} bytes`);
    const memory = new Uint8Array(this.#exports.memory.buffer);
    memory.set(trace, room);
    memory.set(patches, room + Math.ceil(trace.byteLength / ALIGNMENT) * ALIGNMENT);
    this.#check(this.#exports.replay(), `${name}: `);
    const [ticks = 0, equal = 0, first = 0] = this.#numbers(3);
    return { ticks, hash: hashText(this.#exports.replay_hash()), firstDifference: equal === 1 ? null : first };
  }

  #number(name: string): number {
    const number = this.#numberOf.get(name);
    if (number === undefined) throw new TouchError(`no setting is called '${name}'; there are: ${this.settings.map((row) => row.name).join(", ")}`);
    return number;
  }

  #check(sentence: number, before = ""): void {
    if (sentence !== 0) throw new TouchError(before + this.#text(sentence));
  }

  #text(address: number): string {
    const bytes = new Uint8Array(this.#exports.memory.buffer);
    const begin = address >>> 0;
    return new TextDecoder().decode(bytes.slice(begin, bytes.indexOf(0, begin)));
  }

  /** A view; it ends with the next growth of the memory. */
  #numbers(count: number): Float64Array {
    return new Float64Array(this.#exports.memory.buffer, this.#exports.numbers() >>> 0, count);
  }

  #inBatches(places: ArrayLike<number>, use: (count: number, done: number) => void): void {
    const all = countOf(places);
    for (let done = 0; done < all; done += this.#batch) {
      const count = Math.min(this.#batch, all - done);
      const room = new Float64Array(this.#exports.memory.buffer, this.#exports.places() >>> 0, 3 * count);
      for (let i = 0; i < 3 * count; ++i) room[i] = places[3 * done + i] ?? NaN;
      use(count, done);
    }
  }
}

function hashText(hash: bigint): string {
  return BigInt.asUintN(64, hash).toString(16).padStart(16, "0");
}

function countOf(places: ArrayLike<number>): number {
  if (places.length % 3 !== 0) throw new TouchError(`${places.length} numbers are no places, which have three each`);
  return places.length / 3;
}
