// Reads the page and starts the viewer; whatever fails is said in words in the page.

import { byId, reportLink } from './controls.js';
import { wordsOf } from './errors.js';
import { notice, showFailure, tellCrowded, tellOutcome } from './notices.js';
import { readShow, reports, reportText } from './show.js';
import { showMechanism } from './panel.js';
import { Viewer } from './viewer.js';

/** The page's interface for tests and for the browser's console. */
function publish(viewer, ready) {
  window.polhode = {
    ready,
    time: () => viewer.playback.time,
    frame: () => viewer.views[0].snapshot.frame,
    seek: viewer.seek,
    play: () => viewer.playback.play(),
    pause: () => viewer.playback.pause(),
    setOverlay: (name, on) => {
      viewer.setOverlay(name, on);
      return viewer.drawn();
    },
    camera: (name) => {
      viewer.look(name);
      return viewer.drawn();
    },
    stats: () => viewer.stats(),
  };
}

function start() {
  const report = reportText();
  reportLink(report, document.title || 'report');
  byId('title').textContent = document.title;
  const notices = [];
  const show = readShow(notices);
  document.title = show.title;
  byId('title').textContent = show.title;
  byId('description').textContent = show.description;
  byId('description').hidden = show.description === '';
  show.runs.forEach(tellOutcome);
  reports(report).forEach(tellCrowded);
  showMechanism();
  if (show.runs.every((run) => run.bodies.length === 0)) notices.push('The scene has no bodies.');
  for (const words of notices) notice(words, false);
  const viewer = new Viewer(show);
  const ready = viewer.start();
  publish(viewer, ready);
  return ready;
}

async function main() {
  try {
    await start();
    document.body.classList.add('ready');
  } catch (error) {
    showFailure(wordsOf(error));
    window.polhode ??= { ready: Promise.resolve() };
  }
}

main();
