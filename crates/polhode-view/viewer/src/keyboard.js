// The keyboard.

import { OVERLAYS } from './overlays/index.js';

/** What each key does, for the help. */
export const HELP = [
  ['Space', 'play or pause'],
  ['← →', 'a frame back or on; with Shift ten'],
  ['↑ ↓', 'faster, slower'],
  ['Home End', 'to the start, to the end'],
  ['[ ]', 'to the event before, to the next event'],
  ['L', 'play in a loop'],
  ['I', 'interpolate between frames'],
  ['F', 'frame what is there now'],
  ['H', 'look as at first'],
  ['Esc', 'follow no body, show no numbers'],
  ...OVERLAYS.map(({ label }, index) => [String(index + 1), label]),
  ['?', 'this help'],
];

/** Frames of a step with Shift. */
const LONG_STEP = 10;

/** `act` holds what the keys do: { playback, seek, changed, event, fit, home, unfollow, overlay, help }. */
export function listen(act) {
  const { playback } = act;
  const actions = {
    ' ': () => playback.toggle(),
    ArrowRight: (event) => playback.step(event.shiftKey ? LONG_STEP : 1),
    ArrowLeft: (event) => playback.step(event.shiftKey ? -LONG_STEP : -1),
    ArrowUp: () => playback.changeSpeed(1),
    ArrowDown: () => playback.changeSpeed(-1),
    Home: () => playback.seek(playback.start),
    End: () => playback.seek(playback.end),
    '[': () => act.event(false),
    ']': () => act.event(true),
    l: () => (playback.loop = !playback.loop),
    i: () => (playback.interpolate = !playback.interpolate),
    f: () => act.fit(),
    h: () => act.home(),
    Escape: () => act.unfollow(),
    '?': () => act.help(),
  };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.closest?.('select, input, dialog')) return;
    // Space and arrows would press the button or scroll the list that has the focus; here they always play and step.
    const digit = Number(event.key) - 1;
    const action = actions[event.key] ?? actions[event.key.toLowerCase()];
    if (OVERLAYS[digit]) act.overlay(OVERLAYS[digit].name);
    else if (action) action(event);
    else return;
    event.preventDefault();
    act.changed();
  });
  // A button lets go of the focus after a press of the mouse, so that Space does not press it again.
  document.addEventListener('keyup', (event) => {
    if (event.key === ' ' && event.target.closest?.('button')) event.preventDefault();
  });
}
