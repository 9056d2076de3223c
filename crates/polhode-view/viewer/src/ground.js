// Half-spaces: a grid that fades towards its rim, a faint plane, and the shadows that fall on it.

import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  RingGeometry,
  ShadowMaterial,
  Vector3,
} from 'three';
import { roundedDown } from './numbers.js';
import { colour } from './theme.js';

/** Size of a cell in sizes of what is shown, before it is rounded; where the ground begins to fade and where it has faded. */
const SPACING = 0.25;
const FADING = [1.5, 6];
/** How dark a shadow is: pictures have less than half of the light there, which is a third darker on a screen. */
const SHADOW = 0.33;
/** Pieces of a grid line between its middle and its rim, and rings of the ground, each with its own share of fading. */
const PIECES = 24;

/** The share of ink at a distance from the middle, in sizes of what is shown. */
function fading(distance) {
  return Math.min(1, Math.max(0, 1 - (distance - FADING[0]) / (FADING[1] - FADING[0])));
}

/** Lines every `cell`, about a place (x, y) of the plane that lies on two of them. */
function gridLines(cell, size) {
  const rim = FADING[1] * size;
  const cells = Math.ceil(rim / cell);
  const positions = [];
  const colours = [];
  const point = (x, y) => {
    positions.push(x, y, 0);
    colours.push(1, 1, 1, 0.7 * fading(Math.hypot(x, y) / size));
  };
  for (let line = -cells; line <= cells; line += 1) {
    const across = line * cell;
    for (let piece = -PIECES; piece < PIECES; piece += 1) {
      const from = (piece / PIECES) * rim;
      const to = ((piece + 1) / PIECES) * rim;
      point(across, from);
      point(across, to);
      point(from, across);
      point(to, across);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 4));
  return geometry;
}

/** A disc whose ink fades towards its rim. */
function fadingDisc(size) {
  const geometry = new RingGeometry(0, FADING[1] * size, 64, PIECES);
  const places = geometry.getAttribute('position');
  const colours = new Float32Array(4 * places.count).fill(1);
  for (let vertex = 0; vertex < places.count; vertex += 1) {
    colours[4 * vertex + 3] = fading(Math.hypot(places.getX(vertex), places.getY(vertex)) / size);
  }
  geometry.setAttribute('color', new BufferAttribute(colours, 4));
  return geometry;
}

export class Ground {
  /** The half-spaces of all bodies of a run under what lies in a box (two corners, m), or so far (m) about the origin. */
  constructor(run, held, shadows) {
    const about = (reach) => [-1, 1].map((side) => Array(3).fill((side * reach) / (FADING[1] * Math.sqrt(12))));
    const [low, high] = typeof held === 'number' ? about(held) : held;
    this.group = new Group();
    this.holders = [];
    this.size = Math.hypot(...high.map((value, k) => value - low[k])) || 1;
    this.middle = new Vector3(...high.map((value, k) => (value + low[k]) / 2));
    this.cell = roundedDown(SPACING * this.size);
    const look = { vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide };
    this.ink = new LineBasicMaterial(look);
    this.wash = new MeshBasicMaterial(look);
    this.shade = shadows ? new ShadowMaterial({ opacity: SHADOW, depthWrite: false }) : null;
    run.bodies.forEach((body, index) => {
      if (body.half_spaces.length === 0) return;
      const holder = new Group();
      if (body.opacity === 0) return;
      const pose = run.initial.subarray(7 * index, 7 * index + 7);
      for (const half_space of body.half_spaces) holder.add(this.plane(half_space, pose));
      this.holders.push({ body: index, holder });
      this.group.add(holder);
    });
    this.applyTheme();
  }

  plane({ normal, offset_m }, pose) {
    const plane = new Group();
    const direction = new Vector3(...normal).normalize();
    plane.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), direction));
    plane.position.copy(direction).multiplyScalar(offset_m);
    // Below the middle of what is shown, moved by whole cells, so that lines stand at round places.
    const turned = new Quaternion(pose[4], pose[5], pose[6], pose[3]);
    const middle = this.middle.clone().sub(new Vector3(pose[0], pose[1], pose[2]));
    middle.applyQuaternion(turned.invert()).sub(plane.position).applyQuaternion(plane.quaternion.clone().invert());
    const whole = (value) => Math.round(value / this.cell) * this.cell;
    const moved = new Vector3(whole(middle.x), whole(middle.y), 0).applyQuaternion(plane.quaternion);
    plane.position.add(moved);
    const layers = [
      new Mesh(fadingDisc(this.size), this.wash),
      new LineSegments(gridLines(this.cell, this.size), this.ink),
    ];
    if (this.shade) {
      const shadow = new Mesh(new CircleGeometry(FADING[1] * this.size, 64), this.shade);
      shadow.receiveShadow = true;
      layers.push(shadow);
    }
    // Drawn in this order and before all bodies, so that layers in one plane do not flicker.
    layers.forEach((layer, order) => {
      layer.renderOrder = order - layers.length;
    });
    plane.add(...layers);
    return plane;
  }

  applyTheme() {
    this.ink.color.copy(new Color(colour('grid')));
    this.wash.color.copy(new Color(colour('ground')));
  }

  update(snapshot) {
    for (const { body, holder } of this.holders) {
      const pose = snapshot.poses.subarray(7 * body, 7 * body + 7);
      holder.position.set(pose[0], pose[1], pose[2]);
      holder.quaternion.set(pose[4], pose[5], pose[6], pose[3]);
    }
  }
}
