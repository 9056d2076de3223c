// The side panel: what to look at, the outcome of each run, the plots.

import { Plot } from './plot.js';

/** The figure of what would move first, where the page has one. */
export function showMechanism() {
  const figure = document.getElementById('polhode-mechanism');
  const holder = document.getElementById('mechanism');
  if (figure === null || holder === null) return;
  holder.append(figure.content);
  holder.hidden = false;
}

/** Groups of series in the order in which they are shown; others follow. */
const GROUP_ORDER = ['energy', 'ledger', 'penetration', 'residual', 'steps'];

/** The plots of all series of all runs: one for each group and unit. */
export function buildPlots(holder, views, playback, seek) {
  const of_key = new Map();
  for (const { run, frames } of views) {
    for (const series of run.series) {
      const key = `${series.group}\n${series.unit}`;
      if (!of_key.has(key)) of_key.set(key, []);
      of_key.get(key).push({ run, frames, series });
    }
  }
  const rank = (key) => {
    const at = GROUP_ORDER.indexOf(key.split('\n')[0]);
    return at < 0 ? GROUP_ORDER.length : at;
  };
  const keys = [...of_key.keys()].sort((one, other) => rank(one) - rank(other));
  const plots = keys.map((key) => new Plot(...key.split('\n'), of_key.get(key), playback, seek));
  holder.replaceChildren(...plots.map((plot) => plot.element));
  return plots;
}
