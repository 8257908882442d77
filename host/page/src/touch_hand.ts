// The pointer as the hand: the core runs in a worker, and the page tells it where the pointer is. The wheel moves the hand towards the object.
import workerUrl from './touch/touch_worker.ts?worker&url';
import { At, NUMBERS_OF_A_TICK, Status } from './touch/touch';
import type { FromWorker, ToWorker } from './touch/touch_messages';
import { Vector3 } from 'three';
import { exportedBytes } from './exported';
import type { SceneSummary } from './messages';
import type { Tick } from './rows';
import type { SceneView } from './scene_view';

const kMaxTicks = 600_000; // of a trace: ten minutes
const kStep = 0.5; // mm a key
const kWheel = 0.012; // mm a wheel's pixel
const kPadSpeed = 60; // mm/s of a gamepad's stick
const kPadRest = 0.12; // of its way: a stick that is let go

export interface Felt {
  ticks: Tick[];
  /** Ticks so far, those that were left out, and those in the trace. */
  count: number;
  skipped: number;
  recorded: number;
  /** Share of the time that the core computed. */
  busy: number;
}

export class TouchHand {
  on = false;
  /** What the core has; null while it loads another one. */
  loaded: SceneSummary | null = null;
  private loads = 0;
  private starting: Promise<void> | null = null;
  private worker: Worker | null = null; // once it has begun
  private depth = 0; // mm from the plane through the object's middle towards the eye
  private pointer = { clientX: 0, clientY: 0 };
  private place: Vector3 | null = null;
  private count = 0;
  private padding = 0; // the next look at a gamepad
  private readonly waiting: ((message: FromWorker) => boolean)[] = [];

  constructor(
    private readonly view: SceneView,
    private readonly canvas: HTMLCanvasElement,
    private readonly felt: (felt: Felt) => void,
    private readonly refused: (sentence: string) => void,
    private readonly left: () => void,
    private readonly atDepth: (mm: number) => void,
  ) {
    canvas.addEventListener('pointermove', (event) => this.point(event));
    canvas.addEventListener('pointerdown', (event) => this.point(event));
    canvas.addEventListener('pointerleave', () => this.on && this.lift());
    canvas.addEventListener(
      'wheel',
      (event) => {
        if (!this.on) return;
        event.preventDefault();
        this.deeper(event.deltaY * kWheel);
      },
      { passive: false },
    );
  }

  /** The core with a field; any before it is gone. */
  async load(image: ArrayBuffer, of: SceneSummary): Promise<void> {
    this.starting ??= this.start();
    await this.starting;
    const number = ++this.loads;
    this.loaded = null;
    const loaded = this.answer('loaded');
    this.post({ kind: 'load', image: new Uint8Array(image), name: of.name });
    await loaded;
    if (number === this.loads) this.loaded = of;
    this.post({ kind: 'record', maxTicks: kMaxTicks });
  }

  /** The hand begins in front of the object, in the middle of the picture. */
  begin(radius: number): void {
    this.on = true;
    this.depth = radius;
    const box = this.canvas.getBoundingClientRect();
    this.pointer = { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 };
    this.move();
    cancelAnimationFrame(this.padding); // else each time another loop would begin
    this.padding = requestAnimationFrame((now) => this.pad(now, now));
  }

  end(): void {
    this.on = false;
    this.lift();
  }

  lift(): void {
    this.place = null;
    this.left();
    if (this.worker) this.post({ kind: 'lift' });
  }

  deeper(mm: number): void {
    this.toDepth(this.depth - mm);
  }

  /** Where the hand is between the plane through the object's middle and the eye, mm. */
  toDepth(mm: number): void {
    this.depth = mm;
    this.move();
  }

  /** Whether the key was one of the hand's. */
  key(key: string): boolean {
    const eye = this.view.orbit.camera;
    const axis = (column: number): Vector3 => new Vector3().setFromMatrixColumn(eye.matrix, column);
    const moves: Record<string, () => Vector3> = {
      ArrowLeft: () => axis(0).multiplyScalar(-kStep),
      ArrowRight: () => axis(0).multiplyScalar(kStep),
      ArrowUp: () => axis(1).multiplyScalar(kStep),
      ArrowDown: () => axis(1).multiplyScalar(-kStep),
      PageDown: () => this.view.orbit.towardsEye().multiplyScalar(-kStep),
      PageUp: () => this.view.orbit.towardsEye().multiplyScalar(kStep),
    };
    const move = moves[key];
    if (!move) return false;
    this.shift(move());
    return true;
  }

  /** A gamepad moves the hand, too: the left stick across the picture, the right one towards the object and away. */
  private pad(before: number, now: number): void {
    if (!this.on) return;
    const axes = navigator.getGamepads().find((pad) => pad?.connected)?.axes ?? [];
    const axis = (number: number): number => (Math.abs(axes[number] ?? 0) > kPadRest ? (axes[number] ?? 0) : 0);
    const [right, down, away] = [axis(0), axis(1), axis(3)];
    if (right !== 0 || down !== 0 || away !== 0) {
      const mm = (kPadSpeed * (now - before)) / 1000;
      const eye = this.view.orbit.camera;
      this.shift(
        new Vector3()
          .addScaledVector(new Vector3().setFromMatrixColumn(eye.matrix, 0), right * mm)
          .addScaledVector(new Vector3().setFromMatrixColumn(eye.matrix, 1), -down * mm)
          .addScaledVector(this.view.orbit.towardsEye(), away * mm),
      );
    }
    this.padding = requestAnimationFrame((next) => this.pad(now, next));
  }

  private shift(by: Vector3): void {
    this.place ??= this.view.orbit.middle.clone().addScaledVector(this.view.orbit.towardsEye(), this.depth);
    this.place.add(by);
    this.depth = this.place.clone().sub(this.view.orbit.middle).dot(this.view.orbit.towardsEye());
    this.send();
  }

  /** The trace so far, as a file. */
  async save(): Promise<{ bytes: Uint8Array; ticks: number }> {
    const saved = this.answer('trace');
    this.post({ kind: 'save' });
    return saved;
  }

  /** Distances at places, mm. */
  async sample(places: Float64Array): Promise<Float64Array> {
    const ticket = ++this.count;
    const answer = new Promise<Float64Array>((done, failed) =>
      this.waiting.push((message) => {
        if (message.kind === 'refused' && (message.of === 'sample' || message.of === 'begin')) {
          failed(new Error(message.sentence));
          return true;
        }
        if (message.kind !== 'distances' || message.ticket !== ticket) return false;
        done(message.distances);
        return true;
      }),
    );
    this.post({ kind: 'sample', places, ticket });
    return answer;
  }

  private async start(): Promise<void> {
    const script = exportedBytes('touch_worker.js');
    const worker = new Worker(script ? URL.createObjectURL(new Blob([script], { type: 'text/javascript' })) : workerUrl);
    worker.onerror = (): void => this.take({ kind: 'refused', of: 'begin', sentence: 'The core could not be started in this browser; try another one.' });
    worker.onmessage = ({ data }: MessageEvent<FromWorker>): void => this.take(data);
    const bytes = exportedBytes('touch.wasm');
    const module = await (bytes ? WebAssembly.compile(bytes) : WebAssembly.compileStreaming(fetch('touch.wasm')));
    const ready = this.answer('ready');
    worker.postMessage({ kind: 'begin', module } satisfies ToWorker);
    await ready;
    this.worker = worker;
  }

  private post(message: ToWorker): void {
    this.worker?.postMessage(message);
  }

  /** The next answer of this kind; throws its sentence where the request is refused. */
  private answer<Kind extends FromWorker['kind']>(kind: Kind): Promise<Extract<FromWorker, { kind: Kind }>> {
    return new Promise((done, failed) =>
      this.waiting.push((message) => {
        if (message.kind === 'refused') {
          failed(new Error(message.sentence));
          return true;
        }
        if (message.kind !== kind) return false;
        done(message as Extract<FromWorker, { kind: Kind }>);
        return true;
      }),
    );
  }

  private take(message: FromWorker): void {
    if (message.kind === 'felt') {
      this.felt({ ticks: this.ticks(message.ticks, message.count), count: message.count, skipped: message.skipped, recorded: message.recorded, busy: message.busy });
      return;
    }
    const taker = this.waiting.findIndex((wanted) => wanted(message));
    if (taker >= 0) this.waiting.splice(taker, 1);
    else if (message.kind === 'refused') this.refused(message.sentence);
  }

  private ticks(numbers: Float64Array, count: number): Tick[] {
    const ticks: Tick[] = [];
    const rows = numbers.length / NUMBERS_OF_A_TICK;
    for (let row = 0; row < rows; ++row) {
      const value = (column: number): number => numbers[row * NUMBERS_OF_A_TICK + column] ?? 0;
      const vector = (column: number): { x: number; y: number; z: number } => ({ x: value(column), y: value(column + 1), z: value(column + 2) });
      const tick: Tick = {
        tick: count - rows + row,
        hip: vector(At.hip),
        proxy: vector(At.proxy),
        force: vector(At.force),
        penetration: value(At.penetration),
        energy: value(At.energy),
        contact: (value(At.status) & Status.contact) !== 0,
        fault: false,
      };
      ticks.push(tick);
    }
    return ticks;
  }

  private point(event: PointerEvent): void {
    if (!this.on || (event.buttons & 2) !== 0) return;
    if (this.view.orbit.pinched) {
      if (this.place) this.lift();
      return;
    }
    this.pointer = { clientX: event.clientX, clientY: event.clientY };
    this.move();
  }

  private move(): void {
    const { from, along } = this.view.ray(this.pointer);
    const eye = this.view.orbit.towardsEye();
    const plane = this.view.orbit.middle.clone().addScaledVector(eye, this.depth);
    const t = plane.sub(from).dot(eye) / along.dot(eye);
    this.place = from.clone().addScaledVector(along, t);
    this.send();
  }

  private send(): void {
    if (!this.place) return;
    this.atDepth(this.depth);
    this.post({ kind: 'hand', place: [this.place.x, this.place.y, this.place.z] });
  }
}
