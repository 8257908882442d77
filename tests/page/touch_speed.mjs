// How many ticks a second the module computes in this Node: stated, not judged, because the machine may be busy.
//
// usage     node tests/page/touch_speed.mjs FIELD TRACE      FIELD an image, TRACE of positions on it; after tests/page/run touch
import { readFileSync } from "node:fs";
import { At, NUMBERS_OF_A_TICK, Status, Touch } from "../../build/page/touch/touch.mjs";

const [, , field, file] = process.argv;
const touch = await Touch.create(new WebAssembly.Module(readFileSync("build/wasm32/bin/touch.wasm")));
touch.load(readFileSync(field), field);
const trace = readFileSync(file);
const places = Float64Array.from({ length: (3 * (trace.length - 256)) / 104 }, (_, i) => trace.readInt32LE(256 + 104 * Math.floor(i / 3) + 16 + 4 * (i % 3)) / 2 ** 20);
const ticks = places.length / 3;
for (const [name, begin] of [["in batches", () => touch.record(0)], ["in batches, recorded", () => touch.record(ticks)]]) {
  begin();
  const since = performance.now();
  const felt = touch.run(places);
  const seconds = (performance.now() - since) / 1000;
  let contacts = 0;
  for (let i = At.status; i < felt.length; i += NUMBERS_OF_A_TICK) contacts += felt[i] & Status.contact;
  console.log(`${name}: ${ticks} ticks (${contacts} in contact) in ${seconds.toFixed(3)} s, ${Math.round(ticks / seconds)} ticks/s`);
}
touch.record(ticks);
const since = performance.now();
for (let i = 0; i < ticks; ++i) touch.run(places.subarray(3 * i, 3 * i + 3));
const seconds = (performance.now() - since) / 1000;
console.log(`one at a time, recorded: ${Math.round(ticks / seconds)} ticks/s`);
