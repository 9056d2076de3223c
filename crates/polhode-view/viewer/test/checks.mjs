// What is checked of a page in a browser. Every check tells a tally what it found.

import { basename } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ANOTHER_PICTURE, colours, compareWith, difference, picture } from './pictures.mjs';

/** Opening 1,000 bodies and 1,000 frames may take so long, the best of some tries. */
const OPENING_MS = 2000;
const OPENING_TRIES = 3;
/** Longest wait for a page to be ready or for a picture. */
const PATIENCE_MS = 30000;
/** Small: where no graphics card is, the processor draws every pixel. */
const DESKTOP = { width: 840, height: 525 };
const PHONE = { width: 390, height: 844 };
/** Least width of the time line on which a moment can be hit, pixels. */
const TIMELINE_PIXELS = 250;
/** Share of the run's time that a committed picture shows. */
const COMMITTED_MOMENT = 0.3;
/** Shares of the run's time at which overlays are looked for: the first of them, or all where each must show something. */
const MOMENTS = [0.3, 0.6, 0.05, 0.95];
/** Fewest colours of a picture that shows something. */
const FEWEST_COLOURS = 9;
/** How long a page is played, ms. */
const PLAYING_MS = 1500;

/** Opens a page; `errors` collects what the console and the page report. */
export async function open(browser, path, viewport = DESKTOP) {
  const page = await browser.newPage({ viewport, colorScheme: 'light', deviceScaleFactor: 1 });
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

const seek = (page, t) => page.evaluate((time) => window.polhode.seek(time), t);
const time = (page) => page.evaluate(() => window.polhode.time());
const endOf = (page) => page.evaluate(() => Number(document.getElementById('timeline').getAttribute('aria-valuemax')));
const setOverlay = (page, overlay, on) =>
  page.evaluate(([which, value]) => window.polhode.setOverlay(which, value), [overlay, on]);

/** Compares the canvas, with these overlays, with the picture committed at `path`, or writes that anew. */
export async function checkCommitted(tally, page, name, { path, overlays, record }) {
  await seek(page, COMMITTED_MOMENT * (await endOf(page)));
  for (const overlay of overlays) await setOverlay(page, overlay, true);
  const { good, words } = await compareWith(page, path, record);
  for (const overlay of overlays) await setOverlay(page, overlay, false);
  tally.check('picture', name, 'the picture is the committed one', good, words);
}

async function checkScrubbing(tally, page, name) {
  const box = await page.locator('#timeline').boundingBox();
  const pictures = [];
  for (const share of [0.08, 0.35, 0.65, 0.97]) {
    await page.mouse.click(box.x + share * box.width, box.y + 18);
    pictures.push(await picture(page));
  }
  const most = Math.max(...pictures.slice(1).map((other) => difference(pictures[0], other)));
  tally.check('scrubbing', name, 'scrubbing changes the picture', most >= ANOTHER_PICTURE, `${most} pixels`);
}

/** The largest change that an overlay makes at some moments, and whether taking it off brings the picture back. */
async function changeBy(page, overlay, end, moments) {
  let most = 0;
  let back = 0;
  for (const moment of moments) {
    await seek(page, moment * end);
    const before = await picture(page);
    const was_on = await page.locator(`[data-overlay=${overlay}]`).getAttribute('aria-pressed');
    await page.click(`[data-overlay=${overlay}]`);
    await picture(page);
    // Curves and traces grow while their frames are read.
    if (['polhode', 'traces'].includes(overlay)) await page.waitForTimeout(400);
    most = Math.max(most, difference(before, await picture(page)));
    await setOverlay(page, overlay, was_on === 'true');
    back = Math.max(back, difference(before, await picture(page)));
    if (most >= ANOTHER_PICTURE) break;
  }
  return { most, back };
}

async function checkOverlays(tally, page, name, all_must) {
  const end = await endOf(page);
  const overlays = await page
    .locator('#overlays button:not([disabled])')
    .evaluateAll((list) => list.map((one) => one.dataset.overlay));
  const moments = all_must ? MOMENTS : MOMENTS.slice(0, 1);
  let any = false;
  for (const overlay of overlays) {
    const { most, back } = await changeBy(page, overlay, end, moments);
    const changes = most >= ANOTHER_PICTURE;
    any ||= changes;
    if (all_must) tally.check('overlays', name, `overlay ${overlay} changes the picture`, changes, `${most} pixels`);
    else if (!changes) tally.note(name, `overlay ${overlay} shows nothing at the moments looked at`);
    tally.check('overlays', name, `overlay ${overlay} goes off again`, back < ANOTHER_PICTURE, `${back} pixels`);
  }
  tally.check('overlays', name, 'some overlay changes the picture', any);
}

async function checkKeyboard(tally, page, name) {
  const check = (what, good) => tally.check('keyboard', name, `keys: ${what}`, good);
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
  check('→ goes a frame on', (await frame()) === start + 2);
  await press('ArrowLeft');
  check('← goes a frame back', (await frame()) === start + 1);
  await press('Home');
  await press('Space');
  await page.waitForTimeout(400);
  const running = await time(page);
  await press('Space');
  const stopped = await time(page);
  await page.waitForTimeout(200);
  check('Space plays and pauses', running > 0 && (await time(page)) === stopped);
  await press('End');
  check('End goes to the end', Math.abs((await time(page)) - (await endOf(page))) < 1e-9);
  const pressed = () => page.locator('[data-overlay=boxes]').getAttribute('aria-pressed');
  await press('7');
  const on = await pressed();
  await press('7');
  check('7 switches the boxes', on === 'true' && (await pressed()) === 'false');
  await press('l');
  check('L loops', (await page.locator('#loop').getAttribute('aria-pressed')) === 'true');
  await press('l');
  await press('f');
  await page.keyboard.press('?');
  const shown = await page.locator('#help').isVisible();
  await page.keyboard.press('Escape');
  check('? opens the help, Escape closes it', shown && !(await page.locator('#help').isVisible()));
}

async function checkCameras(tally, page, name) {
  await page.evaluate(() => window.polhode.camera('iso'));
  const before = await picture(page);
  for (const camera of ['front', 'side', 'top']) {
    await page.evaluate((which) => window.polhode.camera(which), camera);
    const changes = difference(before, await picture(page)) >= ANOTHER_PICTURE;
    tally.check('cameras', name, `camera ${camera} changes the picture`, changes);
  }
  await page.evaluate(() => window.polhode.camera('iso'));
}

async function checkThemeAndPhone(tally, page, name) {
  const check = (what, good, detail) => tally.check('look', name, what, good, detail);
  const width = async () => (await page.locator('#timeline').boundingBox()).width;
  const wide = await width();
  check('the time line is wide enough to be used', wide >= TIMELINE_PIXELS, `${wide} pixels`);
  const light = await picture(page);
  await page.click('#theme');
  const dark = await picture(page);
  check('dark and light differ', difference(light, dark) > light.length / 4 / 2);
  await page.click('#theme');
  await page.setViewportSize(PHONE);
  const shape = await page.evaluate(() => ({
    width: document.documentElement.scrollWidth,
    below: document.getElementById('panel').offsetTop >= document.getElementById('controls').offsetTop,
  }));
  check('phone: no horizontal scroll', shape.width <= PHONE.width, `${shape.width} pixels wide`);
  check('phone: the panel stands below', shape.below);
  check('phone: the time line is wide enough to be used', (await width()) >= TIMELINE_PIXELS);
  check('phone: the picture is not blank', colours(await picture(page)) >= FEWEST_COLOURS);
  await page.setViewportSize(DESKTOP);
}

async function checkReport(tally, page, name) {
  if (!(await page.locator('#report').isVisible())) return tally.note(name, 'no report');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#report')]);
  tally.check('report', name, 'the report is saved as JSON', download.suggestedFilename().endsWith('.json'));
}

async function checkEvents(tally, page, name) {
  if (!(await page.locator('#events').isVisible())) return;
  const listed = page.locator('.row');
  await listed.nth(Math.min(2, (await listed.count()) - 1)).click();
  const at = await time(page);
  const chips = await page.locator('.chip').count();
  await page.locator('.chip').first().click();
  const rows = await listed.count();
  await page.locator('.chip').first().click();
  const words = `${chips} kinds, ${rows} rows with a kind hidden`;
  tally.check('events', name, 'events: a row jumps to its time', at >= 0 && rows < 100, words);
}

async function checkPlaying(tally, page, name) {
  await seek(page, 0);
  await page.evaluate(() => window.polhode.play());
  await page.waitForTimeout(PLAYING_MS);
  const {
    time: t,
    ms_per_frame,
    frames_drawn,
  } = await page.evaluate(() => {
    window.polhode.pause();
    return { time: window.polhode.time(), ...window.polhode.stats() };
  });
  const words = `${ms_per_frame?.toFixed(1)} ms for each picture, ${frames_drawn} drawn`;
  tally.check('playing', name, 'playing goes on', t > 0, words);
  tally.figure(name, 'time for each picture while it plays', ms_per_frame ?? NaN, 'ms');
}

/** A page of a run that stopped says so, and where; whether it is one. */
async function checkOutcome(tally, page, name) {
  const shown = await page.evaluate(() => JSON.parse(document.getElementById('polhode-show').textContent));
  const stopped = shown.runs.filter((run) => run.outcome.startsWith('failed'));
  if (stopped.length === 0) return false;
  const notices = await page.locator('#notices').innerText();
  const said = /failed: .*What was computed is shown: the last frame is at t = .* s of .* s/s.test(notices);
  tally.check('words', name, 'says where the run stopped', said, notices.slice(0, 200).replaceAll('\n', ' '));
  return true;
}

/**
 * The checks of a page: `committed` (or null) is its picture, `all_overlays` that each overlay must show something, `brief`
 * that only what is seen at once is looked at. Of a run that has stopped the controls are not tried: they are those of all.
 */
export async function checkPage(tally, browser, path, { committed, all_overlays, brief }) {
  const name = basename(path, '.html');
  const { page, errors, opening_ms } = await open(browser, path);
  const message = page.locator('#message');
  const fails = (await message.isVisible()) ? await message.innerText() : '';
  tally.check('opening', name, 'opens', fails === '', fails || `${opening_ms.toFixed(0)} ms`);
  const count = colours(await picture(page));
  tally.check('blank', name, 'the picture is not blank', count >= FEWEST_COLOURS, `${count} colours`);
  if (committed) await checkCommitted(tally, page, name, committed);
  const has_stopped = await checkOutcome(tally, page, name);
  if (!brief) await checkScrubbing(tally, page, name);
  if (!brief && !has_stopped) {
    await checkOverlays(tally, page, name, all_overlays);
    await checkKeyboard(tally, page, name);
    await checkCameras(tally, page, name);
    await checkThemeAndPhone(tally, page, name);
    await checkReport(tally, page, name);
    await checkEvents(tally, page, name);
    await checkPlaying(tally, page, name);
  }
  tally.check('console', name, 'no console error', errors.length === 0, errors.join('; '));
  await page.close();
}

/** A click on the body in the middle shows its numbers, a double click follows it, Escape ends both. */
export async function checkFollowing(tally, browser, path) {
  const name = basename(path, '.html');
  const { page } = await open(browser, path);
  const box = await page.locator('#stage').boundingBox();
  await seek(page, 0);
  await page.evaluate(() => window.polhode.camera('fit'));
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  const followed = () => page.locator('#follow').inputValue();
  await page.mouse.click(...middle);
  await page.evaluate(() => window.polhode.seek(window.polhode.time()));
  const card = await page.locator('#card').innerText();
  tally.check('following', name, 'a click shows the numbers of a body', /mass/.test(card), card.split('\n')[0]);
  tally.check('following', name, 'a click follows none', (await followed()) === '');
  await page.mouse.dblclick(...middle);
  tally.check('following', name, 'a double click follows a body', (await followed()) === '1');
  await page.keyboard.press('Escape');
  tally.check('following', name, 'Escape follows none', (await followed()) === '');
  tally.check('following', name, 'Escape hides the numbers', !(await page.locator('#card').isVisible()));
  await page.close();
}

/** Two runs side by side are another picture than one over the other. */
export async function checkLayouts(tally, browser, path) {
  const name = basename(path, '.html');
  const { page } = await open(browser, path);
  await seek(page, 12);
  const before = await picture(page);
  await page.click('#layout');
  const differ = difference(before, await picture(page)) >= ANOTHER_PICTURE;
  tally.check('layouts', name, 'side by side and overlaid differ', differ);
  await page.close();
}

/** How long a page of 1,000 bodies and 1,000 frames takes to open. */
export async function checkOpening(tally, browser, path) {
  const name = basename(path, '.html');
  const times = [];
  for (let attempt = 0; attempt < OPENING_TRIES; attempt += 1) {
    const { page, opening_ms } = await open(browser, path);
    times.push(opening_ms);
    await page.close();
  }
  const best = Math.min(...times);
  tally.figure(name, `time to open (asked: < ${OPENING_MS})`, best, 'ms');
  if (best >= OPENING_MS) tally.note(name, 'opens more slowly than asked: is the machine busy?');
}

/** A page with bad data says what is wrong; `t` is the time to look at, where that matters. */
export async function checkBroken(tally, browser, path, { words, seek: t }) {
  const name = basename(path, '.html');
  const { page, errors } = await open(browser, path);
  if (t !== undefined) {
    await seek(page, t);
    await page
      .waitForFunction((source) => new RegExp(source).test(document.body.innerText), words.source)
      .catch(() => {});
  }
  const text = (await page.locator('#notices').innerText()) + (await page.locator('#message').innerText());
  tally.check('words', name, 'says what is wrong', words.test(text), text.slice(0, 160).replaceAll('\n', ' '));
  tally.check('console', name, 'no console error', errors.length === 0, errors.join('; '));
  await page.close();
}
