// Plays one or two recordings with one time: the time line, its marks, and its buttons. Its ticks are those of the recording with the shortest period.
import { element, make, say } from './dom';
import type { Difference } from './messages';
import type { Recording } from './recording';

const kRounding = 1e-6; // ticks: a quotient of two periods is not exact
const kSpeeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 5];

export class Player {
  tick = 0;
  playing = false;
  private recordings: Recording[] = [];
  private speed = 1;
  private last = 0;
  private exact = 0;
  private difference: number | null = null;
  private readonly scrub = element<HTMLInputElement>('scrub');
  private readonly play = element<HTMLButtonElement>('play');
  private readonly speeds = element<HTMLSelectElement>('speed');

  /** `shown` is called whenever another tick is shown. */
  constructor(private readonly shown: () => void) {
    for (const speed of kSpeeds) this.speeds.append(make('option', { value: String(speed), textContent: `${speed} ×`, selected: speed === 1 }));
    this.speeds.addEventListener('change', () => (this.speed = Number(this.speeds.value)));
    this.play.addEventListener('click', () => this.toggle());
    this.scrub.addEventListener('input', () => {
      this.stop();
      this.show(Number(this.scrub.value));
    });
    for (const button of document.querySelectorAll<HTMLButtonElement>('[data-jump]'))
      button.addEventListener('click', () => this.jump(button.dataset['jump'] ?? ''));
    element('jump-difference').addEventListener('click', () => {
      this.stop();
      this.show(this.difference ?? 0);
    });
  }

  get ticks(): number {
    return Math.max(1, ...this.recordings.map((recording) => this.placeOf(recording, recording.summary.ticks - 1) + 1));
  }
  get period(): number {
    return this.recordings.length > 0 ? Math.min(...this.recordings.map((recording) => recording.period)) : 1e-3;
  }

  /** The tick of a recording that is shown: its last one that is not later. */
  tickOf(recording: Recording): number {
    const tick = Math.floor((this.tick * this.period) / recording.period + kRounding);
    return Math.min(tick, recording.summary.ticks - 1);
  }

  /** Where a tick of a recording is on the time line. */
  private placeOf(recording: Recording, tick: number): number {
    return Math.ceil((tick * recording.period) / this.period - kRounding);
  }

  open(recordings: Recording[], difference: Difference | null): void {
    this.recordings = recordings;
    this.scrub.max = String(this.ticks - 1);
    const first = recordings[0]; // whose ticks the difference counts
    this.difference = first && difference && !difference.equal ? this.placeOf(first, difference.tick ?? 0) : null;
    const text = element('difference');
    const names = recordings.map((recording) => recording.summary.name);
    if (!difference) say(text, '');
    else if (difference.equal) say(text, `${names[0]} and ${names[1]} are equal, every bit.`);
    else say(text, `They differ first at tick ${difference.tick} (${this.seconds(this.difference ?? 0)} s), in ${difference.field}.`);
    if (recordings.some((recording) => recording.summary.more_events)) say(text, `${text.textContent} Of each kind of event, the first 2000 are marked.`.trim());
    for (const { summary } of recordings)
      if (summary.is_cut_off) say(text, `${text.textContent} The file of ${summary.name} is cut off; its whole ticks are shown.`.trim());
    element('jump-difference').hidden = this.difference === null;
    this.drawMarks();
    for (const button of document.querySelectorAll<HTMLButtonElement>('[data-jump]'))
      button.disabled = !recordings.some((recording) => recording.nextEvent(button.dataset['jump'] ?? '', -1));
    this.show(0);
  }

  marks(): { time: number; kind: string }[] {
    const marks = this.recordings.flatMap((recording) => recording.summary.events.map(({ tick, kind }) => ({ time: tick * recording.period, kind: kind as string })));
    if (this.difference !== null) marks.push({ time: this.difference * this.period, kind: 'difference' });
    return marks;
  }

  toggle(): void {
    if (this.playing) this.stop();
    else this.start();
  }

  step(ticks: number): void {
    this.stop();
    this.show(this.tick + ticks);
  }

  stop(): void {
    this.playing = false;
    this.play.textContent = 'Play';
    this.shown();
  }

  show(tick: number): void {
    this.tick = Math.max(0, Math.min(this.ticks - 1, Math.round(tick)));
    this.exact = this.tick;
    this.scrub.value = String(this.tick);
    const isOne = this.recordings.every((recording) => recording.period === this.period); // else each has another tick, which the table shows
    this.scrub.setAttribute('aria-valuetext', `${isOne ? `tick ${this.tick}, ` : ''}${this.seconds(this.tick)} seconds`);
    element('when').textContent = `${this.seconds(this.tick)} s${isOne ? ` · tick ${this.tick} of ${this.ticks - 1}` : ''}`;
    say(element('event'), this.lastEvent());
    this.shown();
  }

  /** Of all recordings the one that was last; the names of two are said. */
  private lastEvent(): string {
    const events = this.recordings.flatMap((recording) => {
      const event = recording.lastEvent(this.tickOf(recording));
      return event ? [{ time: event.tick * recording.period, text: event.text, name: recording.summary.name }] : [];
    });
    const last = events.reduce<(typeof events)[number] | null>((a, b) => (a && a.time >= b.time ? a : b), null);
    if (!last) return '';
    return `${last.time.toFixed(3)} s${this.recordings.length > 1 ? `, ${last.name}` : ''}: ${last.text}.`;
  }

  jump(kind: string): void {
    const places = this.recordings.flatMap((recording) => {
      const event = recording.nextEvent(kind, this.tickOf(recording));
      return event ? [this.placeOf(recording, event.tick)] : [];
    });
    const behind = places.filter((place) => place > this.tick);
    const next = (behind.length > 0 ? behind : places).sort((a, b) => a - b)[0];
    if (next === undefined) return;
    this.stop();
    this.show(next);
  }

  private seconds(tick: number): string {
    return (tick * this.period).toFixed(3);
  }

  private start(): void {
    if (this.recordings.length === 0) return;
    if (this.tick >= this.ticks - 1) this.show(0);
    this.playing = true;
    this.play.textContent = 'Pause';
    this.last = performance.now();
    const advance = (now: number): void => {
      if (!this.playing) return;
      const exact = this.exact + ((now - this.last) / 1000 / this.period) * this.speed;
      this.last = now;
      this.show(exact);
      this.exact = Math.min(exact, this.ticks - 1);
      if (this.tick >= this.ticks - 1) this.stop();
      else requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }

  private drawMarks(): void {
    const where = element('marks');
    where.replaceChildren();
    for (const { time, kind } of this.marks()) {
      const mark = make('span', { className: `mark ${kind}` });
      mark.style.left = `${(100 * time) / this.period / Math.max(1, this.ticks - 1)}%`;
      where.append(mark);
    }
  }
}
