// The bounding box of each body, fixed in the body.

import { BoxGeometry, Color, EdgesGeometry, LineBasicMaterial } from 'three';
import { instancedLines, writeMatrix } from '../instances.js';
import { matrixOf, turn } from '../rotation.js';
import { colour } from '../theme.js';

/** Places the unit cube on the box of a body, as the instance `instance` of `out`. */
export function placeBox(out, instance, box, poses, body) {
  const [low, high] = box;
  const turned = matrixOf(poses, 7 * body + 3, new Float64Array(9));
  const middle = turn(
    turned,
    low.map((value, k) => (value + high[k]) / 2),
  );
  const side = (k) =>
    turn(
      turned,
      [0, 1, 2].map((axis) => (axis === k ? high[k] - low[k] : 0)),
    );
  writeMatrix(
    out,
    instance,
    side(0),
    side(1),
    side(2),
    middle.map((value, k) => value + poses[7 * body + k]),
  );
}

/** The edges of a cube with sides of one metre about the origin. */
export function cubeEdges() {
  return new EdgesGeometry(new BoxGeometry(1, 1, 1));
}

export class Boxes {
  constructor(view) {
    this.view = view;
    this.bodies = view.run.bodies.map((_, body) => body).filter((body) => view.run.bodies[body].box);
    const material = new LineBasicMaterial({ depthTest: false, transparent: true, opacity: 0.8 });
    this.group = instancedLines(cubeEdges(), material, this.bodies.length);
    this.group.renderOrder = 5;
  }

  update() {
    const { run, snapshot } = this.view;
    this.group.material.color.copy(new Color(colour('accent')));
    this.bodies.forEach((body, instance) => {
      placeBox(this.group.instanceMatrix.array, instance, run.bodies[body].box, snapshot.poses, body);
    });
    this.group.instanceMatrix.needsUpdate = true;
  }

  legend() {
    return [];
  }
}
