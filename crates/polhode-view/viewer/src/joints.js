// Rods, ropes and springs of one run: what stretches between two ends. All else that is drawn of joints is a part of a body
// or of the world (bodies.js). The forms are those of pictures (polhode-view, fixtures.rs).

import { Color, CylinderGeometry, Group, MeshLambertMaterial } from 'three';
import { crossAxes } from './arrows.js';
import { LOOK } from './framing.js';
import { instancedMesh, writeMatrix } from './instances.js';
import { matrixOf, turn } from './rotation.js';

/** Sides of what is round. */
const SIDES = 8;
/** Pieces of a rope that sags; turns of a spring, and pieces of a turn. */
const ROPE_PIECES = 16;
const SPRING_TURNS = 8;
const TURN_PIECES = 10;
/** Straight part of a spring at each end, and radius of its coil, as shares of its length without force. */
const SPRING_END = 0.1;
const COIL = 0.08;
/** The most pieces of one link. */
const MOST_PIECES = SPRING_TURNS * TURN_PIECES + 2;

const along = (a, b, t) => a.map((value, k) => value + (b[k] - value) * t);

/** Points along a link from end to end; `up` points against gravity. */
export function pointsOf({ kind, length_m }, a, b, up) {
  const apart = Math.hypot(...a.map((value, k) => b[k] - value));
  if (kind === 'rope') {
    const sag = Math.min(Math.sqrt(0.375 * apart * Math.max(0, length_m - apart)), 0.5 * length_m);
    if (!(sag > 0)) return [a, b];
    return Array.from({ length: ROPE_PIECES + 1 }, (_, piece) => {
      const t = piece / ROPE_PIECES;
      return along(a, b, t).map((value, k) => value - up[k] * 4 * sag * t * (1 - t));
    });
  }
  if (kind !== 'spring') return [a, b];
  const w = apart > 0 ? a.map((value, k) => (b[k] - value) / apart) : [0, 0, 1];
  const [, across] = crossAxes(w);
  const other = [
    w[1] * across[2] - w[2] * across[1],
    w[2] * across[0] - w[0] * across[2],
    w[0] * across[1] - w[1] * across[0],
  ];
  const pieces = SPRING_TURNS * TURN_PIECES;
  const coil = Array.from({ length: pieces + 1 }, (_, piece) => {
    const share = piece / pieces;
    const angle = 2 * Math.PI * SPRING_TURNS * share;
    const [c, s] = [Math.cos(angle) * COIL * length_m, Math.sin(angle) * COIL * length_m];
    const middle = along(a, b, SPRING_END + (1 - 2 * SPRING_END) * share);
    return middle.map((value, k) => value + across[k] * c + other[k] * s);
  });
  return [a, ...coil, b];
}

export class Joints {
  /** `look` has the colour `fixture` and `shadows`; `gravity` says where down is: along -z when absent. */
  constructor(run, look = LOOK, gravity = null) {
    this.run = run;
    this.group = new Group();
    const size = Math.hypot(...(gravity ?? [0, 0, 0]));
    this.up = size > 0 ? gravity.map((value) => -value / size) : [0, 0, 1];
    if (run.links.length === 0) return;
    const shape = new CylinderGeometry(1, 1, 1, SIDES).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    const material = new MeshLambertMaterial({ color: new Color(look.fixture) });
    this.mesh = instancedMesh(shape, material, run.links.length * MOST_PIECES);
    this.mesh.castShadow = this.mesh.receiveShadow = Boolean(look.shadows);
    this.mesh.raycast = () => {};
    this.group.add(this.mesh);
  }

  /** Places all pieces by the poses of the bodies. */
  update(poses) {
    if (!this.mesh) return;
    const turned = new Float64Array(9);
    const placed = ({ body, point }) => {
      if (body === null) return point;
      matrixOf(poses, 7 * body + 3, turned);
      return turn(turned, point).map((value, k) => value + poses[7 * body + k]);
    };
    let count = 0;
    for (const link of this.run.links) {
      const points = pointsOf(link, ...link.ends.map(placed), this.up);
      for (let piece = 0; piece + 1 < points.length; piece += 1) {
        const [from, to] = [points[piece], points[piece + 1]];
        const arm = to.map((value, k) => value - from[k]);
        const length = Math.hypot(...arm);
        if (!(length > 0)) continue;
        const [u, v] = crossAxes(arm.map((value) => value / length));
        const wide = (axis) => axis.map((value) => value * link.radius_m);
        writeMatrix(this.mesh.instanceMatrix.array, count, wide(u), wide(v), arm, from);
        count += 1;
      }
    }
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}
