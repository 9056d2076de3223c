// What the page must say before anything else: how a run ended, what is missing, what is broken.

import { short } from './numbers.js';

/** Notices shown at most; further ones are counted. */
const MOST_NOTICES = 6;

let count = 0;

/** Adds a notice; `grave` is true where something is missing from the picture. */
export function notice(words, grave) {
  const holder = document.getElementById('notices');
  count += 1;
  if (count > MOST_NOTICES) {
    const last = holder.lastElementChild;
    last.textContent = `and ${count - MOST_NOTICES + 1} further notices`;
    return;
  }
  const line = document.createElement('p');
  line.className = grave ? 'grave' : 'mild';
  line.textContent = words;
  holder.append(line);
}

/** Instead of the picture: why there is none. */
export function showFailure(words) {
  const message = document.getElementById('message');
  message.textContent = words;
  message.hidden = false;
  document.body.classList.add('failed');
}

/** Tells how a run ended when it did not end as it should. */
export function tellOutcome(run) {
  if (run.outcome === 'completed') return;
  if (run.outcome === 'degraded') {
    notice(`“${run.name}” is degraded: it did not keep what its method promises. The report says where.`, false);
    return;
  }
  const message = run.outcome.replace(/^failed:?\s*|\.$/g, '') || 'no reason is given';
  const last = run.times.at(-1);
  const computed =
    last === undefined
      ? 'Nothing was computed.'
      : `What was computed is shown: the last frame is at t = ${short(last, 6)} s of ${short(run.duration, 6)} s.`;
  notice(`“${run.name}” failed: ${message}. ${computed}`, true);
}

/** Tells which part of a run went by time steps, and what error that has caused; `report` is the JSON report of one run. */
export function tellCrowded(report) {
  const { crowded } = report;
  if (!crowded) return;
  const { error } = crowded;
  const caused = error
    ? `at the end their error is estimated at ${short(error.position_m)} m, ${short(error.velocity_m_s)} m/s ` +
      `and ${short(error.angular_velocity_rad_s)} rad/s`
    : 'their error is not known';
  notice(
    `${crowded.stretches} stretches of crowded events, ${short(crowded.length_s)} s in all, went by time steps: ${caused}. ` +
      `The largest residual in them is ${short(crowded.max_residual)}.`,
    false,
  );
}
