// The numbers of one body, which a click asks for, and the words that the scene puts beside bodies.

import { angularMomentum } from './inertia.js';
import { spotOf } from './camera.js';
import { short } from './numbers.js';

const vector = (values) => `(${Array.from(values, (value) => short(value, 3)).join(', ')})`;

/** The numbers of a body at the time of a snapshot, as rows of name and value. */
export function numbersOf(run, snapshot, body) {
  const { mass_kg, moves } = run.bodies[body];
  const rates = snapshot.rates.subarray(6 * body, 6 * body + 6);
  const [speed, spin] = [rates.subarray(0, 3), rates.subarray(3, 6)];
  const rows = [['centre, m', vector(snapshot.centreOf(body))]];
  if (!moves) return [...rows, ['', 'does not move']];
  rows.push(['velocity, m/s', vector(speed)], ['angular velocity, rad/s', vector(spin)]);
  if (mass_kg !== null) {
    rows.unshift(['mass, kg', short(mass_kg)]);
    const momentum = angularMomentum(run.bodies[body], snapshot.poses, 7 * body + 3, spin);
    const turning = momentum ? 0.5 * momentum.reduce((sum, value, k) => sum + value * spin[k], 0) : 0;
    const square = speed[0] ** 2 + speed[1] ** 2 + speed[2] ** 2;
    rows.push(['kinetic energy, J', short(0.5 * mass_kg * square + turning)]);
  }
  return rows;
}

export class BodyCard {
  constructor(element) {
    this.element = element;
    this.body = null;
  }

  show(body) {
    this.body = body;
    this.element.hidden = body === null;
  }

  draw({ run, snapshot }) {
    if (this.body === null) return;
    const rows = numbersOf(run, snapshot, this.body).map(([name, value]) => {
      const row = document.createElement('tr');
      const [head, cell] = [document.createElement('th'), document.createElement('td')];
      head.textContent = name;
      cell.textContent = value;
      row.append(head, cell);
      return row;
    });
    this.element.querySelector('caption').textContent = run.bodies[this.body].name;
    this.element.querySelector('tbody').replaceChildren(...rows);
  }
}

/** The words beside bodies of one run. */
export class BodyLabels {
  constructor(holder, run) {
    this.marks = run.bodies.flatMap(({ label, opacity }, body) => {
      if (!label || opacity === 0) return [];
      const element = document.createElement('span');
      element.textContent = label;
      holder.append(element);
      return [{ body, element }];
    });
  }

  /** `part` is the part of the canvas with the run: left, top, width and height in CSS pixels. */
  draw(snapshot, camera, part) {
    for (const { body, element } of this.marks) {
      const spot = spotOf(snapshot.centreOf(body), camera, part);
      element.hidden = spot === null;
      if (spot) element.style.transform = `translate(${spot[0]}px, ${spot[1]}px) translate(-50%, -50%)`;
    }
  }
}
