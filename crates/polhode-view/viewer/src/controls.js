// The buttons and lists of the page that play, look and switch overlays.

import { CAMERAS } from './camera.js';
import { HELP } from './keyboard.js';
import { seconds } from './numbers.js';
import { OVERLAYS } from './overlays/index.js';
import { SPEEDS } from './playback.js';

/** Angular speed in rad/s of the clock of which a screen of 60 pictures a second shows the sense: half a turn a picture. */
const FASTEST_SEEN = 60 * Math.PI;

export const byId = (id) => document.getElementById(id);

/** A button with words, a title and what it does. */
function button(words, title, press) {
  const made = document.createElement('button');
  made.textContent = words;
  made.title = title;
  made.addEventListener('click', press);
  return made;
}

/** The row of playing; returns a function that shows the present state. */
export function playControls(playback, changed) {
  const on = (id, act) =>
    byId(id).addEventListener('click', () => {
      act();
      changed();
    });
  on('play', () => playback.toggle());
  on('back', () => playback.step(-1));
  on('forward', () => playback.step(1));
  on('loop', () => (playback.loop = !playback.loop));
  on('smooth', () => (playback.interpolate = !playback.interpolate));
  const speed = byId('speed');
  speed.replaceChildren(...SPEEDS.map((value) => new Option(`${value}×`, value)));
  speed.addEventListener('change', () => {
    playback.speed = Number(speed.value);
    changed();
  });
  return (frame, count, spin) => {
    byId('play').classList.toggle('playing', playback.playing);
    byId('play').setAttribute('aria-label', playback.playing ? 'Pause' : 'Play');
    byId('loop').setAttribute('aria-pressed', String(playback.loop));
    byId('smooth').setAttribute('aria-pressed', String(playback.interpolate));
    if (speed.value !== String(playback.speed)) speed.value = String(playback.speed);
    byId('time').textContent = seconds(playback.time, playback.duration);
    const blurred = playback.playing && spin * playback.speed > FASTEST_SEEN;
    const said = blurred ? '; it turns faster than this speed shows: slow down' : '';
    byId('frame').textContent = count > 0 ? `frame ${frame + 1} of ${count}${said}` : 'no frames';
  };
}

/** Buttons of the overlays; returns a function that shows which are on. */
export function overlayButtons(views, toggle) {
  const any_contacts = views.some((view) => view.run.contacts);
  const buttons = OVERLAYS.map(({ name, label, of_contacts }, index) => {
    const made = button(label, `${label} (key ${index + 1})`, () => toggle(name));
    made.className = 'toggle';
    made.dataset.overlay = name;
    made.disabled = of_contacts && !any_contacts;
    if (made.disabled) made.title = `${label}: this page holds no contacts`;
    return made;
  });
  byId('overlays').replaceChildren(...buttons);
  return (on) => buttons.forEach((made) => made.setAttribute('aria-pressed', String(on.has(made.dataset.overlay))));
}

/** Buttons of the camera presets. */
export function cameraButtons(look) {
  const words = { fit: 'Frame', home: 'Home', front: 'Front', side: 'Side', top: 'Top', iso: 'Iso' };
  const keys = { fit: 'Frame what is there now (F)', home: 'As at first (H)' };
  byId('cameras').append(...CAMERAS.map((name) => button(words[name], keys[name] ?? `Camera: ${words[name]}`, () => look(name))));
}

/** The list of bodies to follow; it is filled when it is first opened, since there may be thousands. */
export function followList(run, follow) {
  const list = byId('follow');
  const fill = () => {
    if (list.options.length > 2) return;
    const options = run.bodies.map((body, index) => new Option(body.name, index)).filter((_, k) => run.bodies[k].moves);
    list.replaceChildren(new Option('Follow: none', ''), ...options);
  };
  list.addEventListener('pointerdown', fill);
  list.addEventListener('focus', fill);
  list.addEventListener('change', () => follow(list.value === '' ? null : Number(list.value)));
  return (body) => {
    if (body !== null) fill();
    list.value = body === null ? '' : String(body);
  };
}

/** The key of colours of the overlays that are on, each colour once. */
export function showLegend(lines) {
  const of_colour = new Map();
  for (const { colour, text } of lines) {
    const texts = of_colour.get(colour) ?? [];
    if (!texts.includes(text)) of_colour.set(colour, [...texts, text]);
  }
  const words = [...of_colour].map(([colour, texts]) => `${colour}|${texts.join(' · ')}`);
  const legend = byId('legend');
  if (legend.dataset.words === words.join('\n')) return;
  legend.dataset.words = words.join('\n');
  legend.hidden = words.length === 0;
  const items = words.map((line) => {
    const item = document.createElement('li');
    const [ink, ...text] = line.split('|');
    item.style.setProperty('--ink', ink);
    item.textContent = text.join('|');
    return item;
  });
  legend.replaceChildren(...items);
}

/** The link that saves the JSON report, hidden where there is none. */
export function reportLink(text, title) {
  const link = byId('report');
  link.hidden = text === null;
  link.addEventListener('click', () => {
    link.href = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
    link.download = `${title.replace(/[^\p{L}\p{N}._-]+/gu, '-')}.json`;
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  });
}

/** The help and the button that opens it. */
export function helpDialog() {
  const dialog = byId('help');
  const rows = HELP.map(([keys, words]) => {
    const row = document.createElement('tr');
    const key = document.createElement('th');
    const what = document.createElement('td');
    key.textContent = keys;
    what.textContent = words;
    row.append(key, what);
    return row;
  });
  dialog.querySelector('table').replaceChildren(...rows);
  byId('help-button').addEventListener('click', () => dialog.showModal());
  return () => dialog.showModal();
}
