// Contact manifolds: the contacts of one pair of bodies with one normal, joined into their convex hull in the plane of
// the normal.

import { DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial } from 'three';
import { crossAxes } from '../arrows.js';
import { MANIFOLD_COLOUR } from '../colours.js';
import { GrowingGeometry } from '../growing.js';

/** Contacts of one pair belong to one manifold when the cosine of the angle of their normals is above this (8 deg). */
const SAME_NORMAL = 0.99;

/** Convex hull of points [x, y, index], anticlockwise (Andrew's monotone chain). */
export function hull(points) {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  if (sorted.length < 3) return sorted;
  const turn = (o, p, q) => (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
  const chain = (list) => {
    const kept = [];
    for (const point of list) {
      while (kept.length > 1 && turn(kept.at(-2), kept.at(-1), point) <= 0) kept.pop();
      kept.push(point);
    }
    kept.pop();
    return kept;
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

/** The contacts of a snapshot by pair and normal: [{ normal, points }]. */
function manifoldsOf(snapshot) {
  const of_pair = new Map();
  snapshot.eachContact((a, b, numbers, at) => {
    const key = `${a} ${b}`;
    const point = Array.from(numbers.subarray(at, at + 3));
    const normal = Array.from(numbers.subarray(at + 3, at + 6));
    if (!of_pair.has(key)) of_pair.set(key, []);
    const list = of_pair.get(key);
    const same = list.find(({ normal: n }) => n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] > SAME_NORMAL);
    if (same) same.points.push(point);
    else list.push({ normal, points: [point] });
  });
  return [...of_pair.values()].flat();
}

export class Manifolds {
  constructor(view) {
    this.view = view;
    this.group = new Group();
    this.faces = new GrowingGeometry();
    this.rims = new GrowingGeometry();
    const above_all = { color: MANIFOLD_COLOUR, depthTest: false, depthWrite: false, transparent: true };
    const faces = new Mesh(
      this.faces.geometry,
      new MeshBasicMaterial({ ...above_all, opacity: 0.45, side: DoubleSide }),
    );
    const rims = new LineSegments(this.rims.geometry, new LineBasicMaterial(above_all));
    faces.renderOrder = 7;
    rims.renderOrder = 8;
    faces.frustumCulled = rims.frustumCulled = false;
    this.group.add(faces, rims);
  }

  update() {
    this.faces.clear();
    this.rims.clear();
    for (const { normal, points } of manifoldsOf(this.view.snapshot)) {
      const [u, v] = crossAxes(normal);
      const along = (axis, p) => axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
      const rim = hull(points.map((p, index) => [along(u, p), along(v, p), index])).map(([, , index]) => points[index]);
      for (let k = 1; k + 1 < rim.length; k += 1) {
        for (const corner of [rim[0], rim[k], rim[k + 1]]) this.faces.add(...corner);
      }
      const sides = rim.length === 2 ? 1 : rim.length;
      for (let k = 0; rim.length > 1 && k < sides; k += 1) {
        this.rims.add(...rim[k]);
        this.rims.add(...rim[(k + 1) % rim.length]);
      }
    }
    this.faces.show();
    this.rims.show();
  }

  legend() {
    return [{ colour: MANIFOLD_COLOUR, text: 'contact manifold' }];
  }
}
