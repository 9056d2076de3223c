// Poinsot's construction for the followed body: polhode, herpolhode, inertia ellipsoid and invariable plane.
//
// The tip of the angular velocity w moves on the inertia ellipsoid w·Iw = 2T, fixed in the body: its path there is the
// polhode. In the world the tip moves in the invariable plane L·w = 2T, square to the angular momentum L at the
// distance 2T/|L| from the centre: its path there is the herpolhode. In free rotation the ellipsoid rolls on the plane
// without slipping. All is drawn at the centre of mass, scaled so that the ellipsoid is a little larger than the body.
// Source: Goldstein, Classical Mechanics, section 5.6.

import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  DoubleSide,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
  WireframeGeometry,
} from 'three';
import { Arrows } from '../arrows.js';
import { MOMENTUM_COLOUR, SPIN_COLOUR } from '../colours.js';
import { angularMomentum, inPrincipalFrame, spinEnergy } from '../inertia.js';
import { normalise } from '../rotation.js';

/** The longest semi-axis of the ellipsoid in radii of the body. */
const ELLIPSOID_SIZE = 1.25;
/** The radius of the drawn part of the invariable plane in longest semi-axes of the ellipsoid. */
const PLANE_SIZE = 1.2;
/** Points of a curve at most. */
const MOST_POINTS = 20000;
/** Orientation and angular velocity in the channels of a chunk. */
const CHANNELS_READ = [3, 4, 5, 6, 10, 11, 12];

/** The shaft of the arrow to the tip of the angular velocity in radii of the body. */
const SHAFT = 0.02;

const HERPOLHODE_COLOUR = MOMENTUM_COLOUR;

/** A curve of which the part up to now is strong and the rest is faint. */
class Curve {
  constructor(colour, count) {
    this.positions = new BufferAttribute(new Float32Array(3 * count), 3);
    const line = (opacity) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', this.positions);
      geometry.setDrawRange(0, 0);
      const material = new LineBasicMaterial({ color: colour, transparent: true, opacity, depthTest: false });
      const drawn = new Line(geometry, material);
      drawn.frustumCulled = false;
      drawn.renderOrder = 6;
      return drawn;
    };
    this.past = line(1);
    this.all = line(0.3);
    this.group = new Group();
    this.group.add(this.all, this.past);
  }

  set(index, point) {
    this.positions.setXYZ(index, ...point);
  }

  show(past, all) {
    this.past.geometry.setDrawRange(0, past);
    this.all.geometry.setDrawRange(0, all);
    this.positions.needsUpdate = true;
  }
}

export class Polhode {
  constructor(view) {
    this.view = view;
    this.group = new Group();
    this.body = null;
    this.scan = null;
  }

  /** The followed body, or the one that spins fastest when none is followed. */
  chosenBody() {
    const { run, snapshot, followed } = this.view;
    const known = (body) => run.bodies[body].principal_inertia !== null && snapshot.place_of.has(body);
    if (followed !== null) return followed < run.bodies.length && known(followed) ? followed : null;
    if (this.body !== null) return this.body;
    const spin = (body) => Math.hypot(...snapshot.rates.subarray(6 * body + 3, 6 * body + 6));
    return run.moving
      .filter(known)
      .reduce((best, body) => (best === null || spin(body) > spin(best) ? body : best), null);
  }

  update() {
    const body = this.chosenBody();
    if (body !== this.body) this.choose(body);
    if (this.body === null || !this.polhode) return;
    const { run, snapshot } = this.view;
    const data = run.bodies[body];
    const at = 7 * body;
    const pose = snapshot.poses.subarray(at, at + 7);
    const centre = snapshot.centreOf(body);
    this.construction.position.set(...centre);
    const [w, x, y, z] = data.principal_axes;
    this.in_body.quaternion.set(pose[4], pose[5], pose[6], pose[3]).multiply(new Quaternion(-x, -y, -z, w));
    this.construction.scale.setScalar(this.scale || 1);
    const past = Math.min(this.count, Math.floor(snapshot.frame / this.stride) + 1);
    this.polhode.show(past, this.count);
    this.herpolhode.show(past, this.count);
    const spin = snapshot.rates.subarray(6 * body + 3, 6 * body + 6);
    this.placeEllipsoid(data, spin, at);
    this.vector.clear();
    this.vector.add(centre, spin, this.scale);
    this.vector.show();
  }

  /** Ellipsoid and plane of the energy and the momentum of this moment. */
  placeEllipsoid(data, spin, at) {
    const { poses } = this.view.snapshot;
    const energy = spinEnergy(data, inPrincipalFrame(data, poses, at + 3, spin));
    const axes = data.principal_inertia.map((moment) => Math.sqrt((2 * energy) / moment));
    const turns = energy > 0 && axes.every(Number.isFinite);
    this.ellipsoid.visible = this.plane.visible = turns;
    if (!turns) return;
    this.ellipsoid.scale.set(...axes);
    const momentum = new Vector3(...angularMomentum(data, poses, at + 3, spin));
    const size = momentum.length();
    momentum.divideScalar(size);
    this.plane.position.copy(momentum).multiplyScalar((2 * energy) / size);
    this.plane.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), momentum);
    this.plane.scale.setScalar(PLANE_SIZE * Math.max(...axes));
  }

  /** Begins the curves of a body; they grow while its frames are read. */
  choose(body) {
    this.scan?.abort();
    this.group.clear();
    this.body = body;
    this.polhode = this.herpolhode = null;
    if (body === null) return;
    const { run } = this.view;
    this.stride = Math.ceil(run.times.length / MOST_POINTS);
    const points = Math.ceil(run.times.length / this.stride);
    this.polhode = new Curve(SPIN_COLOUR, points);
    this.herpolhode = new Curve(HERPOLHODE_COLOUR, points);
    this.count = 0;
    this.scale = 0;
    this.in_body = new Group();
    this.makeEllipsoid();
    this.in_body.add(this.polhode.group, this.ellipsoid);
    this.construction = new Group();
    this.construction.add(this.in_body, this.herpolhode.group, this.plane);
    this.group.add(this.construction, this.vector.group);
    this.scan = new AbortController();
    this.readCurves(run.bodies[body], run.moving.indexOf(body), this.scan.signal);
  }

  makeEllipsoid() {
    const sphere = new SphereGeometry(1, 32, 20);
    const look = { transparent: true, depthWrite: false };
    const shell = new Mesh(sphere, new MeshBasicMaterial({ ...look, color: SPIN_COLOUR, opacity: 0.14 }));
    const net = new LineSegments(
      new WireframeGeometry(new SphereGeometry(1, 16, 10)),
      new LineBasicMaterial({ ...look, color: SPIN_COLOUR, opacity: 0.13 }),
    );
    this.ellipsoid = new Group();
    this.ellipsoid.add(shell, net);
    this.vector = new Arrows(SPIN_COLOUR, SHAFT * this.view.radiusOf(this.body));
    this.plane = new Mesh(
      new CircleGeometry(1, 64),
      new MeshBasicMaterial({ ...look, color: HERPOLHODE_COLOUR, opacity: 0.13, side: DoubleSide }),
    );
  }

  async readCurves(data, place, signal) {
    const { run, frames, radiusOf, requestDraw } = this.view;
    const [, unit, , spin_unit] = run.quanta;
    let longest = 0;
    const take = (frame, values) => {
      const turned = Float64Array.from(values.subarray(0, 4), (value) => value * unit);
      normalise(turned, 0);
      const spin = Array.from(values.subarray(4), (value) => value * spin_unit);
      const inside = inPrincipalFrame(data, turned, 0, spin);
      const energy = spinEnergy(data, inside);
      longest = Math.max(longest, ...data.principal_inertia.map((moment) => Math.sqrt((2 * energy) / moment)));
      this.polhode.set(this.count, inside);
      this.herpolhode.set(this.count, spin);
      this.count += 1;
      if (longest > 0) this.scale = (ELLIPSOID_SIZE * radiusOf(this.body)) / longest;
    };
    await frames.scan([place], CHANNELS_READ, this.stride, take, signal, requestDraw);
  }

  legend() {
    const { run } = this.view;
    if (this.body === null) return [{ colour: SPIN_COLOUR, text: 'polhode: this body does not turn freely' }];
    return [
      { colour: SPIN_COLOUR, text: `polhode on the inertia ellipsoid of ${run.bodies[this.body].name}` },
      { colour: HERPOLHODE_COLOUR, text: 'herpolhode on the invariable plane' },
    ];
  }
}
