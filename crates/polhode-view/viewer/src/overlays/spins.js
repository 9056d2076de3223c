// Angular velocity w and angular momentum L = R I R^T w of each body as arrows from its centre of mass.

import { Group } from 'three';
import { Arrows } from '../arrows.js';
import { MOMENTUM_COLOUR, SPIN_COLOUR } from '../colours.js';
import { angularMomentum } from '../inertia.js';
import { short } from '../numbers.js';

/** Lengths in typical radii of a body: the longest arrow and the radius of its shaft. */
const LONGEST = 2.2;
const SHAFT = 0.022;

export class Spins {
  constructor(view) {
    this.view = view;
    this.group = new Group();
    this.spin_scale = view.scaleOf('spin', LONGEST);
    this.momentum_scale = view.scaleOf('momentum', LONGEST);
    this.spins = new Arrows(SPIN_COLOUR, SHAFT * view.size);
    this.momenta = new Arrows(MOMENTUM_COLOUR, SHAFT * view.size);
    this.group.add(this.momenta.group, this.spins.group);
  }

  update() {
    const { run, snapshot } = this.view;
    this.spins.clear();
    this.momenta.clear();
    const vectors = run.moving.map((body) => {
      const spin = snapshot.rates.subarray(6 * body + 3, 6 * body + 6);
      const momentum = angularMomentum(run.bodies[body], snapshot.poses, 7 * body + 3, spin);
      this.spin_scale.see(Math.hypot(...spin));
      if (momentum) this.momentum_scale.see(Math.hypot(...momentum));
      return { origin: snapshot.centreOf(body), spin, momentum };
    });
    for (const { origin, spin, momentum } of vectors) {
      this.spins.add(origin, spin, this.spin_scale.factor);
      if (momentum) this.momenta.add(origin, momentum, this.momentum_scale.factor);
    }
    this.spins.show();
    this.momenta.show();
  }

  legend() {
    const line = (name, unit, { full, longest }) => `${name}: ${short(full)} ${unit} is ${short(longest, 3)} m long`;
    return [
      { colour: SPIN_COLOUR, text: line('angular velocity', 'rad/s', this.spin_scale) },
      { colour: MOMENTUM_COLOUR, text: line('angular momentum', 'kg m²/s', this.momentum_scale) },
    ];
  }
}
