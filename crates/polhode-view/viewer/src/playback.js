// The time that is shown: play, pause, step, speed, loop.

/** Simulated seconds for each second of the clock. */
export const SPEEDS = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20];
/** A run shorter than this is slowed down at first, a longer one than the other sped up, in s of the clock. */
const SHORTEST = 2;
const LONGEST = 120;

export class Playback {
  constructor(runs) {
    const all = runs.filter((run) => run.times.length > 0);
    this.start = all.length > 0 ? Math.min(...all.map((run) => run.times[0])) : 0;
    this.end = all.length > 0 ? Math.max(...all.map((run) => run.times.at(-1))) : 0;
    /** Steps go by the frames of the run with the most of them. */
    this.times = runs.reduce((best, run) => (run.times.length > best.times.length ? run : best)).times;
    this.time = this.start;
    this.playing = false;
    this.loop = false;
    this.interpolate = true;
    this.speed = this.firstSpeed();
  }

  get duration() {
    return this.end - this.start;
  }

  firstSpeed() {
    const slow = SPEEDS.find((speed) => this.duration / speed <= LONGEST) ?? SPEEDS.at(-1);
    if (slow > 1) return slow;
    return SPEEDS.findLast((speed) => speed <= 1 && this.duration / speed >= SHORTEST) ?? SPEEDS[0];
  }

  play() {
    if (this.time >= this.end) this.time = this.start;
    this.playing = this.duration > 0;
  }

  pause() {
    this.playing = false;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  seek(t) {
    if (Number.isFinite(t)) this.time = Math.min(this.end, Math.max(this.start, t));
  }

  /** Goes `count` frames on (or back), and pauses. */
  step(count) {
    this.pause();
    if (this.times.length === 0) return;
    // The frame at or before the time; going back from between two frames leads to the earlier one.
    let at = this.times.findLastIndex((time) => time <= this.time);
    if (count < 0 && this.times[at] < this.time) at += 1;
    this.seek(this.times[Math.min(this.times.length - 1, Math.max(0, at + count))]);
  }

  /** The speed `steps` places on in the list. */
  changeSpeed(steps) {
    const at = SPEEDS.indexOf(this.speed) + steps;
    this.speed = SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, at))];
  }

  /** Advances by seconds of the clock where `ready(t)` says that the picture of the new time can be drawn. */
  advance(clock_s, ready) {
    if (!this.playing) return;
    let next = this.time + clock_s * this.speed;
    if (next >= this.end && this.loop) next = this.start + ((next - this.start) % this.duration);
    next = Math.min(this.end, next);
    if (!ready(next)) return;
    this.time = next;
    if (next >= this.end && !this.loop) this.pause();
  }
}
