// The state of a run at one time: poses, velocities, motion kinds, islands and contacts.
//
// Between the frames before and after the time, positions and velocities are interpolated straight, and orientations by the
// angular velocities of both, so that a body that turns fast turns forwards. Kinds, islands and contacts are those of the frame before: nothing is known of them in between.

import { CHANNELS, CONTACT_WORDS, JOINT_LOAD, NO_ISLAND } from './decode.js';
import { matrixOf, normalise, turn, turnBetween } from './rotation.js';

const turned = new Float64Array(9);

/** The centre of mass in the world of a body whose pose stands at `at`. */
export function centreAt(body, poses, at) {
  const from_origin = turn(matrixOf(poses, at + 3, turned), body.center_of_mass);
  return from_origin.map((value, k) => value + poses[at + k]);
}

/** Motion kind of a body that rests. */
export const AT_REST = 3;

export class Snapshot {
  constructor(run, frames) {
    this.run = run;
    this.frames = frames;
    this.frame = 0;
    this.time = run.times[0] ?? 0;
    /** [px py pz qw qx qy qz] of every body. */
    this.poses = Float64Array.from(run.initial);
    /** [vx vy vz wx wy wz] of every body. */
    this.rates = new Float64Array(6 * run.bodies.length);
    const [metre, unit, speed, spin] = run.quanta;
    this.units = [metre, metre, metre, unit, unit, unit, unit, speed, speed, speed, spin, spin, spin];
    this.before = new Float64Array(CHANNELS);
    this.after = new Float64Array(CHANNELS);
    this.chunk = null;
    this.chunk_frame = 0;
    this.place_of = new Map(run.moving.map((body, place) => [body, place]));
    for (let body = 0; body < run.bodies.length; body += 1) normalise(this.poses, 7 * body + 3);
  }

  /**
   * Moves the snapshot to the time t. False where frames are still being unpacked: then it stays as it is, or stands at
   * the frame before.
   */
  moveTo(t, interpolate) {
    const { times } = this.run;
    if (times.length === 0) return true;
    const frame = this.frames.frameAt(t);
    const index = this.frames.chunkOf(frame);
    const chunk = this.frames.chunk(index);
    this.time = t;
    if (!chunk) return this.frames.broken.has(index);
    this.frame = frame;
    this.chunk = chunk;
    this.chunk_frame = frame - this.run.chunks[index].first;
    const span = (times[frame + 1] ?? 0) - times[frame];
    const fraction = interpolate && span > 0 ? Math.min(1, Math.max(0, (t - times[frame]) / span)) : 0;
    const next = fraction > 0 ? this.frameCell(frame + 1) : null;
    this.run.moving.forEach((body, place) => this.moveBody(body, place, next, fraction, span));
    return fraction === 0 || next !== null || this.frames.broken.has(this.frames.chunkOf(frame + 1));
  }

  /** The chunk and the place in it of a frame, or null while it is not unpacked. */
  frameCell(frame) {
    const index = this.frames.chunkOf(frame);
    const chunk = this.frames.chunk(index);
    return chunk ? { chunk, at: frame - this.run.chunks[index].first } : null;
  }

  moveBody(body, place, next, fraction, span) {
    const { before, after, poses, rates } = this;
    this.readState(this.chunk, this.chunk_frame, place, before);
    if (next) {
      this.readState(next.chunk, next.at, place, after);
      const mean = [10, 11, 12].map((k) => 0.5 * (before[k] + after[k]));
      turnBetween(before, 3, before.slice(3, 7), after.slice(3, 7), mean, span, fraction);
      for (let k = 0; k < CHANNELS; k += 1) {
        if (k < 3 || k > 6) before[k] += fraction * (after[k] - before[k]);
      }
    }
    for (let k = 0; k < 7; k += 1) poses[7 * body + k] = before[k];
    for (let k = 0; k < 6; k += 1) rates[6 * body + k] = before[7 + k];
  }

  /** All channels of one body in one frame, in their units. */
  readState(chunk, frame, place, out) {
    const bodies = this.run.moving.length;
    for (let k = 0; k < CHANNELS; k += 1) {
      out[k] = chunk.values[(k * bodies + place) * chunk.frames + frame] * this.units[k];
    }
    normalise(out, 3);
  }

  /** The largest angular speed of a body, rad/s. */
  fastestSpin() {
    let largest = 0;
    for (let at = 0; at < this.rates.length; at += 6) {
      largest = Math.max(largest, Math.hypot(this.rates[at + 3], this.rates[at + 4], this.rates[at + 5]));
    }
    return largest;
  }

  /** The place of a body's centre of mass in the world, m. */
  centreOf(body) {
    return centreAt(this.run.bodies[body], this.poses, 7 * body);
  }

  /** The motion kind of a body, or null where none is known. */
  kindOf(body) {
    const place = this.place_of.get(body);
    if (!this.chunk?.kinds || place === undefined) return null;
    return this.chunk.kinds[place * this.chunk.frames + this.chunk_frame];
  }

  /** The island number of a body, or null where it is in none. */
  islandOf(body) {
    const place = this.place_of.get(body);
    if (!this.chunk?.islands || place === undefined) return null;
    const island = this.chunk.islands[place * this.chunk.frames + this.chunk_frame];
    return island === NO_ISLAND ? null : island;
  }

  /** Calls visit(a, b, numbers, at) for each contact; numbers[at...] is point, normal, separation, force. */
  eachContact(visit) {
    this.eachRecord((a, ...record) => {
      if (a !== JOINT_LOAD) visit(a, ...record);
    });
  }

  /** Calls visit(joint, numbers, at) for the load of each joint; numbers[at...] is point, direction, NaN, force. */
  eachJointLoad(visit) {
    this.eachRecord((a, joint, numbers, at) => {
      if (a === JOINT_LOAD) visit(joint, numbers, at);
    });
  }

  eachRecord(visit) {
    if (!this.chunk?.contacts) return;
    const { contact_start, contacts } = this.chunk;
    for (let k = contact_start[this.chunk_frame]; k < contact_start[this.chunk_frame + 1]; k += 1) {
      const word = k * CONTACT_WORDS;
      visit(contacts.indices[word], contacts.indices[word + 1], contacts.numbers, word + 2);
    }
  }
}
