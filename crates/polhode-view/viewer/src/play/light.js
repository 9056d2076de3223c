// The promise of the method and the horizon as lights, and the hash beside that of the native program.

import { percent, worded } from './numbers.js';

/** An error above this part of a body is told by another light: there the horizon is too. */
const SMALL_ERROR = 0.01;

export class Lights {
  constructor(root) {
    this.promise = root.querySelector('#promise');
    this.horizon = root.querySelector('#horizon');
    this.hash = root.querySelector('#hash');
    this.native = null;
    this.marks = 0;
    this.differs = null;
  }

  /** The hash that the native program has made of this scene: { steps, hash, t }, or null where it has made none. */
  begin(native) {
    this.native = native;
    this.marks = 0;
    this.differs = null;
  }

  mark({ hash, native, t }) {
    if (hash === native) this.marks += 1;
    else this.differs ??= t;
  }

  show(told, now) {
    const worst = Object.entries(told.limits).reduce((most, one) => (one[1] > (most?.[1] ?? -1) ? one : most), null);
    this.promise.className = told.kept ? 'light good' : 'light bad';
    this.promise.querySelector('span').textContent = told.kept
      ? `Promise of ${told.tier} kept${worst && worst[1] > 0 ? `: ${worst[0]} at ${percent(worst[1])} of its limit` : ''}`
      : `Promise of ${told.tier} broken: ${told.broken[0]?.warning ?? told.warnings[0] ?? 'see the report'}`;
    const { horizon_s, estimated_error } = told;
    const beyond = horizon_s !== null && now > horizon_s;
    const known = estimated_error !== null;
    const small = known && estimated_error < SMALL_ERROR;
    this.horizon.className = beyond || (known && !small) ? 'light warn' : known ? 'light good' : 'light off';
    this.horizon.querySelector('span').textContent = beyond
      ? `Beyond the horizon at ${worded(horizon_s, 's')}: rounding alone decides; this is one of many outcomes`
      : estimated_error === null
        ? 'Error not estimated yet'
        : `Estimated error ${worded(estimated_error)} of a body${horizon_s === null ? '; no horizon met' : `; horizon at ${worded(horizon_s, 's')}`}`;
    this.showHash(told);
  }

  showHash(told) {
    const { native } = this;
    let state = 'light off';
    let words;
    if (!told.untouched) words = 'You have acted: the run is no longer that of the scene alone';
    else if (!native) words = 'Compare it with `polhode play SCENE --hash`';
    else if (this.differs !== null) {
      state = 'light bad';
      words = `differs from the native program, first before t = ${worded(this.differs, 's')}`;
    } else if (told.ended && native.hash === told.hash) {
      state = 'light good';
      words = `native ${native.hash}: the same bits, to the end`;
    } else if (told.ended && native.ended) {
      state = 'light bad';
      words = `native ${native.hash}: other bits`;
    } else if (this.marks > 0) {
      state = 'light good';
      words = `the same bits as the native program so far (${this.marks} of ${native.marks.length} places)`;
    } else words = 'not compared with the native program yet';
    this.hash.className = state;
    this.hash.querySelector('span').textContent = `Hash ${told.hash} – ${words}`;
  }
}
