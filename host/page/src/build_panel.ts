// A scan that is dropped on the page: sent to the server, which builds the field; how far it is, and what it found.
import { element, make } from './dom';
import type { Build } from './messages';
import { Refused, type Server } from './server';

const number = (value: number): string => value.toLocaleString('en');

export class BuildPanel {
  private readonly panel = element('build');
  private said = '';

  constructor(private readonly server: Server) {
    const drop = element('drop');
    const file = make('input', { type: 'file', id: 'file', className: 'hidden' });
    file.setAttribute('aria-label', 'Scan to build a field from');
    const open = make('button', { type: 'button', textContent: 'Open a scan…' });
    open.addEventListener('click', () => file.click());
    file.addEventListener('change', () => {
      const chosen = file.files?.[0];
      if (chosen) void this.send(chosen);
      file.value = '';
    });
    element('layers').append(open, file);
    addEventListener('dragover', (event) => {
      event.preventDefault();
      drop.hidden = false;
    });
    addEventListener('dragleave', (event) => {
      if (event.relatedTarget === null) drop.hidden = true;
    });
    addEventListener('drop', (event) => {
      event.preventDefault();
      drop.hidden = true;
      const dropped = event.dataTransfer?.files[0];
      if (dropped) void this.send(dropped);
    });
  }

  async send(file: File): Promise<void> {
    this.say(`${file.name} is being sent (${number(Math.round(file.size / 1024))} KiB).`);
    try {
      await this.server.build(file.name, file);
    } catch (error) {
      this.say(error instanceof Refused ? error.message : `${file.name} could not be sent; see whether isotouch view still runs.`);
    }
  }

  show(build: Build): void {
    const said = JSON.stringify(build);
    if (said === this.said) return; // it comes again after a lost connection, also where the panel was closed since
    this.said = said;
    if (build.result === undefined) {
      const progress = make('progress', { max: 1, value: build.done ?? 0 });
      progress.setAttribute('aria-label', 'Share of the build that is done');
      this.fill(make('p', {}, `${build.name}: ${build.stage ?? ''} `), progress);
      return;
    }
    const figures = build.figures;
    const parts: Node[] = [];
    const title = { built: `${build.name} was built.`, refused: `${build.name} was refused: the field would probably be wrong.`, failed: build.sentence ?? '' };
    parts.push(make('p', { className: build.result === 'built' ? '' : 'bad', textContent: title[build.result] }));
    if (figures) {
      const facts = [`${number(figures.points)} ${figures.items}`];
      if (figures.seconds !== undefined) facts.push(`${figures.seconds.toFixed(2)} s`);
      if (figures.bytes !== undefined) facts.push(`${number(Math.round(figures.bytes / 1024))} KiB in memory`);
      parts.push(make('p', { textContent: facts.join(' · ') }));
      const verdict = figures.verdict;
      if (verdict) parts.push(make('p', { textContent: `Verdict: ${verdict.words.split('\n')[0] ?? ''}` }));
      const sentences = [...(verdict?.reasons ?? []), ...figures.warnings];
      if (sentences.length > 0) parts.push(make('ul', {}, ...sentences.map((sentence) => make('li', { textContent: sentence }))));
    }
    this.fill(...parts);
  }

  private say(sentence: string): void {
    this.fill(make('p', { textContent: sentence }));
  }

  private fill(...parts: Node[]): void {
    const close = make('button', { type: 'button', textContent: 'Close', className: 'close' });
    close.addEventListener('click', () => (this.panel.hidden = true));
    this.panel.replaceChildren(make('h2', { textContent: 'Build' }), ...parts, close);
    this.panel.hidden = false;
  }
}
