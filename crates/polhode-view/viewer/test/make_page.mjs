// Writes the synthetic pages into a folder: `node test/make_page.mjs [FOLDER] [--large]`.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { pageText } from './encode.mjs';
import { crowd, pile, top } from './scenes.mjs';
import { ball, cube } from './shapes.mjs';

const meshes = [cube(), ball()];
const failed = 'failed: body r1c1 sinks into floor by 0.3 m <at> t = 4';

/** Pages that must play: name and text. */
export const GOOD_PAGES = {
  top: () =>
    pageText('A top near its middle axis', 'Look at the polhode: the top flips over and back.', meshes, [top()]),
  pile: () => pageText('A pile of boxes', 'Boxes fall and come to rest.', meshes, [pile()]),
  'two-runs': () => pageText('Two methods', 'The same top by two methods.', meshes, [top(), top('fast', 0.02)]),
  failed: () => pageText('A run that failed', '', meshes, [pile({ outcome: failed })]),
  'crowd-1000': () => pageText('1,000 bodies', '', meshes, [crowd(1000, 1000)]),
};

/** The first half of some bytes, however few they are. */
const shortened = (bytes) => bytes.subarray(0, bytes.length / 2);

/** Pages with bad data: text and the words that the page must show. */
export const BROKEN_PAGES = {
  'first-chunk-cut': {
    words: /cannot be unpacked/,
    text: () =>
      pageText('cut', '', meshes, [pile()], {
        chunk: (run, chunk, bytes) => (chunk === 0 ? shortened(bytes) : bytes),
      }),
  },
  'late-chunk-cut': {
    words: /The part from .* cannot be unpacked/,
    seek: 3.5,
    text: () =>
      pageText('cut late', '', meshes, [pile()], {
        chunk: (run, chunk, bytes) => (chunk === 4 ? shortened(bytes) : bytes),
      }),
  },
  'wrong-length': {
    words: /does not fit the run/,
    text: () =>
      pageText('length', '', meshes, [pile()], {
        show: (show) => (show.runs[0].frames.chunks = [{ first: 0, count: 240 }]),
      }),
  },
  'wrong-version': {
    words: /version 2.*reads version 1/,
    text: () => pageText('version', '', meshes, [top()], { show: (show) => (show.version = 2) }),
  },
  'nan-series': {
    words: /no numbers and is left out/,
    text: () => {
      const run = top();
      run.series[0].values = run.series[0].values.map(() => NaN);
      return pageText('nan', '', meshes, [run]);
    },
  },
  'no-frames': {
    words: /no frames: nothing was computed/,
    text: () => pageText('none', '', meshes, [{ ...top(), times: [], series: [] }]),
  },
  'no-bodies': {
    words: /no bodies/,
    text: () => pageText('empty', '', [], [{ ...top(), bodies: [], initial: [], moving: [] }]),
  },
  'no-run': { words: /holds no run/, text: () => pageText('no run', '', meshes, []) },
  'unknown-body': {
    words: /a body that it does not know/,
    text: () => pageText('unknown', '', meshes, [top()], { show: (show) => (show.runs[0].frames.moving = [7]) }),
  },
  'missing-chunk': {
    words: /missing from the page/,
    text: () => GOOD_PAGES.pile().replace('id="polhode-frames-0-0"', 'id="lost"'),
  },
  'broken-json': {
    words: /cannot be read: it is damaged/,
    text: () => GOOD_PAGES.top().replace('"version":1', '"version":'),
  },
};

/** Writes a page into a folder and returns its path. */
export function writePage(folder, name, text) {
  mkdirSync(folder, { recursive: true });
  const path = join(folder, `${name}.html`);
  writeFileSync(path, text);
  return path;
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const folder = process.argv.slice(2).find((word) => !word.startsWith('--')) ?? 'test/out';
  for (const [name, text] of Object.entries(GOOD_PAGES)) console.log(writePage(folder, name, text()));
  for (const [name, { text }] of Object.entries(BROKEN_PAGES)) console.log(writePage(folder, name, text()));
  if (process.argv.includes('--large'))
    console.log(writePage(folder, 'crowd-5000', pageText('5,000 bodies', '', meshes, [crowd(5000, 600)])));
}
