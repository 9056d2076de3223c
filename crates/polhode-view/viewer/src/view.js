// The view of one run: its frames, its state at the time shown, its bodies, its ground and its overlays.

import { Box3, Group, LineBasicMaterial, Sphere, Vector3 } from 'three';
import { ArrowScale } from './arrows.js';
import { Bodies } from './bodies.js';
import { SELECTED_COLOUR } from './colours.js';
import { Frames } from './frames.js';
import { Ground } from './ground.js';
import { Halos } from './halos.js';
import { instancedLines } from './instances.js';
import { Joints } from './joints.js';
import { quantile } from './numbers.js';
import { cubeEdges, placeBox } from './overlays/boxes.js';
import { OVERLAYS } from './overlays/index.js';
import { Snapshot } from './snapshot.js';

/** Radius in m of a body of which no bounding box is known. */
const UNKNOWN_RADIUS = 0.5;

/** How far the mark of the followed body stands off it, in radii of the body. */
const MARK_ROOM = 0.05;
/** Bodies times frames that are read at most to find the bounds of the motion, and the frames looked at in them. */
const MOST_CELLS_READ = 50000;
const MOTION_SAMPLES = 60;
/** A motion wider than so many radii of the start does not set the first camera. */
const WIDEST_MOTION = 4;

export class View {
  /**
   * `look` is { shadows, edges }; `tell` has requestDraw(), loaded() and broken(words); `scales` holds the scales of
   * arrows by name, one for all runs, so that arrows of two runs can be compared; eye() tells where the camera is.
   */
  constructor(run, geometries, look, tell, scales, eye) {
    this.eye = eye;
    this.scales = scales;
    this.run = run;
    this.geometries = geometries;
    this.look = look;
    this.requestDraw = tell.requestDraw;
    this.frames = new Frames(run, tell.loaded, tell.broken);
    this.snapshot = new Snapshot(run, this.frames);
    this.followed = null;
    this.group = new Group();
    this.overlays = new Map();
    this.radiusOf = (body) => radiusOfBox(run.bodies[body].box);
    const movers = run.moving.filter((body) => run.bodies[body].box);
    this.size = quantile(movers.map(this.radiusOf), 0.5) ?? UNKNOWN_RADIUS;
    this.selected = instancedLines(
      cubeEdges(),
      new LineBasicMaterial({ color: SELECTED_COLOUR, depthTest: false, transparent: true }),
      1,
    );
    this.selected.renderOrder = 5;
    this.selected.visible = false;
    const bounds = this.bounds();
    const reach = bounds.getBoundingSphere(new Sphere()).radius;
    this.ground = new Ground(run, Math.max(6 * reach, 12 * this.size), look.shadows);
    this.joints = new Joints(run);
    this.halos = new Halos(run, this.radiusOf);
    this.group.add(this.ground.group, this.selected, this.joints.group, this.halos.group);
    this.setGhost(false);
  }

  /** Draws the run as a ghost over another one, or as itself. */
  setGhost(ghost) {
    if (this.bodies) this.group.remove(this.bodies.group);
    this.bodies = new Bodies(this.run, this.geometries, { ...this.look, ghost });
    this.ground.group.visible = !ghost;
    this.joints.group.visible = !ghost;
    this.halos.group.visible = !ghost;
    this.group.add(this.bodies.group);
    this.update();
  }

  /** Moves to the time t; false while the frames are being unpacked. */
  moveTo(t, interpolate) {
    const there = this.snapshot.moveTo(t, interpolate);
    this.update();
    return there;
  }

  update() {
    // Overlays first, because some paint the bodies.
    for (const overlay of this.overlays.values()) if (overlay.on) overlay.part.update();
    this.bodies.update(this.snapshot, this.eye());
    this.joints.update(this.snapshot.poses);
    this.halos.update(this.snapshot);
    this.ground.update(this.snapshot);
    this.markFollowed();
  }

  markFollowed() {
    const box = this.run.bodies[this.followed]?.box;
    this.selected.visible = Boolean(box);
    if (!box) return;
    // A little larger than the body, so that its lines do not hide in the body's own edges.
    const room = MARK_ROOM * this.radiusOf(this.followed);
    const wider = [box[0].map((value) => value - room), box[1].map((value) => value + room)];
    placeBox(this.selected.instanceMatrix.array, 0, wider, this.snapshot.poses, this.followed);
    this.selected.instanceMatrix.needsUpdate = true;
  }

  /** Switches an overlay; it is built when it is first wanted. */
  setOverlay(name, on) {
    const kind = OVERLAYS.find((overlay) => overlay.name === name);
    if (kind.of_contacts && !this.run.contacts) return;
    if (!this.overlays.has(name)) {
      if (!on && name !== 'edges') return;
      const part = new kind.kind(this);
      this.group.add(part.group);
      this.overlays.set(name, { part, on: false });
    }
    const overlay = this.overlays.get(name);
    overlay.on = on;
    overlay.part.group.visible = on;
    if (on) overlay.part.update();
    else overlay.part.hidden?.();
  }

  /** The scale of a quantity's arrows, the longest of which is `longest` radii of a body. */
  scaleOf(quantity, longest) {
    if (!this.scales.has(quantity)) this.scales.set(quantity, new ArrowScale(longest * this.size, this.requestDraw));
    return this.scales.get(quantity);
  }

  legend() {
    const overlays = [...this.overlays.values()].filter(({ on }) => on).flatMap(({ part }) => part.legend());
    return [...overlays, ...this.halos.legend(this.followed, this.snapshot.time, SELECTED_COLOUR)];
  }

  applyTheme() {
    this.bodies.applyTheme();
    this.ground.applyTheme();
    this.update();
  }

  /** The box in the world of the bodies that move, or of all when none does; a metre where there is nothing. */
  bounds() {
    const { run } = this;
    const with_box = (list) => list.filter((body) => run.bodies[body].box);
    const movers = with_box(run.moving);
    const shown = movers.length > 0 ? movers : with_box(run.bodies.map((_, body) => body));
    const bounds = new Box3();
    for (const body of shown) {
      const place = new Vector3().fromArray(this.snapshot.poses, 7 * body);
      const radius = this.radiusOf(body);
      bounds.expandByPoint(place.clone().addScalar(radius)).expandByPoint(place.addScalar(-radius));
    }
    return bounds.isEmpty() ? new Box3(new Vector3(-0.5, -0.5, -0.5), new Vector3(0.5, 0.5, 0.5)) : bounds;
  }

  /**
   * The box of the whole motion, from some frames of it, or null where the run is so long that reading it would delay
   * the first picture, or so wide that the bodies would be too small in it.
   */
  async motionBounds() {
    const { run } = this;
    const start = this.bounds();
    if (run.times.length === 0 || run.moving.length * run.times.length > MOST_CELLS_READ) return null;
    const whole = start.clone();
    const bodies = run.moving.length;
    const take = (frame, values) => {
      for (let place = 0; place < bodies; place += 1) {
        const at = new Vector3(...[0, 1, 2].map((k) => values[k * bodies + place] * run.quanta[0]));
        const radius = this.radiusOf(run.moving[place]);
        whole.expandByPoint(at.clone().addScalar(radius)).expandByPoint(at.addScalar(-radius));
      }
    };
    const stride = Math.ceil(run.times.length / MOTION_SAMPLES);
    const places = run.moving.map((_, place) => place);
    await this.frames.scan(places, [0, 1, 2], stride, take, new AbortController().signal, () => {});
    const radius = (box) => box.getBoundingSphere(new Sphere()).radius;
    return radius(whole) <= WIDEST_MOTION * radius(start) ? whole : null;
  }

  placeOf(body) {
    return new Vector3(...this.snapshot.centreOf(body));
  }
}

/** The largest distance of a corner of a box in the body's frame from the body's place. */
function radiusOfBox(box) {
  if (!box) return UNKNOWN_RADIUS;
  return Math.hypot(...[0, 1, 2].map((k) => Math.max(Math.abs(box[0][k]), Math.abs(box[1][k]))));
}
