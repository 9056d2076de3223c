// How far other copies are from the one that is shown, over time, on a logarithmic axis.

import { fitCanvas } from '../canvas.js';
import { colour } from '../theme.js';
import { worded } from './numbers.js';

/** The least distance that is drawn, m. */
const LEAST = 1e-15;
/** Distances between these parts of the size of a body tell the rate at which copies part. */
const FIT_FROM = 1e-11;
const FIT_TO = 1e-2;

export class Distances {
  constructor(root) {
    this.root = root;
    this.canvas = root.querySelector('canvas');
    this.words = root.querySelector('p');
    this.series = new Map();
  }

  begin(name, label, text) {
    this.series.set(name, { label, text, points: [] });
    this.root.hidden = false;
  }

  drop(name) {
    this.series.delete(name);
    this.root.hidden = this.series.size === 0;
  }

  clear() {
    for (const one of this.series.values()) one.points.length = 0;
  }

  /** Adds what the copies of this name were apart by at a time; times go on. */
  add(name, t, distance) {
    const { points } = this.series.get(name);
    while (points.length > 0 && points.at(-1)[0] >= t) points.pop();
    points.push([t, distance]);
  }

  lastTime(name) {
    return this.series.get(name)?.points.at(-1)?.[0] ?? -Infinity;
  }

  cut(t) {
    for (const { points } of this.series.values()) while (points.length > 0 && points.at(-1)[0] > t) points.pop();
  }

  /** Draws up to the time that is shown. */
  draw(now, size) {
    if (this.root.hidden) return;
    const { pen, width, height } = fitCanvas(this.canvas);
    pen.clearRect(0, 0, width, height);
    const all = [...this.series.values()].flatMap(({ points }) => points);
    const last = Math.max(now, ...all.slice(-1).map(([t]) => t), 1e-9);
    const values = all.map(([, value]) => value).filter((value) => value > LEAST);
    const high = Math.ceil(Math.log10(Math.max(...values, 1e-12)) + 0.05);
    const low = Math.min(high - 2, Math.floor(Math.log10(Math.min(...values, 1e-3))));
    const left = 52;
    const bottom = height - 18;
    const x = (t) => left + (t / last) * (width - left - 6);
    const y = (value) => 6 + ((high - Math.log10(Math.max(value, 10 ** low))) / (high - low)) * (bottom - 6);
    pen.font = '11px system-ui, sans-serif';
    pen.fillStyle = colour('quiet');
    pen.strokeStyle = colour('rule');
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    const every = Math.max(1, Math.ceil((high - low) / 5));
    for (let power = high; power >= low; power -= every) {
      const at = y(10 ** power);
      pen.fillText(`1e${power} m`, left - 4, at);
      pen.beginPath();
      pen.moveTo(left, at);
      pen.lineTo(width - 6, at);
      pen.stroke();
    }
    pen.textBaseline = 'alphabetic';
    pen.fillText(`${worded(last)} s`, width - 6, height - 4);
    pen.textAlign = 'left';
    pen.fillText('0', left, height - 4);
    for (const { text, points } of this.series.values()) {
      pen.strokeStyle = text;
      pen.lineWidth = 1.6;
      pen.beginPath();
      points.forEach(([t, value], index) => (index === 0 ? pen.moveTo(x(t), y(value)) : pen.lineTo(x(t), y(value))));
      pen.stroke();
    }
    this.words.textContent = [...this.series.values()].map((one) => sentence(one, now, size)).join(' ');
  }
}

function sentence({ label, points }, now, size) {
  const at = points.findLast(([t]) => t <= now + 1e-9) ?? points.at(-1);
  if (!at) return `${label}: not computed yet.`;
  const rate = label.startsWith('Second') ? growth(points, size) : null;
  const parting = rate ? ` They part by a factor of ten in ${worded(Math.LN10 / rate, 's')} (Lyapunov time ${worded(1 / rate, 's')}).` : '';
  return `${label}: ${worded(at[1], 'm')} away.${parting}`;
}

/** The rate at which copies part, 1/s: the slope of the logarithm, where it is between rounding and the size of a body. */
function growth(points, size) {
  const used = points.filter(([, value]) => value > FIT_FROM * size && value < FIT_TO * size);
  if (used.length < 8) return null;
  const mean = (k) => used.reduce((sum, one) => sum + (k === 0 ? one[0] : Math.log(one[1])), 0) / used.length;
  const [t0, l0] = [mean(0), mean(1)];
  const over = used.reduce((sum, [t, value]) => sum + (t - t0) * (Math.log(value) - l0), 0);
  const under = used.reduce((sum, [t]) => sum + (t - t0) ** 2, 0);
  const rate = over / under;
  return rate * (used.at(-1)[0] - used[0][0]) > 2 ? rate : null;
}
