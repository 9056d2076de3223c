// One copy of the engine: its worker, what it was asked, and the frames that it has made.

import { Track } from './track.js';

/** A worker that has not answered for so long is stuck in a step, ms. */
const STUCK_MS = 10000;
/** A worker that has not begun to load a scene after so long is in a step of the one before, which nobody waits for, ms. */
const STEP_MS = 1500;

/** What the engine refuses: { message, places: [{ line, column, key, words }] }. */
export class Fault extends Error {
  constructor({ message, places, grave }) {
    super(message);
    this.places = places ?? [];
    this.grave = Boolean(grave);
  }
}

export class Engine {
  /** `source` is the text of the worker, `module` the compiled engine; `tell` has mark() and broke(). */
  constructor(source, module, tell) {
    this.source = source;
    this.module = module;
    this.tell = tell;
    this.files = new Map();
    this.begin();
  }

  begin() {
    this.url = URL.createObjectURL(new Blob([this.source], { type: 'text/javascript' }));
    this.worker = new Worker(this.url);
    /** The number of the scene that runs, and of the last that was asked for. */
    this.epoch = 0;
    this.asked_epoch = 0;
    /** First frames of scenes whose loading has not been answered yet. */
    this.early = new Map();
    this.id = 0;
    this.open = new Map();
    this.track = null;
    this.heard = performance.now();
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.failAll(new Fault({ message: `the engine could not be started: ${event.message || 'the worker was refused'}`, grave: true }));
    };
    this.started = this.ask({ do: 'start', module: this.module }).then(() =>
      Promise.all([...this.files].map(([name, bytes]) => this.ask({ do: 'file', name, bytes }))),
    );
    this.started.catch(() => {});
  }

  /** Ends the worker, with whatever step it is in, and begins another one. */
  restart() {
    this.end();
    this.begin();
  }

  end() {
    this.worker.terminate();
    URL.revokeObjectURL(this.url);
    this.failAll(new Fault({ message: 'the engine was stopped' }));
  }

  failAll(fault) {
    for (const { refuse } of this.open.values()) refuse(fault);
    this.open.clear();
  }

  /** Sends a message; the promise of its answer. */
  ask(message) {
    this.id += 1;
    const { id } = this;
    if (this.open.size === 0) this.heard = performance.now();
    return new Promise((answer, refuse) => {
      this.open.set(id, { answer, refuse });
      this.worker.postMessage({ ...message, id });
    });
  }

  /** Sends a message that is not answered. */
  send(message) {
    this.worker.postMessage(message);
  }

  /** Whether it has been silent for too long over something that was asked. */
  isStuck() {
    const asked = this.open.size > 0 || (this.track && this.track.wanted > this.track.now && !this.track.done);
    return asked && performance.now() - this.heard > STUCK_MS;
  }

  hear(data) {
    this.heard = performance.now();
    if (data.did === 'frames') {
      if (data.epoch === this.epoch) this.track?.add(data);
      else if (data.epoch > this.epoch) this.early.set(data.epoch, data);
      return;
    }
    if (data.did === 'cut') {
      if (data.epoch === this.epoch) this.track?.cut(data.t, data.poses);
      return;
    }
    if (data.did === 'mark') {
      if (data.epoch === this.epoch) this.tell.mark?.(data);
      return;
    }
    if (data.did === 'broke') {
      if (data.epoch === this.epoch) {
        if (this.track) this.track.done = true;
        this.tell.broke?.(new Fault(data.fault), this);
      }
      return;
    }
    const asked = this.open.get(data.id);
    if (!asked) return;
    if (data.did === 'begun') {
      asked.begun = true;
      return;
    }
    this.open.delete(data.id);
    if (data.did === 'fault') asked.refuse(new Fault(data.fault));
    else asked.answer(data);
  }

  addFile(name, bytes) {
    this.files.set(name, bytes);
    return this.ask({ do: 'file', name, bytes });
  }

  /** Loads a scene; what the page shows of it. The one before goes on where this one is refused. */
  async load(text, changes, { shift = 0, marks = [] } = {}) {
    this.asked_epoch += 1;
    const epoch = this.asked_epoch;
    const answered = this.ask({ do: 'load', text, changes: changes.join('\n'), epoch, shift, marks });
    const asked = this.open.get(this.id);
    const waited = new Promise((over) => setTimeout(over, STEP_MS, 'waited'));
    const came = await Promise.race([answered.catch(() => null), waited]);
    if (came === 'waited' && !asked.begun) {
      this.restart();
      await this.started;
      return this.load(text, changes, { shift, marks });
    }
    const answer = await answered;
    const show = JSON.parse(answer.show);
    this.epoch = epoch;
    this.track = new Track(show.runs[0]);
    const first = this.early.get(epoch);
    this.early.clear();
    if (first) this.track.add(first);
    return { show, surface: answer.surface, shifted: answer.shifted };
  }

  /** Lets it compute up to a time, beyond the end of the scene's duration where `beyond`. */
  goTo(until, beyond) {
    if (!this.track || (this.track.wanted >= until && this.track.beyond === beyond)) return;
    if (this.track.now >= this.track.wanted) this.heard = performance.now();
    this.track.wanted = until;
    this.track.beyond = beyond;
    this.send({ do: 'ahead', until, beyond });
  }

  /** Does something at the time of the picture; what was computed beyond it is forgotten. */
  act(name, args, at) {
    if (this.track) {
      this.track.done = false;
      this.track.wanted = at;
    }
    return this.ask({ do: 'act', name, args, at });
  }
}
