// The estimated errors of bodies: a halo around each whose error is seen, its box and as far as any point of it may be
// off, and the words about one body.

import { BoxGeometry, Group, MeshBasicMaterial } from 'three';
import { HALO_COLOUR } from './colours.js';
import { instancedMesh } from './instances.js';
import { short } from './numbers.js';
import { placeBox } from './overlays/boxes.js';

/** The error in radii of a body from which it has a halo: about a line's width in a picture of the body. */
const SEEN = 0.02;

/** The place of the last time that is not after t, or of the first one. */
function placeAt(times, t) {
  let place = 0;
  while (place + 1 < times.length && times[place + 1] <= t) place += 1;
  return place;
}

export class Halos {
  constructor(run, radiusOf) {
    this.run = run;
    this.radiusOf = radiusOf;
    this.group = new Group();
    if (!run.errors) return;
    const material = new MeshBasicMaterial({
      color: HALO_COLOUR,
      transparent: true,
      opacity: 0.22,
      depthWrite: false,
    });
    this.mesh = instancedMesh(new BoxGeometry(1, 1, 1), material, run.moving.length);
    this.mesh.raycast = () => {};
    this.group.add(this.mesh);
  }

  /** The error of a moving body at the time t: { m, rad }, or null where none is known. */
  errorOf(body, t) {
    const { errors, moving } = this.run;
    const place = moving.indexOf(body);
    if (!errors || place < 0) return null;
    const at = 2 * (placeAt(errors.times, t) * moving.length + place);
    const [m, rad] = [errors.values[at], errors.values[at + 1]];
    return Number.isFinite(m) && Number.isFinite(rad) ? { m, rad } : null;
  }

  update(snapshot) {
    if (!this.mesh) return;
    const { errors, moving } = this.run;
    const first = 2 * moving.length * placeAt(errors.times, snapshot.time);
    let count = 0;
    moving.forEach((body, place) => {
      const radius = this.radiusOf(body);
      const error = errors.values[first + 2 * place] + errors.values[first + 2 * place + 1] * radius;
      const { box } = this.run.bodies[body];
      // What is not known is not drawn.
      if (!box || !(error > SEEN * radius)) return;
      const wider = [box[0].map((value) => value - error), box[1].map((value) => value + error)];
      placeBox(this.mesh.instanceMatrix.array, count, wider, snapshot.poses, body);
      count += 1;
    });
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  /** Lines for the key of colours: the halos that are drawn, and the error of the body that is followed. */
  legend(followed, t, ink) {
    const lines = [];
    if (this.mesh?.count > 0) lines.push({ colour: HALO_COLOUR, text: 'as far as a body may be off (estimated error)' });
    const error = followed === null ? null : this.errorOf(followed, t);
    if (error) {
      const { name } = this.run.bodies[followed];
      lines.push({ colour: ink, text: `${name}: estimated error ${short(error.m, 3)} m, ${short(error.rad, 3)} rad` });
    }
    return lines;
  }
}
