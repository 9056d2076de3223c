// Buttons, sliders, lists and keys.

import { byId } from '../controls.js';
import { wordsOf } from '../errors.js';
import { seconds } from '../numbers.js';
import { worded } from './numbers.js';
import { packedText } from './packed.js';

/** Simulated seconds for each second of the clock. */
export const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

const TIERS = [
  ['', 'scene’s'],
  ['accurate', 'accurate'],
  ['stepped', 'stepped'],
  ['fast', 'fast'],
  ['thesis', 'thesis'],
];
const LAWS = [
  ['', 'scene’s'],
  ['propagation', 'propagation'],
  ['simultaneous', 'simultaneous'],
  ['reflection', 'reflection'],
  ['poisson', 'poisson'],
  ['energetic', 'energetic'],
  ['pulse', 'pulse'],
];

const KEYS = [
  ['Space', 'run or pause'],
  ['R', 'from the start'],
  ['← →', 'back or on by a hundredth of what was run; with Shift a tenth'],
  ['↑ ↓', 'faster, slower'],
  ['N', 'look at the next body: the forces on it'],
  ['P', 'push the body that is looked at'],
  ['T', 'ghost of truth'],
  ['C', 'second copy'],
  ['F', 'fit all into the picture'],
  ['H', 'look as at first'],
  ['E', 'to the text'],
  ['Esc', 'look at no body; out of the text'],
  ['?', 'this help'],
];

export function helpRows(table) {
  for (const [key, words] of KEYS) {
    const row = table.insertRow();
    row.insertCell().textContent = key;
    row.insertCell().textContent = words;
  }
}

function options(id, list) {
  byId(id).replaceChildren(...list.map(([value, words]) => new Option(words, value)));
}

/** A slider that tells its value while it moves, and acts when it stands. */
function slider(id, act) {
  const input = byId(id);
  const output = input.parentElement.querySelector('output');
  let timer = null;
  input.addEventListener('input', () => {
    output.textContent = worded(Number(input.value));
    clearTimeout(timer);
    timer = setTimeout(() => act(Number(input.value)), 80);
  });
  return (value) => {
    if (document.activeElement === input && timer !== null && input.matches(':active')) return;
    if (!(value <= Number(input.max))) input.max = String(Math.ceil(value));
    input.value = String(value);
    output.textContent = worded(value);
  };
}

export function buildControls(playground) {
  const on = (id, act) => byId(id).addEventListener('click', act);
  options('tier', TIERS);
  options('law', LAWS);
  options('speed', SPEEDS.map((speed) => [speed, `${speed}×`]));
  byId('tier').addEventListener('change', () => playground.run());
  byId('law').addEventListener('change', () => playground.run());
  byId('speed').addEventListener('change', () => (playground.speed = Number(byId('speed').value)));
  on('play', () => playground.toggle());
  on('restart', () => playground.restart());
  on('truth', () => playground.setCopy('truth', byId('truth').getAttribute('aria-pressed') !== 'true'));
  on('twin', () => playground.setCopy('twin', byId('twin').getAttribute('aria-pressed') !== 'true'));
  on('push', () => playground.push());
  on('let-go', () => playground.select(null));
  on('save', () => playground.saveText());
  on('link', () => playground.link());
  on('help-button', () => byId('help').showModal());
  on('licences', showLicences);
  const scrub = byId('scrub');
  scrub.addEventListener('input', () => {
    playground.pause();
    playground.seek(Number(scrub.value));
  });
  cameras(playground);
  examples(playground);
  const showFriction = slider('friction', (value) => playground.setFriction(value));
  const showRestitution = slider('restitution', (value) => playground.setRestitution(value));
  return {
    showSurface([friction, restitution]) {
      showFriction(friction);
      showRestitution(restitution);
    },
    showSpeed(speed) {
      byId('speed').value = String(speed);
    },
    showTime({ time, playing }, track) {
      const end = Math.max(track.end, Math.min(track.duration, track.end + 1e-9));
      scrub.min = String(track.first);
      scrub.max = String(end);
      if (!scrub.matches(':active')) scrub.value = String(time);
      scrub.setAttribute('aria-valuetext', `${worded(time)} s of ${worded(track.duration)} s`);
      byId('time').textContent = seconds(time, track.duration);
      byId('play').classList.toggle('playing', playing);
      byId('play').setAttribute('aria-label', playing ? 'Pause' : 'Run');
    },
    showPace(track) {
      if (!(track.used_ms > 0)) return;
      const rate = (track.steps / track.used_ms) * 1000;
      const real = track.now / (track.used_ms / 1000);
      byId('pace').textContent =
        `${worded(track.steps)} steps, ${worded(rate)} steps/s in the worker: ${worded(real)} s of motion in a second.`;
    },
  };
}

/** The licences of what the page contains, below the keys. */
async function showLicences() {
  const texts = byId('licence-texts');
  texts.textContent = await packedText('polhode-licences', 'The licences').catch(wordsOf);
  texts.hidden = false;
  texts.scrollIntoView();
}

function cameras(playground) {
  const made = [
    ['Home', 'home'],
    ['Fit', 'fit'],
    ['Front', 'front'],
    ['Side', 'side'],
    ['Top', 'top'],
  ].map(([words, name]) => {
    const button = document.createElement('button');
    button.textContent = words;
    button.title = `Look from: ${name}`;
    button.addEventListener('click', () => playground.picture.fit(name));
    return button;
  });
  byId('cameras').replaceChildren(...made);
}

/** The shipped scenes that the page holds. */
function examples(playground) {
  const list = playground.given.examples ?? [];
  const select = byId('examples');
  select.hidden = list.length === 0;
  select.append(...list.map(({ name, title }) => new Option(title || name, name)));
  select.addEventListener('change', () => {
    const found = list.find(({ name }) => name === select.value);
    select.value = '';
    if (found) playground.take(found.text);
  });
}

export function listenForKeys(playground) {
  const step = (part) => {
    playground.pause();
    const { track } = playground.engine;
    playground.seek(playground.time + part * (track.end - track.first));
  };
  const speed = (places) => {
    const at = Math.min(SPEEDS.length - 1, Math.max(0, SPEEDS.indexOf(playground.speed) + places));
    playground.speed = SPEEDS[at];
    byId('speed').value = String(SPEEDS[at]);
  };
  const press = (id) => byId(id).click();
  const next = () => {
    const { moving } = playground.picture.run;
    const at = moving.indexOf(playground.picture.selected);
    if (moving.length > 0) playground.pick(moving[(at + 1) % moving.length]);
  };
  const actions = {
    ' ': () => playground.toggle(),
    r: () => playground.restart(),
    ArrowLeft: (event) => step(event.shiftKey ? -0.1 : -0.01),
    ArrowRight: (event) => step(event.shiftKey ? 0.1 : 0.01),
    ArrowUp: () => speed(1),
    ArrowDown: () => speed(-1),
    n: next,
    p: () => playground.push(),
    t: () => press('truth'),
    c: () => press('twin'),
    f: () => playground.picture.fit('fit'),
    h: () => playground.picture.fit('home'),
    e: () => playground.editor.area.focus(),
    Escape: () => playground.select(null),
    '?': () => byId('help').showModal(),
  };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !playground.engine?.track) return;
    if (event.key === 'Escape' && event.target === playground.editor.area) {
      playground.editor.area.blur();
      return;
    }
    if (event.target.closest?.('select, input, textarea, dialog')) return;
    const action = actions[event.key] ?? actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action(event);
  });
  document.addEventListener('keyup', (event) => {
    if (event.key === ' ' && event.target.closest?.('button')) event.preventDefault();
  });
}
