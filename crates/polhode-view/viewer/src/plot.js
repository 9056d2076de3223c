// One plot: series of one group and one unit over the time, with a line at the time shown.
//
// Each series is drawn by its least and largest value in every column of pixels, so that a run of any length costs the
// same and no spike is lost. NaN makes a gap. On a logarithmic scale absolute values are drawn, and zeros are left out.

import { fitCanvas, onDrag } from './canvas.js';
import { SERIES_COLOURS } from './colours.js';
import { roundedUp, short } from './numbers.js';
import { colour } from './theme.js';

/** Room for the numbers at the left, and above and below, in CSS pixels. */
const LEFT = 58;
const RIGHT = 8;
const TOP = 6;
const BOTTOM = 8;
/** Groups that are drawn on a logarithmic scale when their values span at least this many decades. */
const LOG_GROUPS = ['ledger', 'penetration', 'residual', 'steps'];
const LOG_DECADES = 3;
/** Part of the largest value that an axis reaches beyond all values where these hardly differ. */
const LEAST_SPAN = 0.01;
/** Decades below the largest value that a logarithmic scale shows at most. */
const MOST_DECADES = 18;

export class Plot {
  /** `series` is [{ run, series }] of one group and unit; `seek` is called with a time. */
  constructor(group, unit, series, playback, seek) {
    Object.assign(this, { group, unit, playback, layer: document.createElement('canvas'), stale: true });
    const names = [...new Set(series.map((entry) => entry.series.name))];
    this.lines = series.map(({ run, frames, series: data }) => ({
      run,
      frames,
      name: data.name,
      values: data.values,
      hidden: false,
      ink: SERIES_COLOURS[names.indexOf(data.name) % SERIES_COLOURS.length],
    }));
    this.two_runs = new Set(series.map((entry) => entry.run)).size > 1;
    this.log = LOG_GROUPS.includes(group) && this.decades() >= LOG_DECADES;
    this.build(seek);
  }

  /** Decades between the least and the largest absolute value that is not zero. */
  decades() {
    let least = Infinity;
    let largest = 0;
    for (const { values } of this.lines) {
      for (const value of values) {
        const size = Math.abs(value);
        if (size > 0 && size < least) least = size;
        if (size < Infinity && size > largest) largest = size;
      }
    }
    return largest > 0 ? Math.log10(largest / least) : 0;
  }

  build(seek) {
    this.element = document.createElement('figure');
    this.element.className = 'plot';
    const head = document.createElement('figcaption');
    const title = document.createElement('span');
    title.textContent = this.unit ? `${this.group}, ${this.unit}` : this.group;
    this.scale_button = document.createElement('button');
    this.scale_button.className = 'small';
    this.scale_button.title = 'Linear or logarithmic scale';
    this.scale_button.addEventListener('click', () => {
      this.log = !this.log;
      this.refresh();
    });
    head.append(title, this.scale_button);
    this.canvas = document.createElement('canvas');
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', `${this.group} over time`);
    onDrag(this.canvas, (x) => {
      const share = (x - LEFT) / (this.canvas.clientWidth - LEFT - RIGHT);
      seek(this.playback.start + share * this.playback.duration);
    });
    this.element.append(head, this.canvas, this.buildKey());
    new ResizeObserver(() => this.refresh()).observe(this.canvas);
  }

  /** The names of the series with their values at the time shown; a click hides a series. */
  buildKey() {
    const key = document.createElement('ul');
    for (const line of this.lines) {
      const item = document.createElement('li');
      const name = document.createElement('button');
      const dashed = this.two_runs && line.run.index > 0;
      name.className = dashed ? 'series dashed' : 'series';
      name.style.setProperty('--ink', line.ink);
      name.textContent = this.two_runs ? `${line.name} · ${line.run.name}` : line.name;
      name.addEventListener('click', () => {
        line.hidden = !line.hidden;
        item.classList.toggle('off', line.hidden);
        this.refresh();
      });
      line.output = document.createElement('output');
      item.append(name, line.output);
      key.append(item);
    }
    return key;
  }

  refresh() {
    this.stale = true;
    this.draw();
  }

  draw() {
    for (const { output, values, run, frames } of this.lines) {
      const shown =
        run.times.length > 0 && this.playback.time <= run.times.at(-1) ? frames.frameAt(this.playback.time) : -1;
      const text = shown < 0 ? '–' : short(values[shown]);
      if (output.textContent !== text) output.textContent = text;
    }
    const { pen, width, height } = fitCanvas(this.canvas);
    if (width === 0) return;
    if (this.stale) this.drawLayer(width, height);
    pen.clearRect(0, 0, width, height);
    pen.drawImage(this.layer, 0, 0, width, height);
    pen.fillStyle = colour('accent');
    pen.fillRect(this.xOf(this.playback.time, width) - 0.75, TOP, 1.5, height - TOP - BOTTOM);
  }

  xOf(t, width) {
    const { start, duration } = this.playback;
    return LEFT + (duration > 0 ? (t - start) / duration : 0) * (width - LEFT - RIGHT);
  }

  /** A value on the axis: itself, or the logarithm of its size; NaN where it is not drawn. */
  onAxis(value) {
    if (!this.log) return Number.isFinite(value) ? value : NaN;
    return value === 0 || !Number.isFinite(value) ? NaN : Math.log10(Math.abs(value));
  }

  /** The span of the axis over all series that are shown. */
  span() {
    let low = Infinity;
    let high = -Infinity;
    for (const { values } of this.lines.filter((line) => !line.hidden)) {
      for (const value of values) {
        const place = this.onAxis(value);
        if (place < low) low = place;
        if (place > high) high = place;
      }
    }
    if (low > high) return [0, 1];
    if (this.log)
      return [
        Math.max(Math.floor(low), Math.ceil(high) - MOST_DECADES),
        Math.max(Math.ceil(high), Math.floor(low) + 1),
      ];
    // Values that hardly differ are one line: the labels tell no digits in which they do.
    const least = LEAST_SPAN * Math.max(Math.abs(low), Math.abs(high)) || 1;
    const room = high - low < least ? least : (high - low) * 0.05;
    return [low - room, high + room];
  }

  drawLayer(width, height) {
    this.scale_button.textContent = this.log ? 'log' : 'linear';
    this.layer.width = this.canvas.width;
    this.layer.height = this.canvas.height;
    const pen = this.layer.getContext('2d');
    pen.scale(this.layer.width / width, this.layer.height / height);
    const [low, high] = this.span();
    const yOf = (place) => height - BOTTOM - ((place - low) / (high - low)) * (height - TOP - BOTTOM);
    this.drawAxis(pen, low, high, yOf, width);
    pen.save();
    pen.beginPath();
    pen.rect(LEFT, TOP - 1, width - LEFT - RIGHT, height - TOP - BOTTOM + 2);
    pen.clip();
    for (const line of this.lines) if (!line.hidden) this.drawLine(pen, line, yOf, width);
    pen.restore();
    this.stale = false;
  }

  drawAxis(pen, low, high, yOf, width) {
    const step = this.log ? Math.max(1, Math.ceil((high - low) / 5)) : roundedUp((high - low) / 5);
    pen.font = '10.5px system-ui, sans-serif';
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (let k = Math.ceil(low / step); k * step <= high + step * 1e-9; k += 1) {
      const y = yOf(k * step);
      pen.fillStyle = colour('rule');
      pen.fillRect(LEFT, y, width - LEFT - RIGHT, 1);
      pen.fillStyle = colour('quiet');
      pen.fillText(this.log ? short(10 ** (k * step), 3) : short(Number((k * step).toPrecision(12))), LEFT - 5, y);
    }
  }

  drawLine(pen, { run, values, ink }, yOf, width) {
    pen.strokeStyle = ink;
    pen.lineWidth = 1.4;
    // Round ends make a dot of a single value between gaps.
    pen.lineCap = pen.lineJoin = 'round';
    pen.setLineDash(this.two_runs && run.index > 0 ? [4, 3] : []);
    pen.beginPath();
    let pen_down = false;
    let column = null;
    const flush = () => {
      if (!column) return;
      // In the order met inside the column: first, the two extremes, last.
      const { x, first, least, most, last } = column;
      for (const place of least.at < most.at ? [first, least, most, last] : [first, most, least, last]) {
        if (pen_down) pen.lineTo(x, yOf(place.value));
        else pen.moveTo(x, yOf(place.value));
        pen_down = true;
      }
      column = null;
    };
    for (let at = 0; at < values.length; at += 1) {
      const value = this.onAxis(values[at]);
      if (Number.isNaN(value)) {
        flush();
        pen_down = false;
        continue;
      }
      const exact = this.xOf(run.times[at], width);
      const point = { value, at };
      if (column && Math.floor(exact) !== column.pixel) flush();
      if (!column)
        column = { pixel: Math.floor(exact), x: exact, first: point, least: point, most: point, last: point };
      if (value < column.least.value) column.least = point;
      if (value > column.most.value) column.most = point;
      column.last = point;
    }
    flush();
    pen.stroke();
  }
}
