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
  ShadowMaterial,
  Vector3,
} from 'three';
import { roundedUp } from './numbers.js';
import { colour } from './theme.js';

/** Squares of the grid from its middle to its rim. */
const CELLS = 20;
/** Pieces of a grid line between its middle and its rim, each with its own share of fading. */
const PIECES = 10;
/** Every so many lines one is drawn stronger. */
const STRONG_EVERY = 5;

/** The share of ink at a distance from the middle, 1 there and 0 at the rim. */
function fading(x, y, rim) {
  return Math.max(0, 1 - Math.hypot(x, y) / rim) ** 1.5;
}

function gridLines(cell) {
  const rim = CELLS * cell;
  const positions = [];
  const colours = [];
  const point = (x, y, strength) => {
    positions.push(x, y, 0);
    colours.push(1, 1, 1, strength * fading(x, y, rim));
  };
  for (let line = -CELLS; line <= CELLS; line += 1) {
    const strength = line % STRONG_EVERY === 0 ? 1 : 0.5;
    const across = line * cell;
    for (let piece = -PIECES; piece < PIECES; piece += 1) {
      const from = (piece / PIECES) * rim;
      const to = ((piece + 1) / PIECES) * rim;
      point(across, from, strength);
      point(across, to, strength);
      point(from, across, strength);
      point(to, across, strength);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 4));
  return geometry;
}

/** A disc whose ink fades from its middle to its rim. */
function fadingDisc(rim) {
  const geometry = new CircleGeometry(rim, 64);
  const { count } = geometry.getAttribute('position');
  const colours = new Float32Array(4 * count).fill(1);
  for (let vertex = 1; vertex < count; vertex += 1) colours[4 * vertex + 3] = 0;
  geometry.setAttribute('color', new BufferAttribute(colours, 4));
  return geometry;
}

export class Ground {
  /** The half-spaces of all bodies of a run; `reach` in m is how far the grids go at least. */
  constructor(run, reach, shadows) {
    this.group = new Group();
    this.holders = [];
    this.cell = roundedUp(reach / CELLS);
    const look = { vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide };
    this.ink = new LineBasicMaterial(look);
    this.wash = new MeshBasicMaterial(look);
    this.shade = shadows ? new ShadowMaterial({ opacity: 0.17, depthWrite: false }) : null;
    run.bodies.forEach((body, index) => {
      if (body.half_spaces.length === 0) return;
      const holder = new Group();
      for (const half_space of body.half_spaces) holder.add(this.plane(half_space));
      this.holders.push({ body: index, holder });
      this.group.add(holder);
    });
    this.applyTheme();
  }

  plane({ normal, offset_m }) {
    const plane = new Group();
    const direction = new Vector3(...normal).normalize();
    plane.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), direction));
    plane.position.copy(direction).multiplyScalar(offset_m);
    const rim = CELLS * this.cell;
    const layers = [new Mesh(fadingDisc(rim), this.wash), new LineSegments(gridLines(this.cell), this.ink)];
    if (this.shade) {
      const shadow = new Mesh(new CircleGeometry(rim, 64), this.shade);
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
