#!/usr/bin/env node
// The page in a browser: view_test.mjs BIN OUT [WORD...]
//
// BIN is the folder of the programs, OUT a folder for pictures of each state. With WORDs, only the tests whose name holds one of them run. The last line
// counts what passed, failed and was skipped. Needs Chromium, and host/page/node_modules as `npm ci` makes it.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const here = new URL('.', import.meta.url).pathname;
const root = resolve(here, '../../..');
const require = createRequire(join(root, 'host/page/package.json'));
const { chromium } = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const [bin, out, ...words] = process.argv.slice(2).map((word, at) => (at < 2 ? resolve(word) : word));
if (!out) {
  console.error('usage: view_test.mjs BIN OUT [WORD...]');
  process.exit(2);
}
const program = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find((path) => existsSync(path));
if (!program) {
  console.log('no Chromium is installed, so the page was not opened\n0 passed, 0 failed, 1 skipped');
  process.exit(0);
}
mkdirSync(out, { recursive: true });
const folder = mkdtempSync(join(tmpdir(), 'page-'));
const golden = join(root, 'tests/golden');
const kArguments = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

class Wrong extends Error {}
const check = (holds, sentence) => {
  if (!holds) throw new Wrong(sentence);
};
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
async function within(seconds, holds, sentence) {
  for (const end = Date.now() + 1000 * seconds; Date.now() < end; await sleep(50)) {
    if (await holds()) return;
  }
  throw new Wrong(typeof sentence === 'function' ? await sentence() : sentence);
}

const processes = new Set();
function start(name, ...options) {
  const child = spawn(join(bin, name), options, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
  child.said = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => (child.said += data));
  child.done = new Promise((done) => child.on('exit', done));
  processes.add(child);
  return child;
}
async function run(name, ...options) {
  const child = start(name, ...options);
  check((await child.done) === 0, `${name} ${options.join(' ')}: ${child.said}`);
  return child.said;
}
async function stop(child) {
  child.kill('SIGTERM');
  processes.delete(child);
  return child.done;
}

/** A page on a server of its own. */
async function open(options = {}, ...files) {
  const server = start('isotouch', 'view', '--no-browser', ...files);
  await within(30, () => server.said.includes('\n'), () => `no address: ${server.said}`);
  const browser = await chromium.launch({
    executablePath: program,
    args: [...kArguments, ...(options.arguments ?? [])],
  });
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, acceptDownloads: true, ...(options.context ?? {}) });
  const page = await context.newPage();
  const errors = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall|swiftshader|GL Driver Message/i.test(message.text())) errors.push(message.text());
  });
  page.on('pageerror', (error) => errors.push(String(error)));
  page.setDefaultTimeout(120000);
  page.setDefaultNavigationTimeout(120000);
  await page.goto(server.said.trim());
  return { server, browser, page, errors };
}
async function close({ server, browser, errors }, wanted = []) {
  await browser.close();
  const code = await stop(server);
  const unexpected = errors.filter((error) => !wanted.some((words) => error.includes(words)));
  check(unexpected.length === 0, `the console says: ${unexpected.join(' | ')}`);
  check(code === 0, `the server ends with ${code}`);
}
const shown = (page) => page.waitForFunction(() => document.body.dataset.scene && document.body.dataset.drawn, null, { timeout: 120000 });
/** The object is drawn finely, after its last movement. */
const still = (page) => page.waitForFunction(() => document.body.dataset.rests, null, { timeout: 120000 });
const picture = async (page, name) => {
  if (await page.locator('#canvas').isVisible()) await still(page);
  await page.screenshot({ path: join(out, `${name}.png`) });
};
const drawn = async (page) => {
  await still(page);
  return (await page.locator('#canvas').screenshot()).toString('base64');
};

async function accessible(page, state) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  const found = violations.map((one) => `${one.id}: ${one.help} (${one.nodes.map((node) => node.target.join(' ')).slice(0, 3).join(', ')})`);
  check(found.length === 0, `axe finds in the state '${state}': ${found.join('; ')}`);
}

/** Presses the pointer into the object until there is a force. */
async function feel(page) {
  await page.locator('#touch').waitFor();
  const box = await page.locator('#canvas').boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...middle);
  await within(60, async () => Number(await number(page, 'Ticks in the trace')) > 0, 'the core computes no tick');
  const force = async () => Number((await number(page, 'Force')).split(' ')[0]);
  for (let turn = 0; turn < 80 && (await force()) < 0.5; ++turn) {
    await page.mouse.wheel(0, 100);
    await sleep(100);
  }
  await within(10, async () => (await force()) > 0.3, async () => `the wheel presses with ${await number(page, 'Force')}`);
  await page.mouse.move(middle[0] + 20, middle[1] + 10, { steps: 8 });
}

/** What a row of the table of numbers says. */
const number = async (page, label) => (await page.locator(`#numbers tr:has(th:text-is("${label}")) td`).first().textContent()) ?? '';

/** The trace of the page is computed again on the desk, to the bit, and there is contact in it. */
async function checkSaved(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save as trace' }).click()]);
  const file = join(folder, 'saved.trace');
  await download.saveAs(file);
  const said = await run('isotouch', 'replay', 'owl.itf', file, '--check');
  check(/every bit/.test(said), `the saved trace replays otherwise: ${said}`);
  const rows = (await run('isotouch', 'trace', 'show', file)).split('\n');
  check(rows.length > 100, `the saved trace has ${rows.length} rows`);
}

// What the tests look at: an owl, and two runs of a hand on it that differ in one setting.
async function make() {
  await run('isotouch', 'shape', 'owl', '-o', 'owl.ply');
  await run('isotouch', 'build', 'owl.ply', '-o', 'owl.itf');
  await run('isotouch', 'trace', 'make', 'tour', 'owl.itf', '--ticks', '6000', '-o', 'hand.trace');
  await run('isotouch', 'replay', 'owl.itf', 'hand.trace', '-o', 'felt.trace');
}

/** A module of the page that needs no browser. */
async function module(name) {
  const { transformSync } = createRequire(require.resolve('vite/package.json'))('esbuild');
  const { code } = transformSync(readFileSync(join(root, 'host/page/src', name), 'utf8'), { loader: 'ts', format: 'esm' });
  return import(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
}

const tests = {
  async 'bursts are played out evenly, also those of a controller that is late'() {
    const { Playout } = await module('playout.ts');
    check(new Playout(0.08).at(0, 1e-3) === null, 'a tick is shown before one has come');
    for (const pace of [1, 0.85, 1.1]) {
      // of a controller whose second has so many of ours
      const playout = new Playout(0.08);
      let shown = [];
      let come = 0;
      for (let ms = 0; ms < 4000; ++ms) {
        if (ms % 50 === (ms % 100 === 0 ? 12 : 30)) {
          // bursts that come up to 18 ms late
          for (; come < pace * ms; ++come) playout.add({ tick: come });
        }
        if (ms % 16 === 0 && ms > 200) shown.push(playout.at(ms / 1000, 1e-3).tick);
      }
      const steps = shown.slice(1).map((tick, at) => (tick - shown[at]) / pace);
      check(steps.every((step) => step >= 10 && step <= 22), `at the pace ${pace} there are ${[...new Set(steps)].join(', ')} ticks from picture to picture`);
      check(4000 * pace - shown[shown.length - 1] < 150, `the last tick that is shown is ${shown[shown.length - 1]} of ${4000 * pace}`);
    }
  },

  async 'object, orbit and slice'() {
    const opened = await open({}, 'owl.itf');
    const { page } = opened;
    await shown(page);
    check((await page.locator('#object').textContent()).startsWith('owl, '), 'the object has no name');
    await picture(page, 'object');
    await accessible(page, 'object');
    const first = await drawn(page);
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(600, 320, { steps: 5 });
    await page.mouse.up();
    const turned = await drawn(page);
    check(turned !== first, 'the mouse does not turn the object');
    await page.locator('#canvas').focus();
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '-', 'h', 'j', 'k', 'l']) {
      const before = await drawn(page);
      await page.keyboard.press(key);
      await sleep(200);
      check((await drawn(page)) !== before, `the key ${key} changes nothing`);
    }
    await page.keyboard.press('Home');
    await page.locator('#help-button').focus();
    await page.keyboard.press('s');
    check(!(await page.locator('#slice').isVisible()), 'a key of one character works where the focus is on a button');
    await page.locator('#canvas').focus();
    await page.keyboard.press('s');
    await page.waitForSelector('#slice:not([hidden])');
    await page.mouse.move(460, 330);
    await sleep(500);
    const at = await page.locator('#slice-text').textContent();
    await page.mouse.move(470, 335, { steps: 4 });
    await within(5, async () => (await page.locator('#slice-text').textContent()) !== at, 'the slice does not follow the mouse');
    await sleep(700);
    await picture(page, 'slice');
    await accessible(page, 'slice');
    for (const axis of ['x', 'y']) {
      const before = await drawn(page);
      await page.keyboard.press(axis);
      await within(5, async () => (await drawn(page)) !== before, `the slice across ${axis} is that of another axis`);
      check((await page.locator('#slice-text').textContent()).startsWith(axis), `the key ${axis} chooses another axis`);
    }
    await close(opened);
  },

  async 'drop a cloud'() {
    const opened = await open();
    const { page } = opened;
    await page.waitForSelector('text=Open a scan');
    const content = readFileSync(join(folder, 'owl.ply')).toString('base64');
    const drop = (name, bytes) =>
      page.evaluate(
        ([file, text]) => {
          const data = new DataTransfer();
          data.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], file));
          for (const type of ['dragover', 'drop']) document.body.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
        },
        [name, bytes],
      );
    await drop('owl.ply', content);
    await page.waitForSelector('#build:has-text("owl.ply was built")', { timeout: 120000 });
    await shown(page);
    const said = await page.locator('#build').textContent();
    check(/points/.test(said) && /Verdict: plausible/.test(said), `the build says: ${said}`);
    await page.locator('#canvas').focus();
    await page.keyboard.press('p');
    await sleep(500);
    await picture(page, 'built');
    await accessible(page, 'built');
    await drop('broken.ply', Buffer.from('ply\nformat ascii 1.0\nend_header\n').toString('base64'));
    await page.waitForSelector('#build .bad', { timeout: 60000 });
    check(/broken\.ply/.test(await page.locator('#build .bad').textContent()), 'a broken file is not named');
    await picture(page, 'refused');
    await close(opened);
  },

  async 'a recording'() {
    const opened = await open({}, 'owl.itf', 'felt.trace');
    const { page } = opened;
    await shown(page);
    await page.waitForSelector('#player:not([hidden])');
    await page.getByRole('button', { name: 'Next contact' }).click();
    const tick = async () => Number(await page.locator('#scrub').inputValue());
    const contact = await tick();
    check(contact > 0, 'there is no next contact');
    await within(10, async () => (await page.locator('#numbers').textContent()).includes('yes'), 'at the contact there is none');
    await page.locator('#scrub').evaluate((range) => {
      range.value = '2500';
      range.dispatchEvent(new Event('input'));
    });
    check((await tick()) === 2500, 'scrubbing shows another tick');
    await page.locator('#scrub').focus();
    await page.keyboard.press('.');
    check((await tick()) === 2501, 'the next tick is another one');
    const numbers = () => page.locator('#numbers').textContent(); // the rows of a tick may still be on their way
    const haveUnits = async () => [/\d N/, /\d mm/, /\d mJ/].every(((text) => (unit) => unit.test(text))(await numbers()));
    await within(10, haveUnits, async () => `numbers without units: ${await numbers()}`);
    await picture(page, 'recording');
    await accessible(page, 'recording');
    await page.locator('#canvas').focus();
    await page.keyboard.press('Space');
    await sleep(1500);
    await page.keyboard.press('Space');
    const played = await tick();
    check(played > 3000, `a second and a half of playing shows tick ${played}`);
    await sleep(300);
    check((await tick()) === played, 'a pause goes on');
    await close(opened);
  },

  async 'two recordings'() {
    const opened = await open({}, join(golden, 'field_1_1.itf'), join(golden, 'packets.trace'), join(golden, 'packets_unwatched_heat.trace'));
    const { page } = opened;
    await shown(page);
    await page.waitForSelector('#difference:not([hidden])');
    check(/differ first at tick \d+/.test(await page.locator('#difference').textContent()), 'the first difference is not named');
    await page.getByRole('button', { name: 'First difference' }).click();
    check((await page.locator('#marks .difference').count()) === 1, 'the first difference is not marked');
    check((await page.locator('#numbers thead th').count()) === 2, 'there are no two columns');
    await page.getByRole('button', { name: 'Next contact' }).click();
    const state = () => page.locator('#state').textContent();
    const ofBoth = async () => /^packets\.trace: active.*\npackets_unwatched_heat\.trace: active/.test(await state());
    await within(20, ofBoth, async () => `in contact the states are ${await state()}`);
    await picture(page, 'two_recordings');
    await accessible(page, 'two recordings');
    await close(opened);
  },

  async live() {
    const settings = '[loop]\npriority = 0\nexchange_priority = 0\nlock_memory = false\n[limits]\nhold_ms = 100\nfault_age_ms = 1000\n';
    writeFileSync(join(folder, 'config.toml'), settings);
    const falcon = start('falcon-sim', '--socket', join(folder, 'falcon'), '--hand', 'tour');
    await within(10, () => existsSync(join(folder, 'falcon')), 'the simulated Falcon does not listen');
    const control = join(folder, 'control');
    const controller = () => start('isotouchd', '--config', 'config.toml', '--device', `sim:${folder}/falcon`, '--control', control, '--field', 'owl.itf');
    let daemon = controller();
    const opened = await open({}, 'owl.itf', '--to', `unix:${control}`);
    const { page } = opened;
    await shown(page);
    const active = async () => {
      const state = await page.locator('#state').textContent();
      if (/^fault/.test(state)) await start('isotouch', 'resume', '--to', `unix:${control}`).done; // a busy machine was late
      return /^active/.test(state);
    };
    await within(60, active, async () => `the state is ${await page.locator('#state').textContent()}`);
    await sleep(3000);
    const rates = [];
    for (let second = 0; second < 6; ++second) {
      await sleep(1000);
      rates.push(Number(await page.evaluate(() => document.body.dataset.pictures)));
    }
    await picture(page, 'live');
    await accessible(page, 'live');
    console.log(`  pictures a second: ${rates.join(', ')}`);
    rates.sort((a, b) => a - b);
    check(rates[3] > 0, `the median of pictures a second is ${rates[3]}`); // how many a quiet machine shows is printed above
    await stop(daemon);
    await within(20, async () => /tries again/.test(await page.locator('#link').textContent()), 'a controller that is gone is not missed');
    await picture(page, 'controller_gone');
    daemon = controller();
    await within(20, async () => /answers/.test(await page.locator('#link').textContent()), 'a controller that comes again is not found');
    await stop(daemon);
    await stop(falcon);
    await close(opened);
  },

  async 'touch with the mouse'() {
    const opened = await open({}, 'owl.itf');
    const { page } = opened;
    await shown(page);
    await page.getByRole('button', { name: 'Touch', exact: true }).click();
    await feel(page);
    await picture(page, 'touch');
    await accessible(page, 'touch');
    const busy = /(\d+\.\d) %/.exec(await page.locator('#numbers').textContent());
    console.log(`  the core computes ${busy?.[1]} % of the time`);
    await page.locator('#canvas').focus();
    const hand = page.locator('#numbers tr', { hasText: 'Hand x' });
    const before = await hand.textContent();
    for (const key of ['ArrowLeft', 'ArrowUp', 'PageDown']) await page.keyboard.press(key);
    await within(10, async () => (await hand.textContent()) !== before, 'the keys do not move the hand');
    await checkSaved(page);
    await close(opened);
  },

  async 'a page in a file'() {
    const said = await run('isotouch', 'view', 'owl.itf', '--export', 'owl.html');
    check(/owl\.html/.test(said), `the export says: ${said}`);
    const browser = await chromium.launch({ executablePath: program, args: kArguments });
    const page = await (await browser.newContext({ viewport: { width: 1280, height: 720 }, acceptDownloads: true, offline: true })).newPage();
    page.setDefaultTimeout(120000);
    const errors = [];
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
    page.on('pageerror', (error) => errors.push(String(error)));
    await page.goto(`file://${folder}/owl.html`, { timeout: 120000 });
    await shown(page);
    await feel(page);
    await page.keyboard.press('s');
    await sleep(1500);
    await picture(page, 'exported');
    await accessible(page, 'exported');
    await checkSaved(page);
    await browser.close();
    check(errors.length === 0, `the console of the file says: ${errors.join(' | ')}`);
  },

  async 'the server goes and comes'() {
    const opened = await open({}, 'owl.itf');
    const { page } = opened;
    await shown(page);
    await stop(opened.server);
    await page.waitForSelector('#notice:has-text("has ended")', { timeout: 10000 });
    await picture(page, 'server_gone');
    await opened.browser.close();
  },

  async 'dark, wide, and without motion'() {
    const opened = await open({ context: { viewport: { width: 1920, height: 1080 }, colorScheme: 'dark', reducedMotion: 'reduce' } }, 'owl.itf', 'felt.trace');
    const { page } = opened;
    await shown(page);
    await page.getByRole('button', { name: 'Next contact' }).click();
    await page.getByRole('button', { name: 'Keys' }).click();
    await sleep(800);
    await picture(page, 'dark');
    await accessible(page, 'dark');
    await close(opened);
  },

  async 'by keyboard alone'() {
    const opened = await open({}, 'owl.itf', 'felt.trace');
    const { page } = opened;
    await shown(page);
    const reached = new Set();
    for (let i = 0; i < 40; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement?.id || document.activeElement?.textContent || ''));
    }
    for (const name of ['canvas', 'play', 'scrub', 'speed', 'help-button', 'Surface', 'Points', 'Slice', 'Next contact'])
      check(reached.has(name), `Tab does not reach '${name}': ${[...reached].join(', ')}`);
    await close(opened);
  },

  async 'without WebGL'() {
    const opened = await open({ arguments: ['--disable-3d-apis'] }, 'owl.itf', 'felt.trace');
    const { page } = opened;
    await page.waitForSelector('.no-webgl');
    await page.getByRole('button', { name: 'Next contact' }).click();
    await within(10, async () => (await page.locator('#numbers').textContent()).includes('yes'), 'without WebGL there are no numbers');
    check((await page.locator('#plots canvas').count()) >= 3, 'without WebGL there are no curves');
    await picture(page, 'without_webgl');
    await accessible(page, 'without WebGL');
    await close(opened, ['WebGL', 'THREE']);
  },
};

let passed = 0;
let failed = 0;
try {
  if (words.length === 0 || words.some((word) => !'bursts'.includes(word))) await make();
  for (const [name, test] of Object.entries(tests)) {
    if (words.length > 0 && !words.some((word) => name.includes(word))) continue;
    const since = Date.now();
    try {
      await test();
      passed += 1;
      console.log(`passed  ${name} (${((Date.now() - since) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED  ${name}: ${error instanceof Wrong ? error.message : error.stack}`);
    }
    for (const child of processes) await stop(child);
  }
} catch (error) {
  failed += 1;
  console.log(`FAILED  ${error.message}`);
} finally {
  for (const child of processes) child.kill('SIGKILL');
  rmSync(folder, { recursive: true, force: true });
}
console.log(`${passed} passed, ${failed} failed, 0 skipped`);
process.exit(failed === 0 ? 0 : 1);
