// Points, lines and triangles whose number changes from frame to frame.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from 'three';

/** Numbers that a buffer can hold at first; it doubles when it is full. */
const FIRST_CAPACITY = 3 * 256;

export class GrowingGeometry {
  constructor() {
    this.geometry = new BufferGeometry();
    this.used = 0;
    this.replace(new Float32Array(FIRST_CAPACITY));
  }

  replace(array) {
    this.geometry.dispose();
    this.array = array;
    this.geometry.setAttribute('position', new BufferAttribute(array, 3).setUsage(DynamicDrawUsage));
  }

  clear() {
    this.used = 0;
  }

  add(x, y, z) {
    if (this.used + 3 > this.array.length) {
      const wider = new Float32Array(2 * this.array.length);
      wider.set(this.array);
      this.replace(wider);
    }
    this.array[this.used] = x;
    this.array[this.used + 1] = y;
    this.array[this.used + 2] = z;
    this.used += 3;
  }

  /** Hands the points added since `clear` to the renderer. */
  show() {
    this.geometry.setDrawRange(0, this.used / 3);
    this.geometry.getAttribute('position').needsUpdate = true;
  }
}
