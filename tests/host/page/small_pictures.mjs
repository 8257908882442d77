#!/usr/bin/env node
// The pictures of the page in docs/pictures: small_pictures.mjs BIN [FOLDER]
//
// Runs the tests of the page, or takes the FOLDER that they filled, and writes each state as docs/pictures/page_STATE.png: 640 x 360 with 256 colours.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { deflateSync } from 'node:zlib';

const root = resolve(new URL('.', import.meta.url).pathname, '../../..');
const { chromium } = createRequire(join(root, 'host/page/package.json'))('playwright-core');
const kStates = ['object', 'slice', 'recording', 'two_recordings', 'live', 'controller_gone', 'touch', 'built', 'refused', 'doubtful', 'exported', 'dark', 'without_webgl'];
const [kWide, kHigh] = [640, 360];

const [bin, filled] = process.argv.slice(2);
if (!bin) {
  console.error('usage: small_pictures.mjs BIN [FOLDER]');
  process.exit(2);
}
const folder = filled ?? mkdtempSync(join(tmpdir(), 'pictures-'));
if (!filled && spawnSync(join(root, 'tests/host/page/view_test.mjs'), [bin, folder], { stdio: 'inherit' }).status !== 0) process.exit(1);

/** The most frequent colours and those that would be missed most, and for each pixel the nearest of them. */
function indexed(pixels) {
  const count = new Map();
  const key = (at) => ((pixels[at] >> 2) << 12) | ((pixels[at + 1] >> 2) << 6) | (pixels[at + 2] >> 2);
  for (let at = 0; at < pixels.length; at += 4) count.set(key(at), (count.get(key(at)) ?? 0) + 1);
  const channels = (colour) => [colour >> 12, (colour >> 6) & 63, colour & 63];
  const colours = [...count].sort((a, b) => b[1] - a[1]).map(([colour, often]) => ({ colour, often, own: channels(colour), far: Infinity, nearest: 0 }));
  const palette = [];
  const take = ({ own }) => {
    for (const one of colours) {
      const far = one.own.reduce((sum, value, channel) => sum + (value - own[channel]) ** 2, 0);
      if (far < one.far) [one.far, one.nearest] = [far, palette.length];
    }
    palette.push(own);
  };
  colours.slice(0, 160).forEach(take);
  while (palette.length < 256) take(colours.reduce((a, b) => (b.far * Math.sqrt(b.often) > a.far * Math.sqrt(a.often) ? b : a)));
  const nearest = new Map(colours.map((one) => [one.colour, one.nearest]));
  const full = palette.map((one) => one.map((value) => Math.round((255 * value) / 63)));
  return { palette: full, indices: Array.from({ length: pixels.length / 4 }, (_, pixel) => nearest.get(key(4 * pixel))) };
}

function crc(bytes) {
  let rest = ~0;
  for (const byte of bytes) {
    rest ^= byte;
    for (let bit = 0; bit < 8; ++bit) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  }
  return ~rest >>> 0;
}

function png({ palette, indices }) {
  const chunk = (name, content) => {
    const body = Buffer.concat([Buffer.from(name, 'latin1'), Buffer.from(content)]);
    const [size, check] = [Buffer.alloc(4), Buffer.alloc(4)];
    size.writeUInt32BE(content.length);
    check.writeUInt32BE(crc(body));
    return Buffer.concat([size, body, check]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(kWide, 0);
  head.writeUInt32BE(kHigh, 4);
  head.set([8, 3, 0, 0, 0], 8); // eight bits, of a palette
  const rows = Array.from({ length: kHigh }, (_, row) => [0, ...indices.slice(row * kWide, (row + 1) * kWide)]).flat();
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([signature, chunk('IHDR', head), chunk('PLTE', palette.flat()), chunk('IDAT', deflateSync(Buffer.from(rows), { level: 9 })), chunk('IEND', [])]);
}

const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) => existsSync(path));
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
const page = await browser.newPage();
let bytes = 0;
for (const state of kStates) {
  const content = readFileSync(join(folder, `${state}.png`)).toString('base64');
  const pixels = await page.evaluate(
    async ([text, width, height]) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob(), { resizeWidth: width, resizeHeight: height, resizeQuality: 'high' });
      const canvas = new OffscreenCanvas(width, height);
      canvas.getContext('2d').drawImage(image, 0, 0);
      const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
      let sent = ''; // a text is sent faster than a million numbers
      for (let at = 0; at < data.length; at += 4096) sent += String.fromCharCode(...data.subarray(at, at + 4096));
      return btoa(sent);
    },
    [content, kWide, kHigh],
  );
  const small = png(indexed(Buffer.from(pixels, 'base64')));
  writeFileSync(join(root, 'docs/pictures', `page_${state}.png`), small);
  bytes += small.length;
}
await browser.close();
if (!filled) rmSync(folder, { recursive: true, force: true });
console.log(`${kStates.length} pictures, ${Math.round(bytes / 1000)} kB`);
