// What host/page/src/touch promises, with the module that the preset wasm32 built and the tool that the preset release built.
//
// usage     tests/page/run touch      (it sets TOUCH: the folder with the scripts, TOUCH_WASM, ISOTOUCH)
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";

const { TOUCH, TOUCH_WASM, ISOTOUCH } = process.env;
const { At, NUMBERS_OF_A_TICK, Status, Touch, TouchError } = await import(join(TOUCH, "touch.mjs"));
const { FollowingHand, Pace } = await import(join(TOUCH, "hand.mjs"));
const { TouchServer } = await import(join(TOUCH, "serve_touch.mjs"));

const MODULE = new WebAssembly.Module(readFileSync(TOUCH_WASM));
const FIELD = "tests/golden/field_1_1.itf";
const IMAGE = readFileSync(FIELD);
const RECORD = 104;
const HEADER = 256;
const folder = mkdtempSync(join(tmpdir(), "touch-"));
after(() => rmSync(folder, { recursive: true }));

/** What the tool says; it must end with `code`. */
function isotouch(words, code = 0) {
  const done = spawnSync(ISOTOUCH, words, { encoding: "utf8" });
  assert.equal(done.status, code, `isotouch ${words.join(" ")}: ${done.stdout}${done.stderr}`);
  return done.stdout + done.stderr;
}

/** A hand's motion on a field, answered by the tool: the trace's bytes. */
function nativeTrace(field, ...options) {
  const [inputs, answered] = [join(folder, "inputs.trace"), join(folder, "native.trace")];
  isotouch(["trace", "make", "tour", field, "--ticks", "4000", "-o", inputs, ...options]);
  isotouch(["replay", field, inputs, "-o", answered]);
  return readFileSync(answered);
}

/** The HIPs of a trace of positions, mm. */
function placesOf(trace) {
  const count = (trace.length - HEADER) / RECORD;
  return Float64Array.from({ length: 3 * count }, (_, i) => trace.readInt32LE(HEADER + RECORD * Math.floor(i / 3) + 16 + 4 * (i % 3)) / 2 ** 20);
}

async function touching(image = IMAGE) {
  const touch = await Touch.create(MODULE);
  touch.load(image);
  return touch;
}

/** Its message. */
function sentence(call) {
  try {
    call();
  } catch (error) {
    assert.ok(error instanceof TouchError, `${error}`);
    return error.message;
  }
  return assert.fail("it was not refused");
}

/** A place outside the object of FIELD, and one 1 mm inside, on a line through its middle. */
function lineThrough(touch) {
  const { origin, edge, size } = touch.field;
  const middle = origin.map((at, axis) => at + (edge * size[axis]) / 2);
  const line = Array.from({ length: 400 }, (_, i) => [middle[0] + (i - 200) * edge * size[0] * 0.0025, middle[1], middle[2]]);
  const distances = touch.sample(line.flat());
  const inside = distances.findIndex((distance, i) => distance < 0 && distances[i - 1] >= 0);
  assert.ok(inside > 0, "the line meets the object");
  return { outside: line[inside - 20] ?? line[0], inside: line[inside].map((at, axis) => (axis === 0 ? at + 1 : at)) };
}

test("the module imports nothing and has no more than 80 kB", async () => {
  assert.deepEqual(WebAssembly.Module.imports(MODULE), []);
  const { gzipSync } = await import("node:zlib");
  assert.ok(gzipSync(readFileSync(TOUCH_WASM), { level: 9 }).length <= 80_000);
});

const FEATURES = ["--friction", "0.4", "--damping", "0.0005", "--hand-damping", "0.002", "--passivity-damping", "0.012", "--device-damping", "0.003"];
for (const [field, options] of [[FIELD, []], [FIELD, FEATURES], ["tests/golden/field_1_0.itf", []], ["tests/golden/field_1_2.itf", ["--stiffness", "0.5"]]]) {
  test(`a path on ${field} ${options.join(" ")} is felt as by the tool, and its trace is the tool's to the byte`, async () => {
    const native = nativeTrace(field, ...options);
    const touch = await touching(readFileSync(field));
    touch.settings.forEach(({ name }, number) => {
      const raw = native.readInt32LE(40 + 4 * number);
      const bits = { stiffness: 16, damping: 24, force_limit_n: 16, friction: 30, weight_n: 16, ramp_ticks: 0, delay_ticks: 0 }[name] ?? 24;
      touch.set(name, raw / 2 ** bits);
    });
    touch.record(10_000);
    const places = placesOf(native);
    const felt = touch.run(places);
    let contacts = 0;
    for (let tick = 0; tick < places.length / 3; ++tick) {
      for (let axis = 0; axis < 3; ++axis) {
        const at = HEADER + RECORD * tick + 32 + 4 * axis;
        const name = `tick ${tick}, axis ${axis}`;
        assert.equal(felt[tick * NUMBERS_OF_A_TICK + At.hip + axis], native.readInt32LE(at) / 2 ** 20, name);
        assert.equal(felt[tick * NUMBERS_OF_A_TICK + At.proxy + axis], native.readInt32LE(at + 12) / 2 ** 20, name);
        assert.equal(felt[tick * NUMBERS_OF_A_TICK + At.force + axis], native.readInt32LE(at + 24) / 2 ** 16, name);
      }
      contacts += felt[tick * NUMBERS_OF_A_TICK + At.status] & Status.contact;
    }
    assert.ok(contacts > 500, `${contacts} ticks in contact`);
    assert.equal(touch.recorded, places.length / 3);
    assert.ok(Buffer.from(touch.trace()).equals(native));
  });
}

test("a trace replays on the desk to the bit, and one with a changed bit does not", async () => {
  const touch = await touching();
  touch.set("friction", 0.3);
  touch.record(100_000);
  const { outside, inside } = lineThrough(touch);
  const hand = new FollowingHand();
  hand.moveTo(outside);
  touch.run(hand.next(10), 5);
  hand.moveTo(inside);
  const felt = touch.run(hand.next(3000));
  assert.equal(felt.at(-1) & Status.contact, Status.contact);
  const trace = Buffer.from(touch.trace());
  assert.equal(touch.recorded, 3010);
  const file = join(folder, "page.trace");
  writeFileSync(file, trace);
  assert.match(isotouch(["replay", "--check", FIELD, file]), /equal to the recorded outputs, every bit/);
  trace[HEADER + RECORD * 2000 + 56] ^= 1; // a force
  writeFileSync(file, trace);
  assert.match(isotouch(["replay", "--check", FIELD, file], 3), /differs first at tick 2000 in force\.x/);
});

test("a setting that changes in contact is felt at once, and the next trace begins when the hand touches nothing", async () => {
  const touch = await touching();
  const { outside, inside } = lineThrough(touch);
  const hand = new FollowingHand();
  touch.record(100_000);
  hand.moveTo(outside);
  touch.run(hand.next(10));
  hand.moveTo(inside);
  const force = (felt) => Math.hypot(...felt.slice(-NUMBERS_OF_A_TICK).slice(At.force, At.force + 3));
  const before = force(touch.run(hand.next(2000)));
  touch.set("stiffness", touch.field.stiffness / 2);
  assert.deepEqual([touch.recorded, touch.waiting, touch.trace().length], [0, true, 0]);
  const softer = force(touch.run(hand.next(100)));
  assert.ok(softer > before * 0.45 && softer < before * 0.55, `${before} N, then ${softer} N`);
  assert.deepEqual([touch.recorded, touch.waiting], [0, true]);
  hand.moveTo(outside);
  touch.run(hand.next(500));
  assert.equal(touch.waiting, false);
  hand.moveTo(inside);
  touch.run(hand.next(1000));
  const file = join(folder, "changed.trace");
  writeFileSync(file, touch.trace());
  isotouch(["replay", "--check", FIELD, file]);
});

test("a trace ends when it is full, and stays whole", async () => {
  const touch = await touching();
  const { outside } = lineThrough(touch);
  touch.record(2500);
  touch.run(Float64Array.from({ length: 9000 }, (_, i) => outside[i % 3]));
  assert.equal(touch.recorded, 2500);
  writeFileSync(join(folder, "full.trace"), touch.trace());
  isotouch(["replay", "--check", FIELD, join(folder, "full.trace")]);
  touch.record(0);
  touch.run(outside);
  assert.equal(touch.recorded, 0);
});

test("a field that is not whole is refused with a sentence", async () => {
  const touch = await touching();
  for (const size of [0, 1, 4, 255, 256, 300, IMAGE.length - 1]) {
    assert.match(sentence(() => touch.load(IMAGE.subarray(0, size), "cut")), /^cut: .*(ends before|not a file of this kind)/, `${size} bytes`);
    assert.equal(touch.field, null);
    assert.match(sentence(() => touch.run([0, 0, 0])), /there is no field/);
  }
  assert.match(sentence(() => touch.load(Buffer.concat([IMAGE, Buffer.alloc(64)]))), /sizes in its header/);
  assert.match(sentence(() => touch.load(readFileSync("tests/golden/packed_1_0.itf"))), /not a file of this kind/);
  assert.match(sentence(() => touch.load(readFileSync("tests/golden/positions.trace"))), /not a file of this kind/);
});

test("a field with any byte changed is refused, and never traps", async () => {
  const touch = await touching();
  const accepted = [];
  for (let at = 0; at < IMAGE.length; at += at < 512 ? 1 : 23) {
    const image = Buffer.from(IMAGE);
    image[at] ^= 1 << at % 8;
    try {
      touch.load(image);
      accepted.push(at);
    } catch (error) {
      assert.ok(error instanceof TouchError, `byte ${at}: ${error}`);
    }
  }
  assert.deepEqual(accepted, [6, 7]); // the minor version: a newer one is read
});

test("places that are none, and settings outside their range, are refused and change nothing", async () => {
  const touch = await touching();
  for (const place of [[NaN, 0, 0], [0, Infinity, 0], [0, 0, -Infinity]]) {
    assert.match(sentence(() => touch.run(place)), /not a number/);
    assert.match(sentence(() => touch.sample(place)), /not a number/);
  }
  assert.match(sentence(() => touch.run([1, 2])), /2 numbers are no places/);
  assert.equal(touch.run([]).length, 0);
  const far = touch.run([1e300, -1e300, 600]);
  assert.deepEqual([...far.slice(0, 3)], [512, -512, 512]);
  assert.ok(far[At.status] & Status.inputClamped);
  for (const { name, low, high } of touch.settings) {
    const before = touch.setting(name);
    for (const value of [NaN, Infinity, low - 1, high + 1, 1e300]) assert.match(sentence(() => touch.set(name, value)), new RegExp(`^${name}: .*range`));
    assert.equal(touch.setting(name), before);
    touch.set(name, high);
  }
  assert.match(sentence(() => touch.set("stifness", 1)), /no setting is called 'stifness'; there are: stiffness/);
  for (const ns of [NaN, 0, 99_999, 4_000_001]) assert.match(sentence(() => touch.setPeriod(ns)), /period/);
  assert.match(sentence(() => touch.setDevice(new Uint8Array(127))), /127 bytes instead of 128/);
  assert.match(sentence(() => touch.setDevice(new Uint8Array(128))), /outside its range/);
  touch.setDevice("martin-hillier");
  for (const ticks of [NaN, -1, 1e12]) assert.match(sentence(() => touch.record(ticks)), /40,000,000/);
});

test("a module without a field refuses", async () => {
  const touch = await Touch.create(MODULE);
  for (const call of [() => touch.run([0, 0, 0]), () => touch.sample([0, 0, 0]), () => touch.record(10)]) assert.match(sentence(call), /there is no field/);
  assert.equal(touch.trace().length, 0);
});

test("settings are those of the table", async () => {
  const touch = await Touch.create(MODULE);
  assert.equal(touch.settings.length, 11);
  const limit = touch.settings.find(({ name }) => name === "force_limit_n");
  assert.deepEqual([limit.unit, limit.low, limit.high, limit.standard, limit.mayBeUnset], ["N", 0, 50, 8, false]);
  assert.match(limit.meaning, /largest force/);
  for (const { name, standard } of touch.settings) assert.equal(touch.setting(name), standard, name);
});

test("distances are those of the tool", async () => {
  const touch = await touching();
  const { origin, edge, size } = touch.field;
  assert.match(isotouch(["info", FIELD, "--json"]), new RegExp(touch.field.hash));
  const places = Float64Array.from({ length: 3 * 2500 }, (_, i) => origin[i % 3] + (edge * size[i % 3] * ((i * 7919) % 2503)) / 2503);
  const points = join(folder, "points.xyz");
  writeFileSync(points, Array.from({ length: 2500 }, (_, i) => places.slice(3 * i, 3 * i + 3).join(",")).join("\n"));
  const [head, ...rows] = isotouch(["sample", FIELD, points]).trim().split("\n");
  const column = head.split(",").indexOf("distance_mm");
  const distances = touch.sample(places);
  assert.ok(distances.filter((d) => d < 0).length > 100 && distances.filter((d) => d > 0).length > 100);
  rows.forEach((row, i) => assert.ok(Math.abs(Number(row.split(",")[column]) - distances[i]) < 1e-4, `${row}: ${distances[i]}`));
  assert.equal(rows.length, 2500);
});

test("recordings of positions and of packets are computed again as by the tool", async () => {
  const touch = await touching();
  for (const name of ["positions_settings", "packets", "packets_unwatched_heat"]) {
    const trace = readFileSync(`tests/golden/${name}.trace`);
    const told = JSON.parse(isotouch(["replay", "--check", "--json", FIELD, `tests/golden/${name}.trace`]));
    assert.deepEqual(touch.replay(trace), { ticks: told.ticks, hash: told.hash, firstDifference: null });
    trace[HEADER + RECORD * 70 + 44] ^= 1; // a proxy
    assert.equal(touch.replay(trace).firstDifference, 70);
    trace[HEADER + RECORD * 5] = 9; // no kind
    assert.match(sentence(() => touch.replay(trace, "file")), /^file: a record holds an undefined value/);
    for (const size of [0, 10, 256, trace.length - 1]) assert.match(sentence(() => touch.replay(trace.subarray(0, size))), /ends before|contradict|not a file/);
  }
  assert.match(sentence(() => touch.replay(readFileSync("tests/golden/packets_faults.trace"))), /another field/);
  assert.match(sentence(() => touch.replay(readFileSync("tests/golden/field_1_1.itf"))), /not a file of this kind/);
});

test("a recording of a field that changed is computed again with its patches", async () => {
  const touch = await touching(readFileSync("tests/golden/field_1_3.itf"));
  const [trace, patches] = ["trace", "patches"].map((end) => readFileSync(`tests/golden/positions_patches.${end}`));
  const told = JSON.parse(isotouch(["replay", "--check", "--json", "tests/golden/field_1_3.itf", "tests/golden/positions_patches.trace"]));
  for (let time = 0; time < 2; ++time) {
    assert.deepEqual(touch.replay(trace, "file", patches), { ticks: told.ticks, hash: told.hash, firstDifference: null });
  }
  assert.match(sentence(() => touch.replay(trace, "file")), /^file: .*patch/);
  for (const size of [1, 64, patches.length - 1]) assert.match(sentence(() => touch.replay(trace, "file", patches.subarray(0, size))), /^file: /);
  patches[patches.length - 20] ^= 1;
  assert.match(sentence(() => touch.replay(trace, "file", patches)), /^file: /);
});

test("a pace catches up with what is late, and leaves out what is too late", () => {
  const pace = new Pace(1000);
  assert.deepEqual([pace.due(1000), pace.due(1000.5), pace.due(1001), pace.due(1005.2), pace.skipped], [1, 0, 1, 4, 0]);
  assert.deepEqual([pace.due(2000), pace.skipped], [100, 895]);
  assert.equal(pace.due(2001), 1);
});

test("a hand follows a pointer without a leap", () => {
  const hand = new FollowingHand();
  assert.equal(hand.isThere, false);
  hand.moveTo([1, 2, 3]);
  assert.deepEqual([...hand.next(2)], [1, 2, 3, 1, 2, 3]);
  hand.moveTo([101, 2, 3]);
  const places = hand.next(400);
  for (let i = 1; i < 400; ++i) assert.ok(places[3 * i] - places[3 * i - 3] <= 1 + 1e-9);
  assert.ok(Math.abs(places.at(-3) - 101) < 1e-6);
  hand.lift();
  hand.moveTo([5, 5, 5]);
  assert.deepEqual([...hand.next(1)], [5, 5, 5]);
});

/** A worker's surroundings with a clock of their own. */
class Surroundings {
  time = 0;
  calls = [];
  posted = [];
  now = () => this.time;
  soon = (call) => this.calls.push(call);
  post = (message) => this.posted.push(structuredClone(message));
  pass(ms, step = 4) {
    for (const end = this.time + ms; this.time < end; ) {
      this.time += step;
      this.calls.splice(0).forEach((call) => call());
    }
  }
  take(kind) {
    return this.posted.filter((message) => message.kind === kind);
  }
}

test("the worker runs one tick a millisecond, reports them all, and its trace replays", async () => {
  const around = new Surroundings();
  const server = new TouchServer(around);
  await server.take({ kind: "hand", place: [0, 0, 0] });
  assert.match(around.posted[0].sentence, /first message must be 'begin'/);
  await server.take({ kind: "begin", module: MODULE });
  await server.take({ kind: "load", image: IMAGE, name: "field" });
  const { outside, inside } = lineThrough(await touching());
  await server.take({ kind: "record", maxTicks: 10_000 });
  await server.take({ kind: "hand", place: outside });
  around.pass(100);
  await server.take({ kind: "hand", place: inside });
  around.pass(1000);
  await server.take({ kind: "hand", place: [NaN, 0, 0] });
  around.pass(100);
  assert.match(around.take("refused").at(-1).sentence, /not a number/);
  await server.take({ kind: "lift" });
  around.pass(8);
  const felt = around.take("felt");
  const ticks = felt.reduce((sum, { ticks: part }) => sum + part.length / NUMBERS_OF_A_TICK, 0);
  assert.ok(ticks >= 1098 && ticks <= 1106, `${ticks} ticks`);
  assert.ok(felt.some(({ ticks: part }) => part.at(-1) & Status.contact));
  await server.take({ kind: "save" });
  const { bytes, ticks: recorded } = around.take("trace")[0];
  assert.equal(recorded, ticks);
  writeFileSync(join(folder, "worker.trace"), bytes);
  isotouch(["replay", "--check", FIELD, join(folder, "worker.trace")]);
  await server.take({ kind: "set", name: "friction", value: 7 });
  assert.match(around.take("refused").at(-1).sentence, /^friction: /);
  await server.take({ kind: "load", image: IMAGE.subarray(0, 99), name: "cut" });
  assert.match(around.take("refused").at(-1).sentence, /^cut: /);
  await server.take({ kind: "sample", places: new Float64Array(3), ticket: 7 });
  assert.match(around.take("refused").at(-1).sentence, /no field/);
});

test("addresses and sizes above 2 GiB are none below zero", () => {
  const HIGH = 2 ** 31 + 64;
  const signed = HIGH | 0;
  const memory = new WebAssembly.Memory({ initial: 2 ** 15 + 1 });
  const room = new Uint8Array(memory.buffer, HIGH);
  room.set([7, 8, 9, 0]);
  const address = () => signed;
  const one = { memory, batch: () => 1, setting_count: () => 0, set_device: () => 0, device_bytes: address, places: address, numbers: address };
  const touch = new Touch({ ...one, image_room: address, load: address, replay_room: address, replay: address, trace_address: address, trace_bytes: () => 3,
                            sample: () => 0 });
  assert.deepEqual([...touch.trace()], [7, 8, 9]);
  assert.equal(sentence(() => touch.load(new TextEncoder().encode("no field\0"), "a")), "a: no field");
  assert.equal(sentence(() => touch.replay(new TextEncoder().encode("no trace\0"), "b")), "b: no trace");
  touch.setDevice(new Uint8Array(128).fill(3));
  assert.deepEqual([...room.subarray(0, 129)], [...new Array(128).fill(3), 0]);
  assert.deepEqual([...touch.sample([1, 2, 3])], [1]);
  const bytes = [];
  const large = new Touch({ ...one, trace_address: () => 64, trace_bytes: address });
  const { slice } = Uint8Array.prototype;
  Uint8Array.prototype.slice = (begin, end) => bytes.push(begin, end);
  large.trace();
  Uint8Array.prototype.slice = slice;
  assert.deepEqual(bytes, [64, 64 + HIGH]);
});
