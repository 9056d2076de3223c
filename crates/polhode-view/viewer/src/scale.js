// The axes of the world, a bar with its length, and how large a cell of the grid is. The bar is as long as it says where the
// camera looks at; what is nearer is larger.

import { Vector3 } from 'three';
import { roundedDown, lengthWords } from './numbers.js';

/** Length of an axis and of the bar at the most, in CSS pixels. */
const AXIS = 22;
const LONGEST_BAR = 120;
const AXES = [
  ['x', new Vector3(1, 0, 0)],
  ['y', new Vector3(0, 1, 0)],
  ['z', new Vector3(0, 0, 1)],
];

export class Scale {
  /** `cell` is the size of a cell of the grid in m, or null without a grid. */
  constructor(holder, colours, cell) {
    this.colours = colours;
    holder.innerHTML =
      '<svg viewBox="-34 -34 68 68" aria-hidden="true"></svg>' +
      '<div><span class="bar-length"></span><span class="bar-line"></span><span class="grid-cell" hidden></span></div>';
    this.axes = holder.querySelector('svg');
    this.bar = holder.querySelector('.bar-line');
    this.length = holder.querySelector('.bar-length');
    const grid = holder.querySelector('.grid-cell');
    grid.textContent = cell === null ? '' : `grid ${lengthWords(cell)}`;
    grid.hidden = cell === null;
  }

  /** `pixels` is how many CSS pixels a metre has where the camera looks at. */
  draw(camera, pixels) {
    const length = roundedDown(LONGEST_BAR / pixels);
    this.bar.style.width = `${length * pixels}px`;
    const words = lengthWords(length);
    if (this.length.textContent !== words) this.length.textContent = words;
    const turned = camera.quaternion.clone().invert();
    const seen = AXES.map(([name, axis], index) => ({
      name,
      colour: this.colours[index],
      at: axis.clone().applyQuaternion(turned),
    }));
    // The farthest first.
    seen.sort((one, other) => one.at.z - other.at.z);
    const lines = seen.map(({ name, colour, at }) => {
      const [x, y] = [AXIS * at.x, -AXIS * at.y];
      const size = Math.hypot(x, y);
      const [u, v] = size > 4 ? [x / size, y / size] : [0.7, 0.7];
      return (
        `<line x1="0" y1="0" x2="${x.toFixed(1)}" y2="${y.toFixed(1)}" stroke="${colour}"/>` +
        `<text x="${(x + 7 * u).toFixed(1)}" y="${(y + 7 * v).toFixed(1)}" fill="${colour}">${name}</text>`
      );
    });
    const text = lines.join('');
    if (this.text === text) return;
    this.text = text;
    this.axes.innerHTML = text;
  }
}
