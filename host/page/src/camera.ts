// The eye: it walks round the object, by mouse, by touch and by keys.
import { PerspectiveCamera, Vector3 } from 'three';

const kTurn = 0.0087; // radians a pixel
const kKeyTurn = (6 * Math.PI) / 180;
const kNearer = 0.9;
const kKeyShift = 0.05; // of the height of the picture
const kSteepest = (89 * Math.PI) / 180;

export class Orbit {
  readonly camera = new PerspectiveCamera(30, 1, 1, 5000);
  private azimuth = (35 * Math.PI) / 180;
  private elevation = (20 * Math.PI) / 180;
  private distance = 200; // mm
  private readonly target = new Vector3();
  private readonly pointers = new Map<number, { x: number; y: number }>(); // that hold the picture
  private home = { distance: 200, target: new Vector3() };

  constructor(private readonly changed: () => void) {}

  /** Sees a ball of this radius round this place. */
  frame(middle: Vector3, radius: number): void {
    this.home = { distance: (1.08 * radius) / Math.sin(((this.camera.fov / 2) * Math.PI) / 180), target: middle.clone() };
    this.camera.near = radius / 50;
    this.camera.far = 60 * radius;
    this.reset();
  }

  reset(): void {
    this.azimuth = (35 * Math.PI) / 180;
    this.elevation = (20 * Math.PI) / 180;
    this.distance = this.home.distance;
    this.target.copy(this.home.target);
    this.place();
  }

  turn(right: number, up: number): void {
    this.azimuth -= right;
    this.elevation = Math.max(-kSteepest, Math.min(kSteepest, this.elevation + up));
    this.place();
  }

  zoom(factor: number): void {
    this.distance = Math.max(0.2 * this.home.distance, Math.min(6 * this.home.distance, this.distance * factor));
    this.place();
  }

  /** Moves what is looked at across the picture, mm. */
  shift(right: number, up: number): void {
    const across = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right);
    this.target.add(across).add(new Vector3().setFromMatrixColumn(this.camera.matrix, 1).multiplyScalar(up));
    this.place();
  }

  /** Moves the object across the picture by a key's step. */
  step(right: number, up: number): void {
    const height = 2 * this.distance * Math.tan(((this.camera.fov / 2) * Math.PI) / 180); // mm, at the object
    this.shift(-right * kKeyShift * height, -up * kKeyShift * height);
  }

  aspect(ratio: number): void {
    this.camera.aspect = ratio;
    this.camera.updateProjectionMatrix();
  }

  /** Unit, from the object to the eye. */
  towardsEye(): Vector3 {
    return this.camera.position.clone().sub(this.target).normalize();
  }

  get middle(): Vector3 {
    return this.home.target;
  }

  private place(): void {
    const flat = Math.cos(this.elevation);
    this.camera.position
      .set(flat * Math.sin(this.azimuth), Math.sin(this.elevation), flat * Math.cos(this.azimuth))
      .multiplyScalar(this.distance)
      .add(this.target);
    this.camera.lookAt(this.target);
    this.camera.updateMatrix();
    this.camera.updateMatrixWorld();
    this.camera.updateProjectionMatrix();
    this.changed();
  }

  /** Whether two fingers hold the picture. */
  get pinched(): boolean {
    return this.pointers.size > 1;
  }

  /** While `taken`, one finger, the pointer and the wheel move something else. Two fingers always zoom, and the right button turns. */
  listen(canvas: HTMLCanvasElement, taken: () => boolean): void {
    const pointers = this.pointers;
    let spread = 0;
    canvas.addEventListener('pointerdown', (event) => {
      if (taken() && event.button !== 2 && event.pointerType !== 'touch') return;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      canvas.setPointerCapture(event.pointerId);
      spread = 0;
    });
    const gone = (event: PointerEvent): void => {
      pointers.delete(event.pointerId);
      spread = 0;
    };
    canvas.addEventListener('pointerup', gone);
    canvas.addEventListener('pointercancel', gone);
    canvas.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before || (taken() && (event.buttons & 2) === 0 && pointers.size < 2)) return;
      const x = event.clientX - before.x;
      const y = event.clientY - before.y;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (pointers.size === 2) {
        const [a, b] = [...pointers.values()] as [{ x: number; y: number }, { x: number; y: number }];
        const now = Math.hypot(a.x - b.x, a.y - b.y);
        if (spread > 0 && now > 0) this.zoom(spread / now);
        spread = now;
      } else if (((event.buttons & 2) !== 0 && !taken()) || event.shiftKey) {
        const mm = (2 * this.distance * Math.tan(((this.camera.fov / 2) * Math.PI) / 180)) / canvas.clientHeight;
        this.shift(-x * mm, y * mm);
      } else {
        this.turn(x * kTurn, y * kTurn);
      }
    });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener(
      'wheel',
      (event) => {
        if (taken()) return;
        event.preventDefault();
        this.zoom(Math.exp(event.deltaY * 0.001));
      },
      { passive: false },
    );
  }

  /** Whether the key was one of the eye's. */
  key(key: string): boolean {
    switch (key) {
      case 'ArrowLeft':
        this.turn(kKeyTurn, 0);
        return true;
      case 'ArrowRight':
        this.turn(-kKeyTurn, 0);
        return true;
      case 'ArrowUp':
        this.turn(0, kKeyTurn);
        return true;
      case 'ArrowDown':
        this.turn(0, -kKeyTurn);
        return true;
      case '+':
      case '=':
        this.zoom(kNearer);
        return true;
      case '-':
        this.zoom(1 / kNearer);
        return true;
      case 'Home':
        this.reset();
        return true;
      default:
        return false;
    }
  }
}
