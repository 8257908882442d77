// Curves over time, and the histograms of a controller's times.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { make } from './dom';

/** One curve of each run. */
export interface Curve {
  label: string;
  unit: string;
}

export const kCurves: Curve[] = [
  { label: 'Force', unit: 'N' },
  { label: 'Penetration', unit: 'mm' },
  { label: 'Energy', unit: 'mJ' },
];

/** Times in seconds, then a value for each run; a run without one has null. */
export type Data = (number | null | undefined)[][];

/** A line across all curves: a mark of the recording, or where it is now. */
export interface Mark {
  time: number;
  kind: string;
}

const kHeight = 104;

interface Look {
  ink: string;
  grid: string;
  runs: string[];
  mark: string;
  now: string;
}

function look(): Look {
  const style = getComputedStyle(document.documentElement);
  const of = (name: string): string => style.getPropertyValue(name).trim();
  return { ink: of('--ink'), grid: of('--grid'), runs: [of('--run-a'), of('--run-b')], mark: of('--mark'), now: of('--ink') };
}

export class Plots {
  now: number | null = null;
  marks: Mark[] = [];
  private plots: uPlot[] = [];
  private data: Data[] = [];
  private histogram: uPlot | null = null;
  private histogramData: Data = [];
  private names: string[] = [];
  /** Where a person points at or clicks, in seconds. */
  onPick: (time: number) => void = () => {};

  constructor(private readonly where: HTMLElement) {
    new ResizeObserver(() => this.resize()).observe(where);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.make(this.names));
  }

  /** One curve for each named run in every plot. */
  make(names: string[]): void {
    this.names = names;
    this.plots.forEach((plot) => plot.destroy());
    this.histogram?.destroy();
    this.histogram = null;
    this.where.replaceChildren();
    this.plots = names.length === 0 ? [] : kCurves.map((curve, number) => this.plot(curve, names, this.data[number] ?? [[], ...names.map(() => [])]));
    if (this.histogramData.length > 0) this.makeHistogram();
  }

  set(data: Data[]): void {
    this.data = data;
    this.plots.forEach((plot, number) => plot.setData((data[number] ?? [[]]) as uPlot.AlignedData));
  }

  redraw(): void {
    this.plots.forEach((plot) => plot.redraw(false));
  }

  /** Rows of upper bound (µs) and count, of the wake-up delay and of the tick. */
  setHistograms(wakeup: [number, number][], tick: [number, number][]): void {
    const uppers = [...new Set([...wakeup, ...tick].map(([upper]) => upper))].sort((a, b) => a - b);
    const counts = (of: [number, number][]): (number | null)[] => {
      const known = new Map(of);
      return uppers.map((upper) => known.get(upper) ?? null);
    };
    this.histogramData = [uppers, counts(wakeup), counts(tick)];
    if (!this.histogram) this.makeHistogram();
    else this.histogram.setData(this.histogramData as uPlot.AlignedData);
  }

  clearHistograms(): void {
    this.histogram?.root.closest('figure')?.remove();
    this.histogram?.destroy();
    this.histogram = null;
    this.histogramData = [];
  }

  private width(): number {
    return Math.max(this.where.clientWidth, 200);
  }

  private resize(): void {
    for (const plot of [...this.plots, ...(this.histogram ? [this.histogram] : [])]) plot.setSize({ width: this.width(), height: kHeight });
  }

  private figure(title: string): HTMLElement {
    const figure = make('figure', {}, make('figcaption', { textContent: title }));
    this.where.append(figure);
    return figure;
  }

  private axes(colours: Look): [uPlot.Axis, uPlot.Axis] {
    const axis = { stroke: colours.ink, grid: { stroke: colours.grid, width: 1 }, ticks: { stroke: colours.grid }, font: '11px system-ui' };
    return [
      { ...axis, size: 26, values: (_, splits) => splits.map((value) => `${Number(value.toPrecision(6))} s`) },
      { ...axis, size: 50 },
    ];
  }

  private plot(curve: Curve, names: string[], data: Data): uPlot {
    const colours = look();
    const figure = this.figure(`${curve.label}, ${curve.unit}`);
    const plot = new uPlot(
      {
        width: this.width(),
        height: kHeight,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, sync: { key: 'time' } },
        scales: { x: { time: false } },
        axes: this.axes(colours),
        series: [
          {},
          ...names.map((label, run) => ({
            label,
            stroke: colours.runs[run] ?? colours.ink,
            width: 1.5,
            dash: run === 0 ? [] : [6, 3],
            points: { show: false },
          })),
        ],
        hooks: { draw: [(drawn): void => this.drawMarks(drawn, colours)] },
      },
      data as uPlot.AlignedData,
      figure,
    );
    plot.over.addEventListener('click', () => {
      const left = plot.cursor.left;
      if (left !== undefined && left >= 0) this.onPick(plot.posToVal(left, 'x'));
    });
    return plot;
  }

  private drawMarks(plot: uPlot, colours: Look): void {
    const { ctx, bbox } = plot;
    const line = (time: number, colour: string, dash: number[], wide: number): void => {
      const x = plot.valToPos(time, 'x', true);
      if (!(x >= bbox.left && x <= bbox.left + bbox.width)) return;
      ctx.save();
      ctx.beginPath();
      ctx.setLineDash(dash);
      ctx.strokeStyle = colour;
      ctx.lineWidth = wide * devicePixelRatio;
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.restore();
    };
    for (const mark of this.marks) {
      if (mark.kind !== 'contact' && mark.kind !== 'state') line(mark.time, colours.mark, mark.kind === 'difference' ? [] : [3, 3], mark.kind === 'difference' ? 2 : 1);
    }
    if (this.now !== null) line(this.now, colours.now, [], 1);
  }

  private makeHistogram(): void {
    const colours = look();
    const figure = this.figure('Times of the controller, µs: ticks of each length (wake-up delay dashed)');
    const [x, y] = this.axes(colours);
    this.histogram = new uPlot(
      {
        width: this.width(),
        height: kHeight,
        legend: { show: false },
        cursor: { drag: { x: false, y: false } },
        scales: { x: { time: false, distr: 3 }, y: { distr: 3 } },
        axes: [{ ...x, values: (_, splits) => splits.map((value) => (value >= 1000 ? `${value / 1000} ms` : `${value} µs`)), space: 60 }, { ...y, space: 20 }],
        series: [
          {},
          { label: 'wake-up delay', stroke: colours.runs[1] ?? colours.ink, width: 1.5, dash: [6, 3], points: { show: false }, spanGaps: true },
          { label: 'tick', stroke: colours.runs[0] ?? colours.ink, width: 1.5, points: { show: false }, spanGaps: true },
        ],
      },
      this.histogramData as uPlot.AlignedData,
      figure,
    );
  }
}
