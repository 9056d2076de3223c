// The frames of one copy: poses of all bodies at the times that were computed, and the poses at any time between.

/** Numbers of a pose: place and quaternion. */
const NUMBERS = 7;
/** Bytes of the frames that are kept at the most; then the earliest are forgotten. */
const MOST_BYTES = 256 * 1024 * 1024;

export class Track {
  constructor(run) {
    this.width = NUMBERS * run.bodies.length;
    this.duration = run.duration_s;
    this.times = [];
    this.frames = [];
    this.now = 0;
    this.wanted = 0;
    this.beyond = false;
    this.ended = false;
    this.done = false;
    this.held = [];
    this.steps = 0;
    this.used_ms = 0;
  }

  get first() {
    return this.times[0] ?? 0;
  }

  /** The last time that can be shown. */
  get end() {
    return this.times.at(-1) ?? 0;
  }

  add({ times, poses, ended, now, held, steps, used_ms }) {
    times.forEach((t, index) => {
      if (this.times.length > 0 && t < this.end) return;
      if (t === this.end && this.times.length > 0) {
        this.times.pop();
        this.frames.pop();
      }
      this.times.push(t);
      this.frames.push(poses.subarray(index * this.width, (index + 1) * this.width));
    });
    Object.assign(this, { ended, now, held, steps, used_ms });
    if (this.times.length * this.width * 8 > MOST_BYTES) {
      const half = this.times.length >> 1;
      this.times.splice(0, half);
      this.frames.splice(0, half);
    }
  }

  /** Forgets what follows a time, which has these poses. */
  cut(t, poses) {
    const kept = this.times.findLastIndex((time) => time < t) + 1;
    this.times.length = kept;
    this.frames.length = kept;
    this.times.push(t);
    this.frames.push(poses);
    this.now = t;
    this.ended = false;
    this.done = false;
    this.wanted = t;
  }

  /** Writes the poses at a time. */
  at(t, out) {
    const { times, frames, width } = this;
    if (times.length === 0) return;
    let low = 0;
    let high = times.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle;
      else high = middle;
    }
    const span = (times[low + 1] ?? times[low]) - times[low];
    const part = span > 0 ? Math.min(1, Math.max(0, (t - times[low]) / span)) : 0;
    const before = frames[low];
    if (part === 0) {
      out.set(before);
      return;
    }
    const after = frames[low + 1];
    for (let at = 0; at < width; at += NUMBERS) {
      for (let k = 0; k < 3; k += 1) out[at + k] = before[at + k] + part * (after[at + k] - before[at + k]);
      let dot = 0;
      for (let k = 3; k < NUMBERS; k += 1) dot += before[at + k] * after[at + k];
      const sign = dot < 0 ? -1 : 1;
      let size = 0;
      for (let k = 3; k < NUMBERS; k += 1) {
        out[at + k] = before[at + k] + part * (sign * after[at + k] - before[at + k]);
        size += out[at + k] ** 2;
      }
      size = Math.sqrt(size) || 1;
      for (let k = 3; k < NUMBERS; k += 1) out[at + k] /= size;
    }
  }

  /** The largest distance of a body's origin from that of another track at a time of its frames, m. */
  distance(other, t, moving) {
    const own = new Float64Array(this.width);
    const theirs = new Float64Array(other.width);
    this.at(t, own);
    other.at(t, theirs);
    let largest = 0;
    for (const body of moving) {
      const at = NUMBERS * body;
      largest = Math.max(largest, Math.hypot(own[at] - theirs[at], own[at + 1] - theirs[at + 1], own[at + 2] - theirs[at + 2]));
    }
    return largest;
  }
}
