// Contact points, a short stub along each normal, the contact force as an arrow along the normal, and the forces of joints.

import { CanvasTexture, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';
import { Arrows } from '../arrows.js';
import { FORCE_COLOUR, JOINT_COLOUR, NORMAL_COLOUR } from '../colours.js';
import { GrowingGeometry } from '../growing.js';
import { quantile, short } from '../numbers.js';

/** Size of a contact point in pixels. */
const POINT_PIXELS = 7;
/** Lengths in typical radii of a body: the stub of a normal, the longest arrow, the radius of its shaft. */
const STUB = 0.35;
const LONGEST = 1.8;
const SHAFT = 0.022;
/** The largest force of this share of the contacts sets the scale: a single jammed one must not hide the others. */
const USUAL_SHARE = 0.9;
/** Arrows are cut at so many lengths of the scale. */
const CUT = 1.5;

/** A round picture for points, which WebGL draws as squares. */
function discTexture() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext('2d');
  pen.fillStyle = '#fff';
  pen.arc(16, 16, 15, 0, 2 * Math.PI);
  pen.fill();
  return new CanvasTexture(canvas);
}

export class Contacts {
  constructor(view) {
    this.view = view;
    this.group = new Group();
    this.scale = view.scaleOf('force', LONGEST);
    this.arrows = new Arrows(FORCE_COLOUR, SHAFT * view.size);
    this.loads = new Arrows(JOINT_COLOUR, SHAFT * view.size);
    this.points = new GrowingGeometry();
    this.stubs = new GrowingGeometry();
    const above_all = { depthTest: false, depthWrite: false, transparent: true };
    const dots = new Points(
      this.points.geometry,
      new PointsMaterial({
        color: NORMAL_COLOUR,
        size: POINT_PIXELS * Math.min(2, devicePixelRatio),
        sizeAttenuation: false,
        map: discTexture(),
        alphaTest: 0.5,
        ...above_all,
      }),
    );
    const lines = new LineSegments(this.stubs.geometry, new LineBasicMaterial({ color: NORMAL_COLOUR, ...above_all }));
    dots.renderOrder = 12;
    lines.renderOrder = 9;
    dots.frustumCulled = lines.frustumCulled = false;
    this.group.add(this.arrows.group, this.loads.group, lines, dots);
  }

  update() {
    const { run, snapshot, size } = this.view;
    for (const part of [this.points, this.stubs, this.arrows, this.loads]) part.clear();
    const forces = [];
    snapshot.eachContact((a, b, numbers, at) => forces.push(Math.abs(numbers[at + 7])));
    snapshot.eachJointLoad((joint, numbers, at) => forces.push(numbers[at + 7]));
    this.scale.see(quantile(forces, USUAL_SHARE) ?? 0);
    const { factor } = this.scale;
    snapshot.eachContact((a, b, numbers, at) => {
      const point = numbers.subarray(at, at + 3);
      const normal = numbers.subarray(at + 3, at + 6);
      const stub = STUB * size;
      this.points.add(...point);
      this.stubs.add(...point);
      this.stubs.add(point[0] + stub * normal[0], point[1] + stub * normal[1], point[2] + stub * normal[2]);
      const force = numbers[at + 7];
      if (!Number.isFinite(force)) return;
      // The normal points from B to A, so a positive force along it is what A feels; where A is fixed, what B feels.
      const felt_by = run.bodies[a]?.moves ? 1 : -1;
      const along = normal.map((n) => n * felt_by * Math.sign(force));
      this.arrows.add(point, along, Math.min(Math.abs(force) * factor, CUT * this.scale.longest));
    });
    snapshot.eachJointLoad((joint, numbers, at) => {
      const force = numbers[at + 7];
      if (!Number.isFinite(force)) return;
      const length = Math.min(force * factor, CUT * this.scale.longest);
      this.loads.add(numbers.subarray(at, at + 3), numbers.subarray(at + 3, at + 6), length);
    });
    for (const part of [this.points, this.stubs, this.arrows, this.loads]) part.show();
  }

  legend() {
    const metres = (times) => short(times * this.scale.longest, 3);
    const length = `${metres(1)} m`;
    const scale = `${short(this.scale.full)} N is ${length} long, cut at ${metres(CUT)} m`;
    const lines = [
      { colour: NORMAL_COLOUR, text: 'contact point and normal (towards the first body)' },
      { colour: FORCE_COLOUR, text: `force on a body that moves: ${scale}` },
    ];
    if (this.view.run.joints > 0) {
      lines.push({ colour: JOINT_COLOUR, text: `force of a joint on its first body: ${scale}` });
    }
    return lines;
  }
}
