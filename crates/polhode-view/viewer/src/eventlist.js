// The list of events: filtered by kind; only the rows in sight exist, so that ten thousand events stay light.

import { eventColour } from './colours.js';
import { seconds } from './numbers.js';

/** Height of a row in CSS pixels; viewer.css sets the same. */
const ROW_PIXELS = 24;
/** Rows beyond the edges of the list that exist too. */
const SPARE_ROWS = 6;

export class EventList {
  /** `changed` is called when other kinds are shown, `seek` with the time of a chosen event. */
  constructor(holder, runs, duration, changed, seek) {
    this.duration = duration;
    this.seek = seek;
    const all = runs.flatMap((run) => run.events.map((event) => ({ ...event, run })));
    this.events = all.sort((one, other) => one.t - other.t);
    this.two_runs = runs.length > 1;
    this.kinds = [...new Set(this.events.map((event) => event.kind))].sort();
    this.hidden = new Set();
    this.chips = holder.querySelector('.chips');
    this.list = holder.querySelector('.rows');
    this.space = document.createElement('div');
    this.list.append(this.space);
    this.list.addEventListener('scroll', () => this.drawRows());
    new ResizeObserver(() => this.drawRows()).observe(this.list);
    holder.hidden = this.events.length === 0;
    this.buildChips(changed);
    this.filter();
  }

  inkOf(kind) {
    return eventColour(kind);
  }

  buildChips(changed) {
    for (const kind of this.kinds) {
      const chip = document.createElement('button');
      const count = this.events.filter((event) => event.kind === kind).length;
      chip.className = 'chip';
      chip.textContent = `${kind.replaceAll('_', ' ')} ${count}`;
      chip.style.setProperty('--ink', this.inkOf(kind));
      chip.setAttribute('aria-pressed', 'true');
      chip.addEventListener('click', () => {
        if (!this.hidden.delete(kind)) this.hidden.add(kind);
        chip.setAttribute('aria-pressed', String(!this.hidden.has(kind)));
        this.filter();
        changed();
      });
      this.chips.append(chip);
    }
  }

  filter() {
    this.shown = this.events.filter((event) => !this.hidden.has(event.kind));
    this.space.style.height = `${this.shown.length * ROW_PIXELS}px`;
    this.current = -1;
    this.drawRows();
  }

  /** What the time line marks. */
  marks() {
    return this.shown.map(({ t, kind }) => ({ t, colour: this.inkOf(kind) }));
  }

  /** The time of the next event after t, or of the last one before it; null where there is none. */
  neighbour(t, forward) {
    const found = forward ? this.shown.find((event) => event.t > t) : this.shown.findLast((event) => event.t < t);
    return found ? found.t : null;
  }

  /** Marks the last event at or before t, and keeps it in sight while the run plays. */
  update(t, playing) {
    let low = 0;
    let high = this.shown.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.shown[middle].t <= t) low = middle + 1;
      else high = middle;
    }
    if (low - 1 === this.current) return;
    this.current = low - 1;
    if (playing) {
      const wanted = this.current * ROW_PIXELS - this.list.clientHeight / 2;
      this.list.scrollTop = Math.max(0, wanted);
    }
    this.drawRows();
  }

  drawRows() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / ROW_PIXELS) - SPARE_ROWS);
    const count = Math.ceil(this.list.clientHeight / ROW_PIXELS) + 2 * SPARE_ROWS;
    const rows = this.shown.slice(first, first + count).map((event, k) => this.row(event, first + k));
    this.space.replaceChildren(...rows);
  }

  row(event, index) {
    const row = document.createElement('button');
    row.className = index === this.current ? 'row current' : 'row';
    row.style.top = `${index * ROW_PIXELS}px`;
    row.style.setProperty('--ink', this.inkOf(event.kind));
    const time = document.createElement('span');
    time.className = 'time';
    time.textContent = seconds(event.t, this.duration);
    const text = document.createElement('span');
    text.className = 'text';
    text.textContent = (this.two_runs ? `${event.run.name}: ` : '') + (event.text || event.kind);
    row.title = text.textContent;
    row.append(time, text);
    row.addEventListener('click', () => this.seek(event.t));
    return row;
  }
}
