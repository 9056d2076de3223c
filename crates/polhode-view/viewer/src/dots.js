// A dot for each body that moves and is too small in the picture to be seen.

import { BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Group, Points, PointsMaterial } from 'three';

/** Size of a dot in pixels, and bodies of which dots are drawn at the most: of more one sees a crowd. */
const DOT = 7;
const MOST_DOTS = 64;

/** Below this radius in pixels a body has a dot. */
const SEEN = 3;

export class Dots {
  constructor(run, radiusOf) {
    this.radiusOf = radiusOf;
    this.group = new Group();
    this.bodies = run.moving.filter((body) => run.bodies[body].opacity > 0);
    if (this.bodies.length === 0 || this.bodies.length > MOST_DOTS) return;
    this.inks = this.bodies.map((body) => new Color(run.bodies[body].colour).toArray());
    const numbers = () => new BufferAttribute(new Float32Array(3 * this.bodies.length), 3).setUsage(DynamicDrawUsage);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', numbers());
    this.geometry.setAttribute('color', numbers());
    const size = DOT * Math.min(2, devicePixelRatio);
    const dots = new Points(this.geometry, new PointsMaterial({ size, sizeAttenuation: false, vertexColors: true }));
    dots.frustumCulled = false;
    dots.raycast = () => {};
    this.group.add(dots);
  }

  /** `eye` is { place, pixels } of the camera. */
  update(snapshot, { place, pixels }) {
    if (!this.geometry) return;
    const [places, colours] = ['position', 'color'].map((name) => this.geometry.getAttribute(name));
    let count = 0;
    this.bodies.forEach((body, index) => {
      const centre = snapshot.centreOf(body);
      const distance = Math.hypot(centre[0] - place.x, centre[1] - place.y, centre[2] - place.z);
      if (!(this.radiusOf(body) * pixels < SEEN * distance)) return;
      places.setXYZ(count, ...centre);
      colours.setXYZ(count, ...this.inks[index]);
      count += 1;
    });
    this.geometry.setDrawRange(0, count);
    places.needsUpdate = colours.needsUpdate = true;
  }
}
