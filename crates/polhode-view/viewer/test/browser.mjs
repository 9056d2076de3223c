// Tests pages in a real browser: `node test/browser.mjs` the synthetic pages, `node test/browser.mjs PAGE...` given ones.
//
//   --synthetic        the synthetic pages too, where pages are given, but of them only what is seen at once
//   --pictures FOLDER  compares each given page with FOLDER/NAME.png
//   --record           writes pictures anew that are missing or others than before; checks nothing else
//   --json             a line of JSON for each check
//
// Prints a line for each check and `N passed, N failed`; exit code 1 when one failed, 2 without a browser (chromium.mjs).

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import {
  checkBroken,
  checkCommitted,
  checkFollowing,
  checkLayouts,
  checkOpening,
  checkPage,
  open,
} from './checks.mjs';
import { findChromium } from './chromium.mjs';
import { BROKEN_PAGES, GOOD_PAGES, writePage } from './make_page.mjs';
import { Tally } from './tally.mjs';

/** Synthetic pages with a committed picture, and the overlays that are on in it. */
const COMMITTED = { top: ['spins'], pile: ['contacts', 'manifolds', 'islands'], 'two-runs': ['velocities'] };
/** Synthetic pages of which every overlay shows something. */
const ALL_OVERLAYS = ['pile', 'top'];
/** The large synthetic page. */
const LARGE = 'crowd-1000';

const { values: options, positionals: given } = parseArgs({
  allowPositionals: true,
  options: {
    synthetic: { type: 'boolean', default: false },
    pictures: { type: 'string' },
    record: { type: 'boolean', default: false },
    json: { type: 'boolean', default: false },
  },
});

/** The picture of a synthetic page: its place and its overlays, or null. */
function committedOf(name) {
  const path = fileURLToPath(new URL(`pictures/${name}.png`, import.meta.url));
  return COMMITTED[name] ? { path, overlays: COMMITTED[name], record: options.record } : null;
}

/** Pages to look at: { path, name, committed, all_overlays, brief }. */
function pages(folder) {
  const list = given.map((path) => {
    const name = basename(path, '.html');
    const picture = options.pictures === undefined ? null : join(resolve(options.pictures), `${name}.png`);
    const committed = picture === null ? null : { path: picture, overlays: [], record: options.record };
    return { path: resolve(path), name, committed, all_overlays: false, brief: false };
  });
  if (given.length > 0 && !options.synthetic) return list;
  const synthetic = Object.entries(GOOD_PAGES).map(([name, text]) => ({
    path: writePage(folder, name, text()),
    name,
    committed: committedOf(name),
    all_overlays: ALL_OVERLAYS.includes(name),
    brief: given.length > 0,
  }));
  return [...list, ...synthetic];
}

async function record(tally, browser, folder) {
  for (const { path, name, committed } of pages(folder).filter((one) => one.committed)) {
    const { page } = await open(browser, path);
    await checkCommitted(tally, page, name, committed);
    await page.close();
  }
}

async function checkAll(tally, browser, folder) {
  for (const page of pages(folder)) {
    const { path, name } = page;
    if (name === LARGE) await checkOpening(tally, browser, path);
    if (name === LARGE && page.brief) continue;
    await checkPage(tally, browser, path, page);
    if (name === 'top') await checkFollowing(tally, browser, path);
    if (name === 'two-runs') await checkLayouts(tally, browser, path);
  }
  if (given.length > 0 && !options.synthetic) return;
  for (const [name, broken] of Object.entries(BROKEN_PAGES)) {
    await checkBroken(tally, browser, writePage(folder, name, broken.text()), broken);
  }
}

async function main() {
  const executablePath = findChromium();
  if (executablePath === null) {
    console.error('no Chromium is found: install one (apt-get install chromium), or name it by the variable CHROMIUM');
    return 2;
  }
  const tally = new Tally(options.json);
  const browser = await chromium.launch({
    executablePath,
    args: ['--headless', '--no-sandbox', '--enable-unsafe-swiftshader'],
  });
  const folder = mkdtempSync(join(tmpdir(), 'polhode-viewer-'));
  try {
    if (options.record) await record(tally, browser, folder);
    else await checkAll(tally, browser, folder);
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
  return tally.close() ? 0 : 1;
}

process.exitCode = await main();
