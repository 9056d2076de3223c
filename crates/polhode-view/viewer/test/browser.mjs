// Tests pages in a real browser: `node test/browser.mjs` for the synthetic pages, `node test/browser.mjs PAGE...` for
// given ones; with --record it writes the pictures in test/pictures anew. Prints a line for each check and
// `N passed, N failed`; exit code 1 when one failed.
// The browser is the one of the variable CHROMIUM, or /usr/bin/chromium.

import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { BROKEN_PAGES, GOOD_PAGES, writePage } from './make_page.mjs';

/** Opening 1,000 bodies and 1,000 frames may take so long, the best of some tries. */
const OPENING_MS = 2000;
const OPENING_TRIES = 3;
/** Longest wait for a page to be ready or for a picture. */
const PATIENCE_MS = 30000;
/** Pixels of a picture, and how far a value of 0..255 must be off to count as another. */
const PICTURE = [320, 200];
const ANOTHER_COLOUR = 6;
/** A picture is another one when at least this many of its pixels are. */
const ANOTHER_PICTURE = 12;
const DESKTOP = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };
/** Pages with a committed picture, and the overlays that are on in it, at a share of the run's time. */
const COMMITTED = { top: ['spins'], pile: ['contacts', 'manifolds', 'islands'], 'two-runs': ['velocities'] };
const COMMITTED_MOMENT = 0.3;
/** Another version of the browser may draw the rims of things differently: so many pixels may be clearly others. */
const CLEARLY_ANOTHER = 40;
const MOST_OTHER_PIXELS = (PICTURE[0] * PICTURE[1]) / 100;
const RECORD = process.argv.includes('--record');
/** Shares of the run's time at which overlays are looked for. */
const MOMENTS = [0.3, 0.6, 0.05, 0.95];

let passed = 0;
let failed = 0;

function check(page_name, what, good, detail = '') {
  if (good) passed += 1;
  else failed += 1;
  console.log(`${good ? 'ok    ' : 'FAILED'} ${page_name}: ${what}${detail ? ` (${detail})` : ''}`);
}

const note = (page_name, words) => console.log(`note   ${page_name}: ${words}`);

/** Opens a page; `errors` collects what the console and the page report. */
async function open(browser, path, viewport = DESKTOP) {
  const page = await browser.newPage({ viewport, colorScheme: 'light' });
  page.setDefaultTimeout(PATIENCE_MS);
  const errors = [];
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  const begun = performance.now();
  await page.goto(pathToFileURL(path).href);
  await page.waitForFunction(() => window.polhode !== undefined);
  await page.evaluate(() => window.polhode.ready);
  return { page, errors, opening_ms: performance.now() - begun };
}

/** A picture as the page gives it, PNG in base64; `from` is null for the canvas at the present time, or such a PNG. */
function pixelsInPage([from, width, height]) {
  const copy = document.createElement('canvas');
  copy.width = width;
  copy.height = height;
  const pen = copy.getContext('2d', { willReadFrequently: true });
  const draw = async () => {
    if (from === null) {
      await window.polhode.seek(window.polhode.time());
      return document.getElementById('stage');
    }
    const image = new Image();
    image.src = from;
    await image.decode();
    return image;
  };
  return draw().then((source) => {
    pen.drawImage(source, 0, 0, width, height);
    const values = Array.from(pen.getImageData(0, 0, width, height).data, (value) => String.fromCharCode(value));
    return { pixels: values.join(''), png: copy.toDataURL('image/png') };
  });
}

const asBytes = (text) => Uint8Array.from(text, (letter) => letter.charCodeAt(0));

/** The pixels of the canvas, small, as the present time is drawn. */
async function picture(page) {
  return asBytes((await page.evaluate(pixelsInPage, [null, ...PICTURE])).pixels);
}

/** Compares the canvas with the committed picture, or writes that anew. */
async function checkCommitted(page, name) {
  const path = new URL(`pictures/${name}.png`, import.meta.url);
  await seek(page, COMMITTED_MOMENT * (await endOf(page)));
  for (const overlay of COMMITTED[name])
    await page.evaluate((which) => window.polhode.setOverlay(which, true), overlay);
  const now = await page.evaluate(pixelsInPage, [null, ...PICTURE]);
  for (const overlay of COMMITTED[name])
    await page.evaluate((which) => window.polhode.setOverlay(which, false), overlay);
  if (RECORD) {
    mkdirSync(new URL('.', path), { recursive: true });
    writeFileSync(path, Buffer.from(now.png.split(',')[1], 'base64'));
    return note(name, 'picture written');
  }
  const png = `data:image/png;base64,${readFileSync(path, 'base64')}`;
  const committed = await page.evaluate(pixelsInPage, [png, ...PICTURE]);
  const count = difference(asBytes(now.pixels), asBytes(committed.pixels), CLEARLY_ANOTHER);
  check(name, 'the picture is the committed one', count <= MOST_OTHER_PIXELS, `${count} pixels differ`);
}

/** How many pixels of two pictures differ. */
function difference(one, other, least = ANOTHER_COLOUR) {
  let count = 0;
  for (let at = 0; at < one.length; at += 4) {
    if ([0, 1, 2].some((k) => Math.abs(one[at + k] - other[at + k]) > least)) count += 1;
  }
  return count;
}

/** How many colours a picture has. */
function colours(pixels) {
  const seen = new Set();
  for (let at = 0; at < pixels.length; at += 4) seen.add((pixels[at] << 16) | (pixels[at + 1] << 8) | pixels[at + 2]);
  return seen.size;
}

const seek = (page, t) => page.evaluate((time) => window.polhode.seek(time), t);
const time = (page) => page.evaluate(() => window.polhode.time());
const endOf = (page) => page.evaluate(() => Number(document.getElementById('timeline').getAttribute('aria-valuemax')));

async function checkScrubbing(page, name) {
  const box = await page.locator('#timeline').boundingBox();
  const pictures = [];
  for (const share of [0.08, 0.35, 0.65, 0.97]) {
    await page.mouse.click(box.x + share * box.width, box.y + 18);
    pictures.push(await picture(page));
  }
  const most = Math.max(...pictures.slice(1).map((other) => difference(pictures[0], other)));
  check(name, 'scrubbing changes the picture', most >= ANOTHER_PICTURE, `${most} pixels`);
}

/** The largest change that an overlay makes at some moments, and whether taking it off brings the picture back. */
async function changeBy(page, overlay, end) {
  let most = 0;
  let back = 0;
  for (const moment of MOMENTS) {
    await seek(page, moment * end);
    const before = await picture(page);
    const was_on = await page.locator(`[data-overlay=${overlay}]`).getAttribute('aria-pressed');
    await page.click(`[data-overlay=${overlay}]`);
    await picture(page);
    // Curves and traces grow while their frames are read.
    if (['polhode', 'traces'].includes(overlay)) await page.waitForTimeout(400);
    most = Math.max(most, difference(before, await picture(page)));
    await page.evaluate(([which, on]) => window.polhode.setOverlay(which, on), [overlay, was_on === 'true']);
    back = Math.max(back, difference(before, await picture(page)));
    if (most >= ANOTHER_PICTURE) break;
  }
  return { most, back };
}

async function checkOverlays(page, name, all_must) {
  const end = await endOf(page);
  const overlays = await page
    .locator('#overlays button:not([disabled])')
    .evaluateAll((list) => list.map((one) => one.dataset.overlay));
  let any = false;
  for (const overlay of overlays) {
    const { most, back } = await changeBy(page, overlay, end);
    any ||= most >= ANOTHER_PICTURE;
    if (all_must) check(name, `overlay ${overlay} changes the picture`, most >= ANOTHER_PICTURE, `${most} pixels`);
    else if (most < ANOTHER_PICTURE) note(name, `overlay ${overlay} shows nothing at the moments looked at`);
    check(name, `overlay ${overlay} goes off again`, back < ANOTHER_PICTURE, `${back} pixels`);
  }
  check(name, 'some overlay changes the picture', any);
}

async function checkKeyboard(page, name) {
  const frame = () => page.evaluate(() => window.polhode.frame());
  const press = async (key) => {
    await page.keyboard.press(key);
    await picture(page);
  };
  await page.locator('h1').click();
  await press('Home');
  const start = await frame();
  await press('ArrowRight');
  await press('ArrowRight');
  check(name, 'keys: → goes a frame on', (await frame()) === start + 2);
  await press('ArrowLeft');
  check(name, 'keys: ← goes a frame back', (await frame()) === start + 1);
  await press('Home');
  await press('Space');
  await page.waitForTimeout(400);
  const running = await time(page);
  await press('Space');
  const stopped = await time(page);
  await page.waitForTimeout(200);
  check(name, 'keys: Space plays and pauses', running > 0 && (await time(page)) === stopped);
  await press('End');
  check(name, 'keys: End goes to the end', Math.abs((await time(page)) - (await endOf(page))) < 1e-9);
  const pressed = () => page.locator('[data-overlay=boxes]').getAttribute('aria-pressed');
  await press('7');
  const on = await pressed();
  await press('7');
  check(name, 'keys: 7 switches the boxes', on === 'true' && (await pressed()) === 'false');
  await press('l');
  check(name, 'keys: L loops', (await page.locator('#loop').getAttribute('aria-pressed')) === 'true');
  await press('l');
  await press('f');
  await page.keyboard.press('?');
  const shown = await page.locator('#help').isVisible();
  await page.keyboard.press('Escape');
  check(name, 'keys: ? opens the help, Escape closes it', shown && !(await page.locator('#help').isVisible()));
}

async function checkCameras(page, name) {
  await page.evaluate(() => window.polhode.camera('iso'));
  const before = await picture(page);
  for (const camera of ['front', 'side', 'top']) {
    await page.evaluate((which) => window.polhode.camera(which), camera);
    check(name, `camera ${camera} changes the picture`, difference(before, await picture(page)) >= ANOTHER_PICTURE);
  }
  await page.evaluate(() => window.polhode.camera('iso'));
}

async function checkThemeAndPhone(page, name) {
  const light = await picture(page);
  await page.click('#theme');
  const dark = await picture(page);
  check(name, 'dark and light differ', difference(light, dark) > light.length / 4 / 2);
  await page.click('#theme');
  await page.setViewportSize(PHONE);
  const shape = await page.evaluate(() => ({
    width: document.documentElement.scrollWidth,
    below: document.getElementById('panel').offsetTop >= document.getElementById('controls').offsetTop,
  }));
  check(name, 'phone: no horizontal scroll', shape.width <= PHONE.width, `${shape.width} pixels wide`);
  check(name, 'phone: the panel stands below', shape.below);
  check(name, 'phone: the picture is not blank', colours(await picture(page)) > 8);
  await page.setViewportSize(DESKTOP);
}

async function checkReport(page, name) {
  if (!(await page.locator('#report').isVisible())) return note(name, 'no report');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#report')]);
  check(name, 'the report is saved as JSON', download.suggestedFilename().endsWith('.json'));
}

async function checkEvents(page, name) {
  if (!(await page.locator('#events').isVisible())) return;
  await page.locator('.row').nth(2).click();
  const at = await time(page);
  const chips = await page.locator('.chip').count();
  await page.locator('.chip').first().click();
  const rows = await page.locator('.row').count();
  await page.locator('.chip').first().click();
  check(
    name,
    'events: a row jumps to its time',
    at >= 0 && rows < 100,
    `${chips} kinds, ${rows} rows with a kind hidden`,
  );
}

async function measurePlaying(page, name) {
  await seek(page, 0);
  await page.evaluate(() => window.polhode.play());
  await page.waitForTimeout(2500);
  const {
    time: t,
    ms_per_frame,
    frames_drawn,
  } = await page.evaluate(() => {
    window.polhode.pause();
    return { time: window.polhode.time(), ...window.polhode.stats() };
  });
  check(name, 'playing goes on', t > 0, `${ms_per_frame.toFixed(1)} ms for each picture, ${frames_drawn} drawn`);
}

async function checkPage(browser, path, is_synthetic) {
  const name = basename(path, '.html');
  const { page, errors, opening_ms } = await open(browser, path);
  check(name, 'opens', !(await page.locator('#message').isVisible()), `${opening_ms.toFixed(0)} ms`);
  const count = colours(await picture(page));
  check(name, 'the picture is not blank', count > 8, `${count} colours`);
  if (is_synthetic && COMMITTED[name]) await checkCommitted(page, name);
  await checkScrubbing(page, name);
  await checkOverlays(page, name, is_synthetic && ['pile', 'top'].includes(name));
  await checkKeyboard(page, name);
  await checkCameras(page, name);
  await checkThemeAndPhone(page, name);
  await checkReport(page, name);
  await checkEvents(page, name);
  await measurePlaying(page, name);
  check(name, 'no console error', errors.length === 0, errors.join('; '));
  await page.close();
}

async function checkFollowing(browser, path) {
  const { page } = await open(browser, path);
  const box = await page.locator('#stage').boundingBox();
  await seek(page, 0);
  await page.evaluate(() => window.polhode.camera('fit'));
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  check('top', 'a click follows a body', (await page.locator('#follow').inputValue()) === '1');
  await page.keyboard.press('Escape');
  check('top', 'Escape follows none', (await page.locator('#follow').inputValue()) === '');
  await page.close();
}

async function checkLayouts(browser, path) {
  const { page } = await open(browser, path);
  await seek(page, 12);
  const before = await picture(page);
  await page.click('#layout');
  check('two-runs', 'side by side and overlaid differ', difference(before, await picture(page)) >= ANOTHER_PICTURE);
  await page.close();
}

async function checkOpening(browser, path) {
  const times = [];
  for (let attempt = 0; attempt < OPENING_TRIES; attempt += 1) {
    const { page, opening_ms } = await open(browser, path);
    times.push(Math.round(opening_ms));
    await page.close();
  }
  const words = `${times.join(', ')} ms`;
  check(basename(path, '.html'), `opens in under ${OPENING_MS} ms`, Math.min(...times) < OPENING_MS, words);
}

async function checkBroken(browser, path, name, { words, seek: t }) {
  const { page, errors } = await open(browser, path);
  if (t !== undefined) {
    await seek(page, t);
    await page
      .waitForFunction((source) => new RegExp(source).test(document.body.innerText), words.source)
      .catch(() => {});
  }
  const text = (await page.locator('#notices').innerText()) + (await page.locator('#message').innerText());
  check(name, 'says what is wrong', words.test(text), text.slice(0, 160).replaceAll('\n', ' '));
  check(name, 'no console error', errors.length === 0, errors.join('; '));
  await page.close();
}

/** Writes the committed pictures anew. */
async function recordPictures(browser, folder) {
  for (const name of Object.keys(COMMITTED)) {
    const { page } = await open(browser, writePage(folder, name, GOOD_PAGES[name]()));
    await checkCommitted(page, name);
    await page.close();
  }
}

async function checkSynthetic(browser, folder) {
  for (const [name, text] of Object.entries(GOOD_PAGES)) {
    const path = writePage(folder, name, text());
    if (name === 'crowd-1000') await checkOpening(browser, path);
    await checkPage(browser, path, true);
    if (name === 'top') await checkFollowing(browser, path);
    if (name === 'two-runs') await checkLayouts(browser, path);
  }
  for (const [name, broken] of Object.entries(BROKEN_PAGES)) {
    await checkBroken(browser, writePage(folder, name, broken.text()), name, broken);
  }
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--headless', '--no-sandbox', '--enable-unsafe-swiftshader'],
});
const folder = mkdtempSync(join(tmpdir(), 'polhode-viewer-'));
try {
  const given = process.argv.slice(2).filter((word) => !word.startsWith('--'));
  for (const path of given) await checkPage(browser, resolve(path), false);
  if (RECORD) await recordPictures(browser, folder);
  else if (given.length === 0) await checkSynthetic(browser, folder);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
