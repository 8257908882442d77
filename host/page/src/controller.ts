// What the page knows of a running controller: its ticks, what it does in words, which field it has, and whether any of that still comes.
import { element, say } from './dom';
import { kSilentMs, Live } from './live';
import type { Link, SceneSummary, Status, Words } from './messages';
import type { Plots } from './plots';
import type { RowReader } from './rows';

const kFollowsMs = 5000; // within which the controller's field is drawn when it has another one

export class Controller {
  readonly live = new Live();
  private link: Link | null = null;
  private silence: ReturnType<typeof setTimeout> | undefined;
  private saysSilence = false; // no tick has come for a second
  private said: Words[] = [];
  private field: string | null | undefined; // null: it has none; undefined: not known
  private fieldSentence = ''; // why it cannot be drawn
  private agreedAt = 0; // ms; what was drawn was what it had, or the newest that had come of it

  /** `changed`: there is something new but ticks. */
  constructor(private readonly plots: Plots, private readonly changed: () => void) {
    document.addEventListener('visibilitychange', () => this.awaitTicks());
  }

  /** What it does; nothing while no tick comes. May be known before the view is made. */
  get words(): Words[] {
    return this.saysSilence ? [] : this.said;
  }

  /** Returns whether they were taken: not those of a controller that is gone. */
  take(first: number, every: number, rows: DataView, reader: RowReader | null): boolean {
    if (!reader || !this.link?.there) return false;
    this.live.take(first, every, rows, reader);
    this.awaitTicks();
    return true;
  }

  hear(message: Link | Words | Status): void {
    if (message.topic === 'link') {
      if (message.period_ns !== undefined) this.live.period = message.period_ns * 1e-9;
      this.forget();
      this.link = message;
      this.sayLink(message.sentence, !message.there);
      this.awaitTicks();
      return;
    }
    if (!this.link?.there) return; // of a controller that is gone
    if (message.topic === 'state') {
      this.said = [message];
    } else {
      this.field = message.status.field_hash;
      this.fieldSentence = message.field_sentence ?? '';
      this.plots.setHistograms(message.histograms_us.wakeup, message.histograms_us.tick);
    }
    this.changed();
  }

  /** Nothing of a controller that is gone looks as if it were now. */
  forget(): void {
    this.link = null;
    this.live.clear();
    clearTimeout(this.silence);
    this.saysSilence = false;
    this.field = undefined;
    this.fieldSentence = '';
    this.said = [];
    this.plots.clearHistograms();
    this.changed();
  }

  /** Another object is drawn now. */
  isDrawn(summary: SceneSummary): void {
    this.agreedAt = performance.now();
    if (summary.follows) this.fieldSentence = '';
  }

  /** Whether what is drawn is what is felt there; empty: it is, or that is not known. `comes`: another object is being loaded. */
  warning(drawn: SceneSummary | null, comes: boolean): string {
    const agrees = this.field === undefined || this.field === drawn?.hash;
    if (agrees) this.agreedAt = performance.now();
    if (this.fieldSentence !== '') return this.fieldSentence;
    if (!drawn || agrees) return '';
    if (drawn.follows && (comes || performance.now() - this.agreedAt < kFollowsMs)) return '';
    if (this.field !== null) return 'The hand feels another field than the one that is drawn.';
    return drawn.follows ? 'The controller has no field any more; the one that is drawn was its last.' : '';
  }

  private sayLink(sentence: string, bad: boolean): void {
    element('link').classList.toggle('bad', bad);
    say(element('link'), sentence);
  }

  /** Says so when no tick has come for a second. A page that is not seen gets none, because it shows none. */
  private awaitTicks(): void {
    clearTimeout(this.silence);
    const link = this.link;
    if (!link?.there || document.hidden) return;
    if (this.saysSilence && !this.live.isSilent) {
      this.saysSilence = false;
      this.sayLink(link.sentence, false);
      this.changed();
    }
    this.silence = setTimeout(() => {
      this.saysSilence = true;
      this.sayLink(`${link.sentence}, but has sent no tick for a second; see with isotouch status whether its loop runs`, true);
      this.changed();
    }, kSilentMs);
  }
}
