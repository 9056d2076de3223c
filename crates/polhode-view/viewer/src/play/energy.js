// Energies as bars that add up: what there is now and what was lost, to what there was and what was added. The loss of the
// method is a bar of its own.

import { percent, worded } from './numbers.js';

const ROWS = [
  ['kinetic', 'Kinetic', '#3b7dd8'],
  ['potential', 'Potential', '#3f9d6c'],
  ['friction', 'Lost to friction', '#e07b39'],
  ['impacts', 'Lost in impacts', '#8a6bd1'],
  ['damping', 'Lost to damping', '#b8962e'],
  ['rest', 'Lost coming to rest', '#7c8b99'],
  ['projection', 'Lost by projection', '#c94f6d'],
  ['numerical', 'Numerical loss', '#d8334a'],
];

export class Energies {
  constructor(root) {
    this.root = root;
    this.lowest = Infinity;
    this.stack = document.createElement('div');
    this.stack.className = 'stack';
    this.table = document.createElement('table');
    this.sum = document.createElement('p');
    root.append(this.stack, this.table, this.sum);
    this.rows = new Map(
      ROWS.map(([name, words, colour]) => {
        const row = this.table.insertRow();
        row.dataset.name = name;
        const key = row.insertCell();
        const swatch = document.createElement('i');
        swatch.style.background = colour;
        key.append(swatch, words);
        const bar = row.insertCell();
        bar.className = 'bar-cell';
        const fill = document.createElement('b');
        fill.style.background = colour;
        bar.append(fill);
        const value = row.insertCell();
        value.className = 'value';
        const part = document.createElement('span');
        part.style.background = colour;
        this.stack.append(part);
        return [name, { row, fill, value, part }];
      }),
    );
  }

  clear() {
    this.lowest = Infinity;
  }

  /** Shows the energies of a report. */
  show(told) {
    this.lowest = Math.min(this.lowest, told.potential_j, 0);
    const values = { kinetic: told.kinetic_j, potential: told.potential_j, ...told.lost };
    const shown = { ...values, potential: told.potential_j - this.lowest };
    const scale = Math.max(told.scale_j, 1e-300);
    const total = Math.max(...[Object.values(shown).reduce((sum, value) => sum + Math.abs(value), 0), 1e-300]);
    for (const [name, { row, fill, value, part }] of this.rows) {
      const own = shown[name];
      const share = Math.min(1, Math.abs(own) / total);
      part.style.flexGrow = share;
      fill.style.width = `${100 * share}%`;
      fill.classList.toggle('gain', own < 0);
      value.textContent = worded(values[name], 'J');
      const minor = !['kinetic', 'potential', 'numerical', 'friction', 'impacts'].includes(name);
      row.hidden = minor && values[name] === 0;
      if (name === 'numerical') {
        value.title = `${percent(values.numerical / scale)} of the largest energy`;
        row.classList.toggle('grave', Math.abs(values.numerical / scale) > 1e-3);
      }
    }
    const added = told.external_j === 0 ? '' : ` and ${worded(told.external_j, 'J')} of work`;
    this.sum.textContent =
      `They add up to the ${worded(told.initial_j, 'J')} of the start${added}, to ${told.closure_relative.toExponential(0)} ` +
      `of the largest. Numerical loss: ${percent(told.lost.numerical / scale)} of it.`;
  }
}
