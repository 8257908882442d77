// A slice from the core in this page, for a page without a server: the bytes are those of host/server/scene.h.
import type { SceneSummary } from './messages';

export async function localSlice(
  summary: SceneSummary,
  axis: string,
  at: number,
  samples: number,
  sample: (places: Float64Array) => Promise<Float64Array>,
): Promise<DataView> {
  const across = 'xyz'.indexOf(axis);
  const [u, v] = [(across + 1) % 3, (across + 2) % 3];
  const low = (n: number): number => summary.low_mm[n] ?? 0;
  const size = (n: number): number => (summary.high_mm[n] ?? 0) - low(n);
  const longer = Math.max(size(u), size(v));
  const count = (n: number): number => Math.max(2, Math.round((samples * size(n)) / longer));
  const [columns, rows] = [count(u), count(v)];
  const place = (column: number, row: number): number[] => {
    const where = [0, 0, 0];
    where[across] = at;
    where[u] = low(u) + (size(u) * column) / (columns - 1);
    where[v] = low(v) + (size(v) * row) / (rows - 1);
    return where;
  };
  const places = new Float64Array(3 * columns * rows);
  for (let n = 0; n < columns * rows; ++n) places.set(place(n % columns, Math.floor(n / columns)), 3 * n);
  const distances = await sample(places);
  const view = new DataView(new ArrayBuffer(44 + 4 * columns * rows));
  view.setUint32(0, columns, true);
  view.setUint32(4, rows, true);
  [...place(0, 0), ...place(columns - 1, 0), ...place(0, rows - 1)].forEach((value, n) => view.setFloat32(8 + 4 * n, value, true));
  distances.forEach((value, n) => view.setFloat32(44 + 4 * n, value, true));
  return view;
}
