// Rows of ticks as host/server/tick_rows.h lays them out. The server names the columns, so nothing here counts them.
import type { Columns } from './messages';

export interface Vector {
  x: number;
  y: number;
  z: number;
}

export interface Tick {
  tick: number;
  hip: Vector; // mm; not known as long as a device does not know it, nor is the proxy
  proxy: Vector; // mm
  force: Vector; // N
  penetration: number; // mm
  energy: number; // mJ
  contact: boolean;
  fault: boolean;
}

export const isKnown = (v: Vector): boolean => !Number.isNaN(v.x);
export const length = (v: Vector): number => Math.hypot(v.x, v.y, v.z);

export class RowReader {
  readonly bytes: number;
  private readonly offset = new Map<string, number>();
  private readonly contact: number;

  constructor(columns: Columns, statusBits: Record<string, number>) {
    this.bytes = columns.row_bytes;
    [...columns.floats, ...columns.wholes].forEach((name, at) => this.offset.set(name, 4 * at));
    this.contact = statusBits['contact'] ?? 0;
  }

  private at(name: string): number {
    const found = this.offset.get(name);
    if (found === undefined) throw new Error(`the server sends no column '${name}'`);
    return found;
  }

  private vector(view: DataView, start: number, name: string, unit: string): Vector {
    const part = (axis: string): number => view.getFloat32(start + this.at(`${name}_${axis}_${unit}`), true);
    return { x: part('x'), y: part('y'), z: part('z') };
  }

  read(view: DataView, row: number, tick: number): Tick {
    const start = row * this.bytes;
    return {
      tick,
      hip: this.vector(view, start, 'hip', 'mm'),
      proxy: this.vector(view, start, 'proxy', 'mm'),
      force: this.vector(view, start, 'force', 'n'),
      penetration: view.getFloat32(start + this.at('penetration_mm'), true),
      energy: view.getFloat32(start + this.at('energy_mj'), true),
      contact: (view.getUint32(start + this.at('status'), true) & this.contact) !== 0,
      fault: view.getUint32(start + this.at('state_faults'), true) >>> 16 !== 0,
    };
  }
}
