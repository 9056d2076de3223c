// The engine at work in a thread of its own: it steps ahead of the picture, and does what the page asks between steps.
//
// The script that wasm-bindgen makes stands before this one and gives `wasm_bindgen`. Messages of the page are
// { do, id, ... }; each is answered by { did, id, ... } or { did: 'fault', id, fault }. Frames come unasked.

/* global wasm_bindgen */

/** Frames are at least so far apart, s, and at most so many in a short scene. */
const FRAME_S = 1 / 120;
const FRAMES_OF_SHORT = 600;
/** The engine works for so long before it looks for messages, ms. */
const SLICE_MS = 12;

let own = null;
let epoch = 0;
let interval = FRAME_S;
let until = 0;
let beyond = false;
let steps = 0;
let marks = new Map();
let working = false;
let waiting = false;
let last = -Infinity;
let failed = false;
let batch = { times: [], poses: [] };
let used_ms = 0;

/** What was thrown, as { message, places }. */
function faultOf(error) {
  if (typeof error === 'string') {
    try {
      return JSON.parse(error);
    } catch {
      return { message: error, places: [] };
    }
  }
  return { message: `the engine stopped because of a mistake of its own: ${error?.message ?? error}`, places: [], grave: true };
}

function frame() {
  const t = own.time();
  batch.times.push(t);
  batch.poses.push(own.poses());
  last = t;
}

/** Hands the frames so far to the page. */
function send() {
  const times = Float64Array.from(batch.times);
  const length = batch.poses[0]?.length ?? 0;
  const poses = new Float64Array(length * times.length);
  batch.poses.forEach((one, index) => poses.set(one, index * length));
  batch = { times: [], poses: [] };
  const message = { did: 'frames', epoch, times, poses, steps, ended: own.ended(), now: own.time(), used_ms };
  message.held = own.held();
  postMessage(message, [times.buffer, poses.buffer]);
}

function mark() {
  if (!marks.has(steps)) return;
  const [hash] = own.hash().split(' ');
  postMessage({ did: 'mark', epoch, steps, hash, native: marks.get(steps), t: own.time() });
}

function work() {
  waiting = false;
  if (!own || failed) return;
  const begun = performance.now();
  const wants = () => own.time() < until && (beyond || !own.ended());
  working = wants();
  if (!working) return;
  try {
    while (wants() && performance.now() - begun < SLICE_MS) {
      const t = own.step();
      steps += 1;
      mark();
      if (t - last >= interval * (1 - 1e-9) || own.ended()) frame();
    }
  } catch (error) {
    failed = true;
    postMessage({ did: 'broke', epoch, fault: faultOf(error), now: last });
  }
  used_ms += performance.now() - begun;
  send();
  later();
}

/** Works on after the messages that have come by now. */
function later() {
  if (waiting) return;
  waiting = true;
  channel.port2.postMessage(null);
}

const channel = new MessageChannel();
channel.port1.onmessage = work;

/** Goes back to the time of the picture; `cut` also within a long step. */
function back(t, cut) {
  if (!(own.time() > t)) return;
  const reached = cut ? own.rewind_to(t) : own.rewind(t);
  failed = false;
  steps = own.steps();
  last = reached;
  until = Math.min(until, reached);
  postMessage({ did: 'cut', epoch, t: reached, poses: own.poses() });
}

const DOINGS = {
  async start({ module }) {
    await wasm_bindgen({ module_or_path: module });
    own = new wasm_bindgen.Playground();
    return {};
  },
  file({ name, bytes }) {
    own.add_file(name, bytes);
    return {};
  },
  load(asked) {
    postMessage({ did: 'begun', id: asked.id });
    const show = own.load(asked.text, asked.changes);
    epoch = asked.epoch;
    steps = 0;
    used_ms = 0;
    last = -Infinity;
    failed = false;
    beyond = false;
    until = 0;
    marks = new Map(asked.marks ?? []);
    batch = { times: [], poses: [] };
    const shown = JSON.parse(show);
    const duration = shown.runs[0].duration_s;
    interval = Math.min(FRAME_S, duration / FRAMES_OF_SHORT);
    let shifted = null;
    if (asked.shift) shifted = shiftOne(shown.runs[0].bodies, asked.shift);
    frame();
    send();
    return { show, surface: own.surface(), shifted };
  },
  ahead(asked) {
    until = asked.until;
    beyond = asked.beyond;
    later();
    return null;
  },
  act({ name, args, at }) {
    back(at, true);
    own[name](...args);
    last = -Infinity;
    beyond = true;
    later();
    return { surface: own.surface() };
  },
  pull({ args }) {
    own.pull(...args);
    return null;
  },
  ask({ name, args, at }) {
    if (at !== undefined) back(at, false);
    return { answer: own[name](...(args ?? [])) };
  },
};

/** Moves the first body that can be moved by so much; its name, or null where none can be. */
function shiftOne(bodies, by) {
  for (let body = 0; body < bodies.length; body += 1) {
    if (!bodies[body].moves) continue;
    try {
      own.shift(body, by);
      return bodies[body].name;
    } catch {
      // The next one may be free.
    }
  }
  return null;
}

onmessage = async ({ data }) => {
  try {
    const answer = await DOINGS[data.do](data);
    if (answer) postMessage({ did: data.do, id: data.id, ...answer });
  } catch (error) {
    postMessage({ did: 'fault', id: data.id, fault: faultOf(error) });
  }
};
