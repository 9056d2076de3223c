// The velocity of each body as an arrow from its centre of mass.

import { Arrows } from '../arrows.js';
import { VELOCITY_COLOUR } from '../colours.js';
import { short } from '../numbers.js';

/** Lengths in typical radii of a body: the longest arrow and the radius of its shaft. */
const LONGEST = 2.5;
const SHAFT = 0.022;

export class Velocities {
  constructor(view) {
    this.view = view;
    this.scale = view.scaleOf('velocity', LONGEST);
    this.arrows = new Arrows(VELOCITY_COLOUR, SHAFT * view.size);
    this.group = this.arrows.group;
  }

  update() {
    const { run, snapshot } = this.view;
    const velocity = (body) => snapshot.rates.subarray(6 * body, 6 * body + 3);
    for (const body of run.moving) this.scale.see(Math.hypot(...velocity(body)));
    this.arrows.clear();
    for (const body of run.moving) {
      this.arrows.add(snapshot.centreOf(body), velocity(body), this.scale.factor);
    }
    this.arrows.show();
  }

  legend() {
    const text = `velocity: ${short(this.scale.full)} m/s is ${short(this.scale.longest, 3)} m long`;
    return [{ colour: VELOCITY_COLOUR, text }];
  }
}
