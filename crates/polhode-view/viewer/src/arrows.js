// A field of arrows of one colour, drawn by two instanced calls, and the scale that makes their lengths readable.

import {
  ConeGeometry,
  CylinderGeometry,
  DynamicDrawUsage,
  Group,
  InstancedBufferAttribute,
  MeshBasicMaterial,
} from 'three';
import { instancedMesh, writeMatrix } from './instances.js';
import { roundedUp } from './numbers.js';

/** Sides of a shaft and of a head. */
const SIDES = 8;
/** Head of an arrow: its radius in radii of the shaft, its length in radii of the shaft, and its largest share. */
const HEAD_RADIUS = 2.8;
const HEAD_LENGTH = 7;
const HEAD_SHARE = 0.45;
/** Arrows that a field can hold at first; it doubles when it is full. */
const FIRST_CAPACITY = 64;

/** A shape along z from 0 to 1 with radius 1. */
function alongZ(geometry) {
  return geometry.rotateX(Math.PI / 2).translate(0, 0, 0.5);
}

export class Arrows {
  /** `radius` of the shafts in m. */
  constructor(colour, radius) {
    this.radius = radius;
    this.group = new Group();
    // Arrows stand in and between bodies, and must be seen there: nothing hides them.
    const material = new MeshBasicMaterial({ color: colour, depthTest: false, depthWrite: false, transparent: true });
    this.shafts = instancedMesh(alongZ(new CylinderGeometry(1, 1, 1, SIDES)), material, 0);
    this.heads = instancedMesh(alongZ(new ConeGeometry(1, 1, SIDES)), material, 0);
    this.shafts.renderOrder = this.heads.renderOrder = 10;
    this.group.add(this.shafts, this.heads);
    this.count = 0;
    this.capacity = 0;
    this.grow(FIRST_CAPACITY);
  }

  grow(capacity) {
    for (const mesh of [this.shafts, this.heads]) {
      const wider = new Float32Array(16 * capacity);
      wider.set(mesh.instanceMatrix.array.subarray(0, 16 * this.count));
      mesh.dispose();
      mesh.instanceMatrix = new InstancedBufferAttribute(wider, 16);
      mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    }
    this.capacity = capacity;
  }

  clear() {
    this.count = 0;
  }

  /** An arrow from `origin` along the vector `v` times `factor`, in m; one of no length is left out. */
  add(origin, v, factor) {
    const size = Math.hypot(v[0], v[1], v[2]);
    const length = size * factor;
    if (!(length > 0) || !Number.isFinite(length)) return;
    if (this.count === this.capacity) this.grow(2 * this.capacity);
    const w = [v[0] / size, v[1] / size, v[2] / size];
    const [u, side] = crossAxes(w);
    const head = Math.min(HEAD_LENGTH * this.radius, HEAD_SHARE * length);
    const wide = Math.min(HEAD_RADIUS * this.radius, head / 2);
    const shaft = Math.min(this.radius, wide / 2);
    const neck = [0, 1, 2].map((k) => origin[k] + w[k] * (length - head));
    const scaled = (axis, factor) => [axis[0] * factor, axis[1] * factor, axis[2] * factor];
    const { count } = this;
    writeMatrix(
      this.shafts.instanceMatrix.array,
      count,
      scaled(u, shaft),
      scaled(side, shaft),
      scaled(w, length - head),
      origin,
    );
    writeMatrix(this.heads.instanceMatrix.array, count, scaled(u, wide), scaled(side, wide), scaled(w, head), neck);
    this.count += 1;
  }

  /** Hands the arrows added since `clear` to the renderer. */
  show() {
    for (const mesh of [this.shafts, this.heads]) {
      mesh.count = this.count;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }
}

/** Two unit vectors square to the unit vector w and to each other, u x v = w (Duff et al. 2017). */
export function crossAxes(w) {
  const sign = w[2] >= 0 ? 1 : -1;
  const a = -1 / (sign + w[2]);
  const b = w[0] * w[1] * a;
  return [
    [1 + sign * w[0] * w[0] * a, sign * b, -sign * w[0]],
    [b, sign + w[1] * w[1] * a, -w[1]],
  ];
}

/** Lengths of arrows: the largest value met so far, rounded up to 1, 2 or 5, is `longest` m long. */
export class ArrowScale {
  /** `grown` is called when the scale changes, since arrows drawn before are then too long. */
  constructor(longest, grown) {
    this.longest = longest;
    this.largest = 0;
    this.grown = grown;
  }

  see(value) {
    if (!Number.isFinite(value) || value <= this.largest) return;
    const full = this.full;
    this.largest = value;
    if (this.full !== full) this.grown();
  }

  get full() {
    return roundedUp(this.largest);
  }

  /** Metres for one unit of the value. */
  get factor() {
    return this.longest / this.full;
  }
}
