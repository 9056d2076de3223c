// The time line: ticks, marks of events, where the runs end, the time shown; dragging it seeks.

import { fitCanvas, onDrag } from './canvas.js';
import { roundedUp, short } from './numbers.js';
import { colour } from './theme.js';

/** Room at both ends in CSS pixels, so that the handle is never cut off. */
const EDGE = 10;
/** Height of the bar and where it stands, in CSS pixels from above. */
const BAR_TOP = 15;
const BAR_HEIGHT = 6;
/** Least distance of ticks in CSS pixels. */
const TICK_PIXELS = 64;

export class Timeline {
  /** `marks` gives the events shown now: [{ t, colour }]. */
  constructor(canvas, playback, runs, marks, seek) {
    Object.assign(this, { canvas, playback, runs, marks, layer: document.createElement('canvas'), stale: true });
    onDrag(canvas, (x) => {
      const share = (x - EDGE) / (canvas.clientWidth - 2 * EDGE);
      seek(playback.start + share * playback.duration);
    });
    new ResizeObserver(() => this.refresh()).observe(canvas);
  }

  /** Draws all anew: after another size, another theme or another choice of events. */
  refresh() {
    this.stale = true;
    this.draw();
  }

  xOf(t, width) {
    const { start, duration } = this.playback;
    return EDGE + (duration > 0 ? (t - start) / duration : 0) * (width - 2 * EDGE);
  }

  draw() {
    const { pen, width, height } = fitCanvas(this.canvas);
    if (width === 0) return;
    if (this.stale) this.drawLayer(width, height);
    pen.clearRect(0, 0, width, height);
    pen.drawImage(this.layer, 0, 0, width, height);
    const x = this.xOf(this.playback.time, width);
    pen.fillStyle = colour('accent');
    pen.fillRect(EDGE, BAR_TOP, x - EDGE, BAR_HEIGHT);
    pen.beginPath();
    pen.arc(x, BAR_TOP + BAR_HEIGHT / 2, 7, 0, 2 * Math.PI);
    pen.fill();
    pen.lineWidth = 2;
    pen.strokeStyle = colour('page');
    pen.stroke();
    const { canvas, playback } = this;
    canvas.setAttribute('aria-valuemin', playback.start);
    canvas.setAttribute('aria-valuemax', playback.end);
    canvas.setAttribute('aria-valuenow', playback.time.toPrecision(6));
  }

  /** What does not change with the time. */
  drawLayer(width, height) {
    this.layer.width = this.canvas.width;
    this.layer.height = this.canvas.height;
    const pen = this.layer.getContext('2d');
    pen.scale(this.layer.width / width, this.layer.height / height);
    pen.fillStyle = colour('track');
    pen.fillRect(EDGE, BAR_TOP, width - 2 * EDGE, BAR_HEIGHT);
    this.drawMarks(pen, width);
    this.drawEnds(pen, width);
    this.drawTicks(pen, width);
    this.stale = false;
  }

  /** At most one mark of a colour for each pixel, so that ten thousand events cost no more than a few hundred. */
  drawMarks(pen, width) {
    const drawn = new Set();
    for (const { t, colour: ink } of this.marks()) {
      const x = Math.round(this.xOf(t, width));
      const key = `${x} ${ink}`;
      if (drawn.has(key)) continue;
      drawn.add(key);
      pen.fillStyle = ink;
      pen.fillRect(x - 0.5, 3, 1.5, BAR_TOP - 4);
    }
  }

  /** A line where a run stopped before the other or before its end. */
  drawEnds(pen, width) {
    pen.fillStyle = colour('bad');
    for (const run of this.runs) {
      const last = run.times.at(-1);
      if (last === undefined || !run.outcome.startsWith('failed')) continue;
      pen.fillRect(this.xOf(last, width) - 1, BAR_TOP - 4, 2, BAR_HEIGHT + 8);
    }
  }

  drawTicks(pen, width) {
    const { start, end, duration } = this.playback;
    if (!(duration > 0)) return;
    const step = roundedUp((duration * TICK_PIXELS) / (width - 2 * EDGE));
    pen.font = '11px system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.fillStyle = colour('quiet');
    for (let k = Math.ceil(start / step); k * step <= end * (1 + 1e-9); k += 1) {
      const x = this.xOf(k * step, width);
      pen.fillRect(x, BAR_TOP + BAR_HEIGHT + 2, 1, 4);
      pen.fillText(`${short(k * step)} s`, Math.min(width - 16, Math.max(14, x)), BAR_TOP + BAR_HEIGHT + 18);
    }
  }
}
