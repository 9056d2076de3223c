// The paths of the centres of mass: the past strong, the future faint.

import { BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments } from 'three';
import { normalise } from '../rotation.js';
import { centreAt } from '../snapshot.js';

/** Points of all paths together at most; with more, only every so many frames are used. */
const MOST_POINTS = 300000;
/** Position and orientation in the channels of a chunk. */
const POSE_CHANNELS = [0, 1, 2, 3, 4, 5, 6];

export class Traces {
  constructor(view) {
    this.view = view;
    this.group = new Group();
    this.scan = null;
    this.segments = 0;
  }

  update() {
    const { run, snapshot } = this.view;
    if (run.moving.length === 0 || run.times.length === 0) return;
    if (!this.scan) this.begin();
    const now = Math.floor(snapshot.frame / this.stride) * run.moving.length * 2;
    const all = this.segments * 2;
    this.past.setDrawRange(0, Math.min(now, all));
    this.all.setDrawRange(0, all);
    this.positions.needsUpdate = true;
  }

  /** Segments stand frame by frame and in it body by body, so that the past is a first part of the buffer. */
  begin() {
    const { run, frames, requestDraw } = this.view;
    const bodies = run.moving.length;
    this.stride = Math.ceil((bodies * run.times.length) / MOST_POINTS);
    const steps = Math.ceil(run.times.length / this.stride) - 1;
    this.positions = new BufferAttribute(new Float32Array(6 * bodies * steps), 3);
    const colours = new BufferAttribute(new Uint8Array(6 * bodies * steps), 3, true);
    const palette = run.moving.map((body) => new Color(run.bodies[body].colour));
    for (let vertex = 0; vertex < 2 * bodies * steps; vertex += 1) {
      const { r, g, b } = palette[(vertex >> 1) % bodies];
      colours.setXYZ(vertex, r, g, b);
    }
    const lines = (opacity) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', this.positions);
      geometry.setAttribute('color', colours);
      const drawn = new LineSegments(
        geometry,
        new LineBasicMaterial({ vertexColors: true, transparent: true, opacity }),
      );
      drawn.frustumCulled = false;
      this.group.add(drawn);
      return geometry;
    };
    this.all = lines(0.22);
    this.past = lines(1);
    this.scan = new AbortController();
    const places = run.moving.map((_, place) => place);
    const take = this.taker(run);
    frames.scan(places, POSE_CHANNELS, this.stride, take, this.scan.signal, requestDraw);
  }

  /** Writes the segments from each read frame to the next one. */
  taker(run) {
    const bodies = run.moving.length;
    const [metre, unit] = run.quanta;
    const pose = new Float64Array(7);
    let before = null;
    return (frame, values) => {
      const now = run.moving.map((body, place) => {
        for (let k = 0; k < 7; k += 1) pose[k] = values[k * bodies + place] * (k < 3 ? metre : unit);
        normalise(pose, 3);
        return centreAt(run.bodies[body], pose, 0);
      });
      for (let place = 0; before && place < bodies; place += 1) {
        this.positions.array.set(before[place], 6 * this.segments);
        this.positions.array.set(now[place], 6 * this.segments + 3);
        this.segments += 1;
      }
      before = now;
    };
  }

  legend() {
    return [];
  }
}
