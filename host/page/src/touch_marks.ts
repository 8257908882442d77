// The hand on the object: an orange cube at the HIP, a blue ball at the proxy, a bar between them, an arrow for the force, and where the hand was.
import {
  Box2,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  GreaterDepth,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  type PerspectiveCamera,
  Quaternion,
  SphereGeometry,
  Vector2,
  Vector3,
} from 'three';
import type { Colours } from './messages';
import { length, type Tick, type Vector } from './rows';

const kTrail = 400; // places
export const kArrowMmPerN = 6;
const kHead = 2.4; // the length of the arrow's head, in radii
const kUp = new Vector3(0, 1, 0);
const kReach = 2.6; // of a sign round its place, in radii: the arrow's head is the largest
const place = new Vector3();
const corner = new Vector2();

const vector = (v: Vector): Vector3 => new Vector3(v.x, v.y, v.z);

/** One sign, drawn plainly, and faintly where the object hides it. */
class Sign {
  readonly group = new Group();
  private readonly materials: MeshBasicMaterial[] = [];
  constructor(geometry: BufferGeometry, colour: string) {
    for (const hidden of [false, true]) {
      const material = new MeshBasicMaterial({ color: colour });
      if (hidden) Object.assign(material, { depthFunc: GreaterDepth, depthWrite: false, transparent: true, opacity: 0.5 });
      const mesh = new Mesh(geometry, material);
      mesh.renderOrder = hidden ? 2 : 1;
      this.materials.push(material);
      this.group.add(mesh);
    }
  }
  colour(colour: string): void {
    for (const material of this.materials) material.color.set(colour);
  }
}

/** A bar of length 1 along y, from the origin. */
function bar(from: number, to: number): BufferGeometry {
  return new CylinderGeometry(to, from, 1, 12).translate(0, 0.5, 0);
}

export class TouchMarks {
  readonly group = new Group();
  /** Whether there is a tick to be seen. */
  known = false;
  private readonly hip: Sign;
  private readonly proxy: Sign;
  private readonly line: Sign;
  private readonly shaft: Sign;
  private readonly head: Sign;
  private readonly trail: Line;
  private readonly places = new Float32Array(3 * kTrail);
  private count = 0;
  private radius = 1;

  constructor(colours: Colours) {
    this.hip = new Sign(new BoxGeometry(1.7, 1.7, 1.7), colours.hip);
    this.proxy = new Sign(new SphereGeometry(1, 20, 14), colours.proxy);
    this.line = new Sign(bar(0.3, 0.3), colours.hip);
    this.shaft = new Sign(bar(0.35, 0.35), '#1b2026');
    this.head = new Sign(new ConeGeometry(1, kHead, 16).translate(0, kHead / 2, 0), '#1b2026');
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.places, 3));
    this.trail = new Line(geometry, new LineBasicMaterial({ color: colours.hip, transparent: true, opacity: 0.7 }));
    this.trail.frustumCulled = false;
    for (const sign of [this.hip, this.proxy, this.line, this.shaft, this.head]) this.group.add(sign.group);
    this.group.add(this.trail);
  }

  /** What the signs cover of the picture, in the eye's own coordinates, -1 to 1 from edge to edge; empty where there is nothing to be seen. */
  covers(eye: PerspectiveCamera, box: Box2): Box2 {
    box.makeEmpty();
    if (!this.known) return box;
    for (const sign of [this.hip, this.proxy, this.head]) this.cover(eye, box, place.copy(sign.group.position), kReach * this.radius);
    for (let i = 0; i < this.count; ++i) this.cover(eye, box, place.fromArray(this.places, 3 * i), 0);
    return box;
  }

  private cover(eye: PerspectiveCamera, box: Box2, at: Vector3, radius: number): void {
    const { x, y, z } = at.applyMatrix4(eye.matrixWorldInverse);
    const [wide, high] = [eye.projectionMatrix.elements[0] ?? 1, eye.projectionMatrix.elements[5] ?? 1];
    const away = Math.max(-z - radius, eye.near);
    box.expandByPoint(corner.set((wide * (x - radius)) / away, (high * (y - radius)) / away));
    box.expandByPoint(corner.set((wide * (x + radius)) / away, (high * (y + radius)) / away));
  }

  /** mm */
  size(radius: number): void {
    this.radius = radius;
    for (const sign of [this.hip, this.proxy]) sign.group.scale.setScalar(radius);
  }

  ink(colour: string): void {
    this.shaft.colour(colour);
    this.head.colour(colour);
  }

  clear(): void {
    this.count = 0;
    this.known = false;
  }

  setTrail(places: Vector[]): void {
    this.count = 0;
    for (const place of places.slice(-kTrail)) this.push(place);
  }

  push(place: Vector): void {
    if (this.count === kTrail) {
      this.places.copyWithin(0, 3);
      this.count -= 1;
    }
    this.places.set([place.x, place.y, place.z], 3 * this.count);
    this.count += 1;
  }

  show(tick: Tick): void {
    this.known = true;
    this.hip.group.position.copy(tick.hip);
    this.proxy.group.position.copy(tick.proxy);
    this.stretch(this.line, vector(tick.hip), vector(tick.proxy), tick.contact);
    const force = length(tick.force);
    const from = vector(tick.proxy);
    const along = vector(tick.force).multiplyScalar(kArrowMmPerN);
    const head = Math.min(kHead * this.radius, along.length()); // the whole arrow is as long as the legend says, and a short one is all head
    const neck = from.clone().add(along.clone().setLength(along.length() - head));
    this.stretch(this.shaft, from, neck, force > 0.01);
    this.head.group.visible = force > 0.01;
    this.head.group.position.copy(neck);
    this.head.group.scale.setScalar(head / kHead);
    if (force > 0) this.head.group.quaternion.setFromUnitVectors(kUp, along.normalize());
    const attribute = this.trail.geometry.getAttribute('position');
    attribute.needsUpdate = true;
    this.trail.geometry.setDrawRange(0, this.count);
    this.trail.visible = this.count > 1;
  }

  private stretch(sign: Sign, from: Vector3, to: Vector3, visible: boolean): void {
    const way = to.clone().sub(from);
    const far = way.length();
    sign.group.visible = visible && far > 1e-6;
    if (!sign.group.visible) return;
    sign.group.position.copy(from);
    sign.group.scale.set(this.radius, far, this.radius);
    sign.group.quaternion.copy(new Quaternion().setFromUnitVectors(kUp, way.normalize()));
  }
}
