// The picture: the bodies that run, the ghosts beside them, the spring of the hand, and the forces on a body.

import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Plane, Raycaster, Vector2, Vector3 } from 'three';
import { Arrows } from '../arrows.js';
import { Bodies, meshGeometry } from '../bodies.js';
import { Camera } from '../camera.js';
import { FORCE_COLOUR, JOINT_COLOUR, SELECTED_COLOUR, SPIN_COLOUR } from '../colours.js';
import { byId } from '../controls.js';
import { Dots } from '../dots.js';
import { boundsOf, framed, framedNow, radiusOf } from '../framing.js';
import { Ground } from '../ground.js';
import { PageError } from '../errors.js';
import { instancedLines } from '../instances.js';
import { Joints } from '../joints.js';
import { quantile } from '../numbers.js';
import { cubeEdges, placeBox } from '../overlays/boxes.js';
import { Scale } from '../scale.js';
import { centreAt } from '../snapshot.js';
import { drawnBySoftware, Stage } from '../stage.js';

/** With more bodies than this there are no shadows. */
const MANY_BODIES = 500;
/** How long the longest arrow of a force is, in radii of a body. */
const FORCE_RADII = 3;
/** A press that moves less than this many pixels is a click. */
const CLICK_PIXELS = 5;

/** The shape of a body as lines alone: where its truth is. */
class Outline {
  constructor(run, geometries) {
    this.bodies = new Bodies(run, geometries, { ghost: true, shadows: false, edges: true });
    this.group = this.bodies.group;
    for (const set of this.bodies.sets) {
      for (const { mesh } of [set.fine, set.coarse].filter(Boolean)) {
        // Of a smooth body, which has no sharp edges, its triangles are drawn.
        const smooth = set.lines === null;
        Object.assign(mesh.material, { wireframe: smooth, transparent: true, opacity: smooth ? 0.3 : 0.07, depthWrite: false });
        mesh.renderOrder = 3;
      }
      if (set.lines) Object.assign(set.lines.material, { opacity: 0.95, depthTest: false, transparent: true });
      if (set.lines) set.lines.renderOrder = 4;
    }
  }

  paint(text) {
    this.bodies.paint(() => text);
    for (const { lines } of this.bodies.sets) lines?.material.color.setStyle(text);
  }
}

export class Picture {
  /** `tell` has picked(body), grabbed(body, point), pulled(point), released(). */
  constructor(canvas, tell) {
    this.canvas = canvas;
    this.tell = tell;
    const slow = drawnBySoftware();
    try {
      this.stage = new Stage(canvas, { shadows: true, antialias: !slow });
    } catch {
      throw new PageError(
        'This browser draws no WebGL, so that the bodies cannot be shown. Turn on hardware acceleration, update the browser or ' +
          'take another one; or run the scene by the program: polhode view SCENE -o picture.png. The text stands beside.',
      );
    }
    this.camera = new Camera(this.stage, () => (this.dirty = true));
    this.group = new Group();
    this.stage.scene.add(this.group);
    this.dirty = true;
    this.run = null;
    this.ghosts = new Map();
    this.hand = [];
    this.why = null;
    this.selected = null;
    this.listen();
  }

  /** Shows another scene; the camera stays where the bodies are much the same. */
  show({ runs: [run], meshes, look, gravity }) {
    const before = this.run?.bodies.map(({ name }) => name).join('\n');
    const same = before === run.bodies.map(({ name }) => name).join('\n');
    this.run = run;
    this.geometries = meshes.map(meshGeometry);
    this.group.clear();
    this.ghosts.clear();
    const shadows = run.bodies.length <= MANY_BODIES;
    this.poses = Float64Array.from(run.initial);
    this.snapshot = { poses: this.poses, centreOf: (body) => centreAt(run.bodies[body], this.poses, 7 * body) };
    this.radii = run.bodies.map(radiusOf);
    const movers = run.moving.filter((body) => run.bodies[body].box);
    this.size = quantile(movers.map((body) => this.radii[body]), 0.5) ?? radiusOf({});
    this.bodies = new Bodies(run, this.geometries, { shadows, edges: true, ghost: false });
    this.ground = new Ground(run, boundsOf(framed(run, run.initial)), shadows);
    this.joints = new Joints(run, { ...look, shadows }, gravity);
    this.dots = new Dots(run, (body) => this.radii[body]);
    this.scale = new Scale(byId('scale'), look.axes, this.ground.holders.length > 0 ? this.ground.cell : null);
    this.frame = instancedLines(
      cubeEdges(),
      new LineBasicMaterial({ color: SELECTED_COLOUR, depthTest: false, transparent: true }),
      1,
    );
    this.frame.renderOrder = 5;
    this.pull = new Arrows(SPIN_COLOUR, 0.05 * this.size);
    this.forces = new Arrows(FORCE_COLOUR, 0.045 * this.size);
    const line = new BufferGeometry();
    line.setAttribute('position', new Float32BufferAttribute(new Float32Array(6), 3));
    this.line = new LineSegments(line, new LineBasicMaterial({ color: JOINT_COLOUR, depthTest: false, transparent: true }));
    this.line.frustumCulled = false;
    this.line.renderOrder = 8;
    this.group.add(this.ground.group, this.bodies.group, this.joints.group, this.dots.group, this.frame, this.pull.group, this.forces.group, this.line);
    if (this.selected !== null && this.selected >= run.bodies.length) this.selected = null;
    this.why = null;
    this.hand = [];
    this.strongest = 0;
    this.camera.home = run.frame;
    if (!same) this.fit('home');
    this.applyTheme();
  }

  /** Shows another copy of the scene as an outline of this colour; null takes it away. */
  setGhost(name, text) {
    const old = this.ghosts.get(name);
    if (old) this.group.remove(old.outline.group);
    this.ghosts.delete(name);
    this.dirty = true;
    if (!text || !this.run) return;
    const outline = new Outline(this.run, this.geometries);
    outline.paint(text);
    this.ghosts.set(name, { outline, poses: Float64Array.from(this.run.initial), text });
    this.group.add(outline.group);
  }

  /** All bodies in the picture, from where the camera stands or from a preset. */
  fit(name) {
    this.stage.resize();
    const points = name === 'home' ? framed(this.run, this.run.initial) : framedNow(this.run, this.poses);
    this.camera.look(name, points, [1, 1]);
    this.dirty = true;
  }

  applyTheme() {
    this.stage.applyTheme();
    if (!this.run) return;
    this.bodies.applyTheme();
    this.ground.applyTheme();
    for (const { outline, text } of this.ghosts.values()) outline.paint(text);
    this.dirty = true;
  }

  /** Where a press meets the picture, as a ray. */
  ray(event) {
    const frame = this.canvas.getBoundingClientRect();
    const at = new Vector2((2 * (event.clientX - frame.left)) / frame.width - 1, 1 - (2 * (event.clientY - frame.top)) / frame.height);
    const raycaster = new Raycaster();
    raycaster.setFromCamera(at, this.stage.camera);
    return raycaster;
  }

  listen() {
    const { canvas } = this;
    let press = null;
    // Before the camera sees it, so that a press on a body does not turn the picture.
    canvas.addEventListener(
      'pointerdown',
      (event) => {
        if (!this.run || event.button !== 0) return;
        const ray = this.ray(event);
        const hit = this.bodies.pick(ray);
        press = { x: event.clientX, y: event.clientY, hit, id: event.pointerId, plane: null };
        if (!hit || !this.run.bodies[hit.body].moves) return;
        event.stopImmediatePropagation();
        canvas.setPointerCapture(event.pointerId);
        press.point = ray.ray.at(hit.distance, new Vector3());
      },
      { capture: true },
    );
    canvas.addEventListener('pointermove', (event) => {
      if (!press?.point || event.pointerId !== press.id) return;
      const far = Math.hypot(event.clientX - press.x, event.clientY - press.y) > CLICK_PIXELS;
      if (!press.plane && far) {
        const towards = this.stage.camera.getWorldDirection(new Vector3());
        press.plane = new Plane().setFromNormalAndCoplanarPoint(towards, press.point);
        this.tell.grabbed(press.hit.body, press.point.toArray());
      }
      const place = press.plane && this.ray(event).ray.intersectPlane(press.plane, new Vector3());
      if (place) this.tell.pulled(place.toArray());
    });
    const up = (event) => {
      if (!press || event.pointerId !== press.id) return;
      if (press.plane) this.tell.released();
      else if (Math.hypot(event.clientX - press.x, event.clientY - press.y) <= CLICK_PIXELS) this.tell.picked(press.hit?.body ?? null);
      press = null;
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener('webglcontextrestored', () => (this.dirty = true));
  }

  select(body) {
    this.selected = body;
    this.dirty = true;
  }

  /** The spring of the hand: [hand, held point, force], or an empty list. */
  setHand(numbers) {
    this.hand = numbers;
    this.dirty = true;
  }

  /** The forces on a body: [{ point, force }], or null. */
  setForces(list) {
    this.why = list;
    this.dirty = true;
  }

  draw() {
    if (this.stage.resize()) this.dirty = true;
    if (!this.dirty || !this.run) return;
    this.dirty = false;
    this.bodies.update(this.snapshot, this.stage.eye());
    this.joints.update(this.poses);
    this.dots.update(this.snapshot, this.stage.eye());
    this.ground.update(this.snapshot);
    for (const { outline, poses } of this.ghosts.values()) outline.bodies.update({ poses }, this.stage.eye());
    const box = this.run.bodies[this.selected]?.box;
    this.frame.visible = Boolean(box);
    if (box) {
      placeBox(this.frame.instanceMatrix.array, 0, box, this.poses, this.selected);
      this.frame.instanceMatrix.needsUpdate = true;
    }
    this.drawHand();
    this.drawForces();
    this.stage.draw([[this.group]], this.camera.target, 'row');
    const distance = this.stage.camera.position.distanceTo(this.camera.target);
    this.scale.draw(this.stage.camera, this.stage.eye().pixels / distance);
  }

  drawHand() {
    const { hand } = this;
    this.line.visible = hand.length > 0;
    this.pull.clear();
    if (hand.length > 0) {
      const places = this.line.geometry.getAttribute('position');
      places.setXYZ(0, hand[0], hand[1], hand[2]);
      places.setXYZ(1, hand[3], hand[4], hand[5]);
      places.needsUpdate = true;
      const force = hand.slice(6);
      const size = Math.hypot(...force);
      this.strongest = Math.max(this.strongest, size);
      this.pull.add(hand.slice(3, 6), force, (FORCE_RADII * this.size) / this.strongest);
    }
    this.pull.show();
  }

  drawForces() {
    this.forces.clear();
    const list = this.why ?? [];
    const largest = Math.max(0, ...list.map(({ force }) => Math.hypot(...force)));
    for (const { point, force } of list) {
      const factor = (FORCE_RADII * this.size) / largest;
      const start = point.map((value, k) => value - force[k] * factor);
      // What presses on a body ends where it touches it; weight begins at the centre of mass.
      this.forces.add(list[0].point === point ? point : start, force, factor);
    }
    this.forces.show();
  }

}
