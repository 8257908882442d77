// The page: what comes from the server, what is seen of it, and what a person may do.
import './style.css';
import { BuildPanel } from './build_panel';
import { showFacts, showLegend } from './captions';
import { Controller } from './controller';
import { Choice, element, make, say, toggle } from './dom';
import { isExported } from './exported';
import { bindKeys } from './keys';
import { localSlice } from './local_slice';
import type { Colours, Hello, Message, SceneSummary, Words } from './messages';
import { Numbers } from './numbers';
import { Player } from './player';
import { Plots, type Data } from './plots';
import { inPieces, Recording } from './recording';
import { isKnown, RowReader, type Tick } from './rows';
import { SceneView } from './scene_view';
import { Refused, Server } from './server';
import { SliceControl } from './slice_control';
import { TouchPanel } from './touch_panel';

const kMinShare = 5e-4; // of the surface: less is shown as 0.0 %
const kGone = 410; // of the server: there is another object by now
const kPieces = 1500; // of the curves of a recording
const kWordsMs = 200; // between two sentences while a recording plays
const kPlotsMs = 125; // between two pictures of the curves and numbers: more often nobody reads them

class Page {
  private readonly server = new Server();
  private readonly canvas = element<HTMLCanvasElement>('canvas');
  private readonly plots = new Plots(element('plots'));
  private readonly controller = new Controller(this.plots, () => this.heard());
  private readonly player = new Player(() => this.changed());
  private readonly numbers = new Numbers(() => this.extraNumbers());
  private readonly sources = new Choice(element('sources'), (name) => this.use(name));
  private reader: RowReader | null = null;
  private colours: Colours | null = null;
  private view: SceneView | null = null;
  private slice: SliceControl | null = null;
  private recordings: Recording[] = [];
  private source = '';
  private build: BuildPanel | null = null;
  private readonly touch = new TouchPanel(this.server, () => this.touchMoved(), (sentence) => this.notice(sentence));
  private shownLive: Tick | null = null;
  private summary: SceneSummary | null = null;
  private touched: SceneSummary | null = null; // by the hand of this page, or soon
  private plottedAt = 0;
  private plotsLater: ReturnType<typeof setTimeout> | undefined;
  private wanted: SceneSummary | null = null; // the newest object that came and is not shown yet
  private opens = false;
  private askedWords = -1;
  private askedWordsAt = 0;
  private pictures = { shown: 0, since: performance.now(), drawn: 0, fresh: false };

  constructor() {
    this.plots.onPick = (time): void => {
      if (this.source === 'recording') {
        this.player.stop();
        this.player.show(time / this.player.period);
      }
    };
    this.keys();
    this.server.listen({
      message: (message) => this.message(message),
      ticks: (first, every, rows) => {
        if (this.controller.take(first, every, rows, this.reader) && this.source === 'live') this.changed();
      },
      connection: (sentence) => {
        if (sentence !== '') this.controller.forget();
        this.notice(sentence);
      },
    });
  }

  private message(message: Message): void {
    switch (message.topic) {
      case 'hello':
        void this.hello(message);
        break;
      case 'scene':
        void this.openScene(message.scene);
        break;
      case 'build':
        this.build?.show(message);
        break;
      default:
        this.controller.hear(message);
    }
  }

  /** There is something new of the controller. */
  private heard(): void {
    if (this.source === 'live') this.words(this.controller.words);
    this.warnOfField();
    this.changed();
  }

  /** Comes again after each lost connection; what could not be opened is tried anew then. */
  private async hello(hello: Hello): Promise<void> {
    try {
      await this.open(hello);
    } catch (error) {
      const why = error instanceof Refused ? ` The server says: ${error.message}` : '';
      this.notice(`The page could not be opened completely; load it again.${why}`);
    }
  }

  private async open(hello: Hello): Promise<void> {
    const isFirst = this.reader === null;
    const reader = (this.reader ??= new RowReader(hello.columns, hello.status_bits));
    if (isFirst) {
      if (!isExported()) this.build = new BuildPanel(this.server);
      this.colours = hello.colours;
      showLegend(hello.colours, { invented: false, thin: false, rim: false, turned: false });
    }
    const opened = hello.scene ? this.openScene(hello.scene) : undefined; // its parts come while the view is made
    if (isFirst) this.makeView(hello);
    await opened;
    if (document.body.dataset['ready']) return;
    if (hello.live) this.sources.add('live', 'Live');
    if (hello.recordings > 0) {
      const open = (number: number): Promise<Recording> => Recording.open(number, this.server, reader, () => this.changed());
      this.recordings = await Promise.all(Array.from({ length: hello.recordings }, (_, number) => open(number)));
      this.player.open(this.recordings, await this.server.difference());
      this.sources.add('recording', this.recordings.length > 1 ? 'Recordings' : 'Recording');
    }
    this.numbers.columns([]);
    this.sources.choose(hello.live ? 'live' : isExported() ? 'touch' : 'recording');
    document.body.dataset['ready'] = 'yes';
  }

  private makeView(hello: Hello): void {
    try {
      this.view = new SceneView(this.canvas, hello.colours);
    } catch {
      this.canvas.hidden = true;
      element('legend').hidden = true;
      const where = element('scene');
      where.append(make('p', { className: 'no-webgl', textContent: 'This browser does not support WebGL, or WebGL is turned off, so the page cannot show the object. Numbers and curves work. Turn on hardware acceleration in the settings of the browser, or use another browser.' }));
      return;
    }
    const view = this.view;
    view.beforePicture = (): void => this.place();
    this.touch.attach(view, this.canvas);
    view.orbit.listen(this.canvas, () => this.touch.on);
    this.slice = new SliceControl(view, (of, axis, at, samples) => this.distances(of, axis, at, samples));
    const slice = this.slice;
    this.canvas.addEventListener('pointermove', (event) => slice.follow(event));
    const layers = { surface: true, points: false };
    const show = (): void => {
      view.object.show(layers.surface, layers.points);
      view.change();
    };
    element('layers').prepend(
      toggle('Surface', 'u', true, (on) => ((layers.surface = on), show())),
      toggle('Points', 'p', false, (on) => ((layers.points = on), show())),
      toggle('Slice', 's', false, (on) => slice.show(on)),
    );
  }

  /** One object after the other; of those that come meanwhile the newest, so that of a field that grows something is always shown. */
  private async openScene(summary: SceneSummary): Promise<void> {
    this.wanted = summary;
    if (this.opens) return;
    this.opens = true;
    while (this.wanted && !this.rests(this.wanted)) {
      const next: SceneSummary = this.wanted;
      this.wanted = null;
      if (this.shows(next)) this.notice(''); // also where another object could not be loaded meanwhile
      else await this.openNow(next);
    }
    this.opens = false;
  }

  /** After a lost connection the same object comes again; the hand that touches it keeps its trace. */
  private shows(summary: SceneSummary): boolean {
    return this.summary !== null && JSON.stringify(this.summary) === JSON.stringify(summary);
  }

  /** The hand of this page keeps the object that it touches, also where the field at the controller changes. */
  private rests(summary: SceneSummary): boolean {
    return this.source === 'touch' && summary.follows && this.touched !== null && this.touched === this.summary;
  }

  private async openNow(summary: SceneSummary): Promise<void> {
    try {
      const [surface, points, rim, turned] = await Promise.all(['surface', 'points', 'rim', 'turned'].map((name) => this.server.part(name, summary)));
      // Only now: where a part is refused, the object of before stays, with its own name and facts.
      const share = summary.invented_share ?? 0;
      const invented = share > 0 ? `, ${(100 * share).toFixed(1)} % of its surface invented` : '';
      say(element('object'), `${summary.name}, voxel ${summary.voxel_mm.toFixed(3)} mm${invented}`);
      showFacts(summary);
      if (!this.view) return;
      if (surface) this.view.object.setSurface(surface);
      if (points) this.view.object.setPoints(points);
      if (rim) this.view.object.setRim(rim);
      if (turned) this.view.object.setTurned(turned);
      const has = (lines: DataView | undefined): boolean => (lines?.getUint32(0, true) ?? 0) > 0;
      if (this.colours) showLegend(this.colours, { invented: share > 0, thin: summary.thin_share >= kMinShare, rim: has(rim), turned: has(turned) });
      this.view.setScene(summary);
      this.slice?.setScene(summary);
      this.summary = summary;
      this.controller.isDrawn(summary);
      this.warnOfField();
      this.sources.add('touch', 'Touch');
      if (this.source === 'touch') this.sources.choose('touch');
      document.body.dataset['scene'] = summary.hash;
      this.notice('');
    } catch (error) {
      if (this.wanted || (error instanceof Refused && error.status === kGone)) return; // the newest object comes by itself
      this.notice(error instanceof Refused ? error.message : 'The object could not be loaded; load the page again.');
    }
  }

  /** Whether what is drawn is what was, or is, felt. */
  private warnOfField(): void {
    const live = this.controller.warning(this.summary, this.wanted !== null || this.opens);
    const recorded = (): string => {
      const drawn = this.summary;
      if (!drawn) return '';
      const isOther = (hash: string): boolean => hash !== '' && hash !== drawn.hash;
      if (this.recordings.some(({ summary }) => isOther(summary.field))) return 'The hand felt another field than the one that is drawn.';
      return this.recordings.some(({ summary }) => summary.is_patched) ? 'The field changed while the hand felt it; it is drawn as it was in a part of the recording.' : '';
    };
    say(element('field-warning'), this.source === 'recording' ? recorded() : this.source === 'live' ? live : '');
  }

  /** Live, or recording. */
  private use(source: string): void {
    this.source = source;
    const names = source === 'live' ? ['live'] : source === 'touch' ? ['your hand'] : this.recordings.map((recording) => recording.summary.name);
    element('touch').hidden = source !== 'touch';
    if (source === 'touch') void this.beginTouch();
    else this.touch.end();
    element('player').hidden = source !== 'recording';
    if (source !== 'recording') this.player.stop();
    this.view?.setPanes(Math.max(1, names.length));
    element('scene').dataset['panes'] = String(Math.max(1, names.length));
    this.numbers.columns(names);
    this.plots.make(names);
    this.plots.now = null;
    this.plots.marks = source === 'recording' ? this.player.marks() : [];
    this.words(source === 'live' ? this.controller.words : []);
    this.warnOfField();
    if (this.wanted) void this.openScene(this.wanted);
    if (source === 'recording') void this.plotRecordings();
    this.changed();
  }

  private async plotRecordings(): Promise<void> {
    try {
      const all = await Promise.all(this.recordings.map((recording) => recording.curves(kPieces)));
      const longest = all.reduce((a, b) => ((b.times.at(-1) ?? 0) > (a.times.at(-1) ?? 0) ? b : a));
      const column = (name: 'force' | 'penetration' | 'energy'): Data => [
        longest.times,
        ...all.map((curves) => inPieces(longest.times, curves, name)),
      ];
      this.plots.set([column('force'), column('penetration'), column('energy')]);
    } catch {
      this.notice('The curves could not be loaded; load the page again.');
    }
  }

  private async beginTouch(): Promise<void> {
    const summary = this.summary;
    if (!this.view || !summary) return;
    const isWanted = (): boolean => this.source === 'touch' && this.summary === summary;
    try {
      this.touched = summary;
      await this.touch.begin(summary, isWanted);
      if (isWanted()) this.canvas.focus();
    } catch (error) {
      this.touched = null;
      if (this.wanted) void this.openScene(this.wanted);
      if (error instanceof Refused && error.status === kGone) return; // the newest object comes by itself
      if (this.summary === summary) this.notice(error instanceof Error ? error.message : 'The core could not be started; load the page again.');
    }
  }

  /** Of a slice: from the server; where there is none, or it has another object by now, from the core in this page if that has this one. */
  private async distances(of: SceneSummary, axis: string, at: number, samples: number): Promise<DataView> {
    const own = (): Promise<DataView> => localSlice(of, axis, at, samples, (places) => this.touch.sample(of, places));
    if (isExported()) return own();
    try {
      return await this.server.slice(of, axis, at, samples);
    } catch (error) {
      if (this.touch.has(of) && error instanceof Refused && error.status === kGone) return own();
      throw error;
    }
  }

  private touchMoved(): void {
    if (this.source !== 'touch') return;
    this.pictures.fresh = true;
    this.changed();
  }

  /** Another tick is to be seen. */
  private changed(): void {
    if (this.view) this.view.moved();
    else requestAnimationFrame(() => this.place());
  }

  /** Puts the shown ticks into the picture, the table and the curves. */
  private place(): void {
    const now = performance.now();
    const ticks = this.shownTicks();
    const first = ticks[0] ?? null;
    if (this.source === 'live' && first && first !== this.shownLive) {
      this.shownLive = first;
      this.pictures.fresh = true;
      this.changed(); // the next picture's tick is already there
    }
    ticks.forEach((tick, pane) => {
      const marks = this.view?.panes[pane];
      if (!marks) return;
      if (!tick || !isKnown(tick.hip)) {
        if (tick || this.source !== 'recording') marks.clear(); // a recorded tick is on its way
        return;
      }
      const running = this.source === 'live' ? this.controller.live : this.source === 'touch' ? this.touch.touched : null;
      marks.setTrail(running ? running.trail(tick.tick) : (this.recordings[pane]?.trail(tick.tick) ?? []));
      marks.push(tick.hip);
      marks.show(tick);
    });
    this.countPictures(now);
    clearTimeout(this.plotsLater);
    if (now - this.plottedAt < kPlotsMs) {
      this.plotsLater = setTimeout(() => this.changed(), kPlotsMs);
      return;
    }
    this.plottedAt = now;
    this.numbers.show(ticks);
    if (this.source === 'live') {
      this.plots.set(this.controller.live.curves());
    } else if (this.source === 'touch') {
      this.plots.set(this.touch.touched.curves());
    } else if (this.source === 'recording') {
      this.plots.now = this.player.tick * this.player.period;
      this.plots.redraw();
      void this.recordedWords();
    }
  }

  private shownTicks(): (Tick | null)[] {
    if (this.source === 'live') return [this.controller.live.shown()];
    if (this.source === 'touch') return [this.touch.touched.newest];
    return this.recordings.map((recording) => recording.tick(this.player.tickOf(recording)));
  }

  private async recordedWords(): Promise<void> {
    const tick = this.player.tick;
    const now = performance.now();
    if (this.recordings.length === 0 || tick === this.askedWords || (this.player.playing && now - this.askedWordsAt < kWordsMs)) return;
    this.askedWords = tick;
    this.askedWordsAt = now;
    try {
      const words = await Promise.all(this.recordings.map((recording) => recording.words(this.player.tickOf(recording))));
      if (this.source === 'recording') this.words(words); // answers come in the order of the questions
    } catch {
      this.askedWords = -1; // the server is gone; the page says so
    }
  }

  /** Of each run; the names of two are said. */
  private words(all: Words[]): void {
    const named = (sentence: string, run: number): string => (all.length > 1 ? `${this.recordings[run]?.summary.name}: ${sentence}` : sentence);
    const state = element('state');
    state.classList.toggle('bad', all.some((words) => words.fault));
    say(state, all.map((words, run) => named(words.sentence, run)).join('\n'));
    const limits = all.flatMap((words, run) => words.limits.map((limit) => named(limit, run)));
    const list = element('limits');
    list.replaceChildren(...limits.map((limit) => make('li', { textContent: limit })));
    list.hidden = limits.length === 0;
  }

  private notice(sentence: string): void {
    say(element('notice'), sentence);
  }

  /** Pictures in which something had moved, a second. */
  private countPictures(now: number): void {
    if (this.pictures.fresh) this.pictures.drawn += 1;
    this.pictures.fresh = false;
    if (now - this.pictures.since < 1000) return;
    this.pictures.shown = (1000 * this.pictures.drawn) / (now - this.pictures.since);
    this.pictures.drawn = 0;
    this.pictures.since = now;
    document.body.dataset['pictures'] = this.pictures.shown.toFixed(1);
  }

  private extraNumbers(): [string, string][] {
    if (this.source === 'touch') return [['Pictures', `${this.pictures.shown.toFixed(0)} a second`], ...this.touch.numbers()];
    if (this.source !== 'live') return [];
    return [
      ['Pictures', `${this.pictures.shown.toFixed(0)} a second`],
      ['Ticks not shown', `${Math.round(this.controller.live.lost)}`],
    ];
  }

  private keys(): void {
    const press = (label: string): void => {
      const found = [...document.querySelectorAll<HTMLButtonElement>('#layers button')].find((one) => one.textContent === label);
      found?.click();
    };
    bindKeys(
      this.canvas,
      (event) => {
        const turns = event.shiftKey || !this.touch.on;
        return (!turns && this.touch.key(event.key)) || this.view?.orbit.key(event.key) || false;
      },
      {
        h: () => this.view?.orbit.step(-1, 0),
        j: () => this.view?.orbit.step(0, -1),
        k: () => this.view?.orbit.step(0, 1),
        l: () => this.view?.orbit.step(1, 0),
        u: () => press('Surface'),
        p: () => press('Points'),
        s: () => press('Slice'),
        x: () => this.slice?.choose('x'),
        y: () => this.slice?.choose('y'),
        z: () => this.slice?.choose('z'),
        '[': () => this.slice?.step(-1),
        ']': () => this.slice?.step(1),
        ',': () => this.player.step(-1),
        '.': () => this.player.step(1),
        ' ': () => this.source === 'recording' && (this.player.toggle(), true),
        c: () => this.player.jump('contact'),
        f: () => this.player.jump('fault'),
        g: () => this.player.jump('setting'),
      },
    );
  }
}

new Page();
