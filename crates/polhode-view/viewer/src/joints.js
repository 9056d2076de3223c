// The joints of one run: ropes and rods as lines between their ends, all others as dots at their anchors. Dots stand inside
// bodies, and nothing hides them.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
} from 'three';
import { matrixOf, turn } from './rotation.js';
import { colour } from './theme.js';

/** Width of a dot, in pixels. */
const DOT = 5;

/** A geometry of points that move. */
function moving(count) {
  const geometry = new BufferGeometry();
  const places = new BufferAttribute(new Float32Array(3 * count), 3);
  places.setUsage(DynamicDrawUsage);
  geometry.setAttribute('position', places);
  return geometry;
}

export class Joints {
  constructor(run) {
    const links = run.joints.filter((joint) => joint.link);
    /** Both ends of each link, one after the other. */
    this.ends = links.flatMap((joint) => joint.ends);
    this.anchors = run.joints.filter((joint) => !joint.link).map((joint) => joint.ends[0]);
    this.lines = new LineSegments(moving(this.ends.length), new LineBasicMaterial());
    this.dots = new Points(
      moving(this.anchors.length),
      new PointsMaterial({ size: DOT, sizeAttenuation: false, depthTest: false, transparent: true, opacity: 0.85 }),
    );
    this.dots.renderOrder = 6;
    for (const part of [this.lines, this.dots]) {
      part.frustumCulled = false;
      part.raycast = () => {};
    }
    this.group = new Group();
    if (this.ends.length > 0) this.group.add(this.lines);
    if (this.anchors.length > 0) this.group.add(this.dots);
  }

  /** Places ends and anchors by the poses of the bodies. */
  update(poses) {
    const turned = new Float64Array(9);
    for (const [part, points] of [
      [this.lines, this.ends],
      [this.dots, this.anchors],
    ]) {
      const places = part.geometry.getAttribute('position');
      points.forEach(({ body, point }, index) => {
        let place = point;
        if (body !== null) {
          matrixOf(poses, 7 * body + 3, turned);
          place = turn(turned, point).map((value, k) => value + poses[7 * body + k]);
        }
        places.setXYZ(index, ...place);
      });
      places.needsUpdate = true;
      part.material.color.copy(new Color(colour('ink')));
    }
  }
}
