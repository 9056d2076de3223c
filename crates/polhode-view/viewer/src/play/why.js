// Why a body moves as it does: the forces on it head to tail, each contact's reaction in its cone of friction, the margin,
// and what would have to change.

import { percent, worded } from './numbers.js';

const SVG = 'http://www.w3.org/2000/svg';
/** Forces below this part of the largest are left out. */
const LEAST = 1e-9;
/** Contacts that are drawn with a cone of their own; the rest is told by a number. */
const MOST_CONES = 4;

function drawn(name, attributes, ...children) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = (a) => Math.hypot(...a);

/** The upright plane in which most of the horizontal forces lie: its direction across and up. */
function planeOf(vectors, up) {
  let best = null;
  for (const v of vectors) {
    const along = dot(v, up);
    const flat = v.map((value, k) => value - along * up[k]);
    if (!best || length(flat) > length(best)) best = flat;
  }
  const size = best ? length(best) : 0;
  const scale = Math.max(...vectors.map(length), 0);
  if (size > 1e-6 * scale) return best.map((value) => value / size);
  const other = Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const along = dot(other, up);
  const flat = other.map((value, k) => value - along * up[k]);
  return flat.map((value) => value / length(flat));
}

function arrow(from, to, name) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const size = Math.hypot(dx, dy);
  const head = Math.min(8, size / 2);
  const [ux, uy] = size > 0 ? [dx / size, dy / size] : [0, 0];
  const base = [to[0] - ux * head, to[1] - uy * head];
  const wing = head * 0.4;
  return drawn(
    'g',
    { class: name },
    drawn('line', { x1: from[0], y1: from[1], x2: base[0], y2: base[1] }),
    drawn('path', {
      d: `M${to[0]} ${to[1]}L${base[0] - uy * wing} ${base[1] + ux * wing}L${base[0] + uy * wing} ${base[1] - ux * wing}Z`,
    }),
  );
}

/** The force polygon: forces head to tail, and what closes it, m a. */
function polygon(steps, total, across, up) {
  const places = [[0, 0]];
  for (const { force } of steps) {
    const [x, y] = places.at(-1);
    places.push([x + dot(force, across), y + dot(force, up)]);
  }
  const end = [dot(total, across), dot(total, up)];
  const all = [...places, end];
  const [low, high] = [0, 1].map((k) => k).reduce(
    (bounds, k) => {
      bounds[0][k] = Math.min(...all.map((place) => place[k]));
      bounds[1][k] = Math.max(...all.map((place) => place[k]));
      return bounds;
    },
    [[], []],
  );
  const span = Math.max(high[0] - low[0], high[1] - low[1], 1e-300);
  const [width, height, rim] = [300, 150, 26];
  const scale = Math.min((width - 2 * rim) / span, (height - 2 * rim) / span);
  const at = ([x, y]) => [
    width / 2 + (x - (low[0] + high[0]) / 2) * scale,
    height / 2 - (y - (low[1] + high[1]) / 2) * scale,
  ];
  const svg = drawn('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'Force polygon' });
  steps.forEach(({ from, kind }, index) => {
    // Forces that lead back over each other are drawn side by side.
    const shift = 3 * (index - steps.length / 2);
    const [a, b] = [at(places[index]), at(places[index + 1])].map(([x, y]) => [x + shift, y]);
    const one = arrow(a, b, kind);
    one.prepend(drawn('title', {}, from));
    svg.append(one);
    const label = drawn('text', { x: (a[0] + b[0]) / 2 + 6, y: (a[1] + b[1]) / 2 + (index % 2 === 0 ? -2 : 10), class: kind });
    label.textContent = from;
    svg.append(label);
  });
  if (length(total) * scale > 4) svg.append(arrow(at([0, 0]), at(end), 'total'));
  return svg;
}

/** A contact's reaction in its cone of friction. */
function coneOf({ from, cone }) {
  const [width, height, foot] = [92, 92, 84];
  const svg = drawn('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', class: 'cone' });
  svg.setAttribute('aria-label', `Friction cone of the contact with ${from}`);
  const tall = 66;
  const mu = Math.min(cone.coefficient, 1.1);
  const wide = mu * tall;
  svg.append(drawn('path', { class: 'cone-area', d: `M46 ${foot}L${46 - wide * 0.6} ${foot - tall}L${46 + wide * 0.6} ${foot - tall}Z` }));
  svg.append(drawn('line', { class: 'axis', x1: 46, y1: foot, x2: 46, y2: foot - tall }));
  const needed = Math.min(cone.needed ?? 0, 1.2);
  const used = cone.coefficient > 0 && needed >= cone.coefficient * (1 - 1e-6);
  svg.append(arrow([46, foot], [46 + needed * tall * 0.6, foot - tall * 0.96], used ? 'reaction used' : 'reaction'));
  return svg;
}

export class Why {
  constructor(root) {
    this.root = root;
    this.body = root.querySelector('.why-body');
    this.title = root.querySelector('h2 span');
  }

  clear() {
    this.root.hidden = true;
    this.body.replaceChildren();
  }

  refuse(name, message) {
    this.root.hidden = false;
    this.title.textContent = name;
    const words = document.createElement('p');
    words.textContent = message;
    this.body.replaceChildren(words);
  }

  /** Shows the forces on a body; `gravity` says where up is. */
  show(why, gravity) {
    this.root.hidden = false;
    this.title.textContent = why.name;
    const size = length(gravity ?? [0, 0, 0]);
    const up = size > 0 ? gravity.map((value) => -value / size) : [0, 0, 1];
    const largest = Math.max(...why.forces.map(({ force }) => length(force)), length(why.others), 0);
    const steps = gathered(why, largest);
    const across = planeOf(steps.map(({ force }) => force), up);
    const sum = document.createElement('p');
    const acceleration = length(why.mass_times_acceleration);
    sum.textContent =
      acceleration <= 1e-6 * largest
        ? 'The forces close the polygon: the body is in equilibrium.'
        : `The forces add up to m a = ${worded(acceleration, 'N')}.`;
    this.body.replaceChildren(polygon(steps, why.mass_times_acceleration, across, up), sum);
    const cones = why.forces.filter(({ cone, force }) => cone && length(force) > LEAST * largest);
    cones.sort((one, other) => (other.cone.needed ?? 0) - (one.cone.needed ?? 0));
    for (const one of cones.slice(0, MOST_CONES)) {
      const row = document.createElement('div');
      row.className = 'contact';
      const words = document.createElement('p');
      words.textContent = `${one.words}.`;
      row.append(coneOf(one), words);
      this.body.append(row);
    }
    if (cones.length > MOST_CONES) {
      const more = document.createElement('p');
      more.textContent = `${cones.length - MOST_CONES} more contacts use less of their friction.`;
      this.body.append(more);
    }
    if (cones.length === 0 && why.forces.length === 1) {
      const free = document.createElement('p');
      free.textContent = 'Nothing touches it: it flies freely.';
      this.body.append(free);
    }
    this.margins = document.createElement('p');
    this.margins.className = 'margins';
    this.margins.textContent = cones.length > 0 ? 'Looking for what would have to change …' : '';
    this.body.append(this.margins);
    return cones.length > 0;
  }

  /** Adds how far the bodies at rest are from moving. */
  showMargins(margins) {
    this.margins.textContent = marginWords(margins);
  }
}

/** The forces as steps of the polygon: contacts with one body are one force. */
function gathered(why, largest) {
  const steps = [];
  for (const { from, force, cone } of why.forces) {
    if (length(force) <= LEAST * largest) continue;
    const known = cone && steps.find((step) => step.from === from && step.kind === 'contact');
    if (known) known.force = known.force.map((value, k) => value + force[k]);
    else steps.push({ from, force: [...force], kind: cone ? 'contact' : from === 'its weight' ? 'weight' : 'other' });
  }
  if (length(why.others) > 1e-6 * largest) steps.push({ from: 'the rest: fields of the scene', force: why.others, kind: 'other' });
  return steps;
}

function beginning(list) {
  if (!list || list.length === 0) return 'nothing begins to move';
  const [first] = list;
  const others = list.length > 1 ? ` with ${list.length - 1} more` : '';
  return `${first.body} ${first.how}${others}`;
}

/** What would have to change for a body to move, in a sentence or two. */
export function marginWords(margins) {
  if (margins.bodies === 0) return 'No body that touches another is at rest: what would have to change is asked of bodies at rest.';
  const needed = margins.friction_needed;
  const parts = [];
  if (needed === null) parts.push('Friction alone does not hold the bodies at rest.');
  else if (needed === 0) parts.push('No friction is needed: they stand without any.');
  else {
    parts.push(`All at rest stand until friction falls to ${percent(needed)} of what it is; then ${beginning(margins.begins)}.`);
  }
  const pushes = margins.pushes.filter(({ of_weight }) => typeof of_weight === 'number');
  const worst = pushes.reduce((least, push) => (least && least.of_weight <= push.of_weight ? least : push), null);
  if (worst) {
    const tilt = worst.tilt_rad === null ? '' : `, or a tilt of ${worded((worst.tilt_rad * 180) / Math.PI)}°,`;
    parts.push(`A push of ${percent(worst.of_weight)} of each weight${tilt} is the least that moves one: ${beginning(worst.begins)}.`);
  } else if (margins.pushes.length > 0) parts.push('No push across gravity moves any.');
  return parts.join(' ');
}
