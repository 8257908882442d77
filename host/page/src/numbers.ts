// The table of what one tick holds, in one column for each run; every number with its unit.
import { element, make } from './dom';
import { isKnown, length, type Tick, type Vector } from './rows';

const triple = (v: Vector, digits: number): string => (isKnown(v) ? [v.x, v.y, v.z].map((value) => value.toFixed(digits)).join('  ') : '–');

const kRows: [string, (tick: Tick) => string][] = [
  ['Force', (tick): string => `${length(tick.force).toFixed(2)} N`],
  ['Penetration', (tick): string => `${tick.penetration.toFixed(2)} mm`],
  ['Energy given to the hand', (tick): string => `${tick.energy.toFixed(2)} mJ`],
  ['Hand x, y, z (mm)', (tick): string => triple(tick.hip, 1)],
  ['Proxy x, y, z (mm)', (tick): string => triple(tick.proxy, 1)],
  ['Contact', (tick): string => (tick.contact ? 'yes' : 'no')],
  ['Tick', (tick): string => String(tick.tick)],
];

export class Numbers {
  private cells: HTMLTableCellElement[][] = [];

  constructor(private readonly extra: () => [string, string][]) {}

  columns(names: string[]): void {
    const table = element<HTMLTableElement>('numbers');
    const head = make('tr', {}, make('td'), ...names.map((name) => make('th', { scope: 'col', textContent: name })));
    table.tHead?.replaceChildren(...(names.length > 1 ? [head] : []));
    this.cells = [];
    const rows = [...kRows.map(([label]) => label), ...this.extra().map(([label]) => label)].map((label) => {
      const cells = names.map(() => make('td', { textContent: '–' }));
      this.cells.push(cells);
      return make('tr', {}, make('th', { scope: 'row', textContent: label }), ...cells);
    });
    table.tBodies[0]?.replaceChildren(...rows);
    table.hidden = names.length === 0;
  }

  show(ticks: (Tick | null)[]): void {
    kRows.forEach(([, text], row) =>
      ticks.forEach((tick, column) => {
        const cell = this.cells[row]?.[column];
        if (cell) cell.textContent = tick ? text(tick) : '–';
      }),
    );
    this.extra().forEach(([, text], row) => {
      const cell = this.cells[kRows.length + row]?.[0];
      if (cell) cell.textContent = text;
    });
  }
}
