// The view of one run: its frames, its state at the time shown, its bodies, its ground and its overlays.

import { Group, LineBasicMaterial, Vector3 } from 'three';
import { ArrowScale } from './arrows.js';
import { Bodies } from './bodies.js';
import { SELECTED_COLOUR } from './colours.js';
import { Dots } from './dots.js';
import { boundsOf, framed, framedNow, radiusOf } from './framing.js';
import { Frames } from './frames.js';
import { Ground } from './ground.js';
import { Halos } from './halos.js';
import { instancedLines } from './instances.js';
import { Joints } from './joints.js';
import { quantile } from './numbers.js';
import { cubeEdges, placeBox } from './overlays/boxes.js';
import { OVERLAYS } from './overlays/index.js';
import { Snapshot } from './snapshot.js';

/** How far the mark of the followed body stands off it, in radii of the body. */
const MARK_ROOM = 0.05;
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
    this.radiusOf = (body) => radiusOf(run.bodies[body]);
    const movers = run.moving.filter((body) => run.bodies[body].box);
    this.size = quantile(movers.map(this.radiusOf), 0.5) ?? radiusOf({});
    this.selected = instancedLines(
      cubeEdges(),
      new LineBasicMaterial({ color: SELECTED_COLOUR, depthTest: false, transparent: true }),
      1,
    );
    this.selected.renderOrder = 5;
    this.selected.visible = false;
    this.ground = new Ground(run, boundsOf(this.framed()), look.shadows);
    this.joints = new Joints(run, look, look.gravity);
    this.halos = new Halos(run, this.radiusOf);
    this.dots = new Dots(run, this.radiusOf);
    this.group.add(this.dots.group, this.ground.group, this.selected, this.joints.group, this.halos.group);
    this.setGhost(false);
  }

  /** Draws the run as a ghost over another one, or as itself. */
  setGhost(ghost) {
    if (this.bodies) this.group.remove(this.bodies.group);
    this.bodies = new Bodies(this.run, this.geometries, { ...this.look, ghost });
    this.ground.group.visible = !ghost;
    this.joints.group.visible = !ghost;
    this.halos.group.visible = !ghost;
    this.dots.group.visible = !ghost;
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
    this.dots.update(this.snapshot, this.eye());
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

  /** The points that the first picture holds. */
  framed() {
    return framed(this.run, this.snapshot.poses);
  }

  /** The points that a picture of now holds. */
  framedNow() {
    return framedNow(this.run, this.snapshot.poses);
  }

  placeOf(body) {
    return new Vector3(...this.snapshot.centreOf(body));
  }
}
