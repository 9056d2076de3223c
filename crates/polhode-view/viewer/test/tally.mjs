// What the checks of pages found: a line for each, as words or as JSON.

/** Kinds of check, in the order in which a table shows them. */
export const KINDS = {
  opening: 'a page opens',
  console: 'no console error',
  blank: 'the canvas is not blank',
  picture: 'the picture is the committed one',
  scrubbing: 'scrubbing changes the picture',
  overlays: 'overlays switch',
  keyboard: 'the keyboard works',
  cameras: 'cameras change the picture',
  following: 'a click shows numbers, a double click follows',
  layouts: 'two runs side by side or overlaid',
  look: 'light, dark and phone width',
  report: 'the report is saved',
  events: 'events are jumped to',
  playing: 'playing goes on',
  words: 'what is wrong is said in words',
};

export class Tally {
  /** `as_json`: every line is an object, for a program to read. */
  constructor(as_json) {
    this.as_json = as_json;
    this.passed = 0;
    this.failed = 0;
  }

  /** A check of one of the KINDS on a page; `detail` says what was measured. */
  check(kind, page, what, good, detail = '') {
    if (!(kind in KINDS)) throw new Error(`no kind of check is named ${kind}`);
    if (good) this.passed += 1;
    else this.failed += 1;
    if (this.as_json) console.log(JSON.stringify({ kind: KINDS[kind], page, what, good: Boolean(good), detail }));
    else console.log(`${good ? 'ok    ' : 'FAILED'} ${page}: ${what}${detail ? ` (${detail})` : ''}`);
  }

  /** A number that is shown and never decides. */
  figure(page, what, number, unit) {
    if (this.as_json) console.log(JSON.stringify({ figure: what, page, number, unit }));
    else console.log(`figure ${page}: ${what} ${number.toFixed(0)} ${unit}`);
  }

  note(page, words) {
    if (!this.as_json) console.log(`note   ${page}: ${words}`);
  }

  /** The last line; true when nothing failed. */
  close() {
    if (!this.as_json) console.log(`${this.passed} passed, ${this.failed} failed`);
    return this.failed === 0;
  }
}
