// Tests a page of `polhode play` in a real browser: `node test/play.mjs PAGE [HASH=SCENE...] [--shots FOLDER] [--only PART]`.
//
// Prints a line for each check, `ok WHAT` or `fails WHAT: WHY`, and `info WHAT` for what is measured; exit code 1 when one
// failed, 2 without a browser (chromium.mjs).

import { readFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { findChromium } from './chromium.mjs';

const { values: options, positionals } = parseArgs({ allowPositionals: true, options: { shots: { type: 'string' }, only: { type: 'string' } } });
const [page_path, ...hashes] = positionals;
const address = pathToFileURL(resolve(page_path)).href;
const GL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
/** Longest wait, on a machine that does other things besides. */
const PATIENCE_MS = 120000;
let failed = 0;

function tell(good, what, why = '') {
  if (!good) failed += 1;
  console.log(good ? `ok ${what}` : `fails ${what}: ${why}`.replaceAll('\n', ' '));
}

/** Does a check; what it throws is why it fails. */
async function check(what, test) {
  try {
    const why = await test();
    tell(why === undefined || why === true, what, String(why));
  } catch (error) {
    tell(false, what, error.message);
  }
}

/** Opens the page; what it says to the console is kept in `said`. */
async function open(browser, { hash = '', width = 1280, height = 800, dark = false, script = null } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light' });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  const said = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(error.message));
  if (script) await page.addInitScript(script);
  await page.goto(address + hash);
  await page.waitForFunction(() => document.body.matches('.ready, .failed'));
  return { page, said, close: () => context.close() };
}

async function shot(page, name) {
  if (options.shots) await page.screenshot({ path: join(options.shots, `${name}.png`) });
}

const words = (page, selector) => page.locator(selector).textContent();

/** 200 boxes in a grid of towers. */
const BOXES = `format = 1
duration = 60.0
[method]
tier = "fast"
[materials.wood]
friction = 0.5
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "wood"
[[arrays]]
name = "box"
shape.box.size = [0.2, 0.2, 0.2]
mass = 1.0
material = "wood"
position = [0, 0, 0.1]
layout.grid = { counts = [5, 5, 8], spacing = [0.5, 0.5, 0.201] }
`;

async function runs(browser) {
  const { page, said, close } = await open(browser);
  await check('the page opens and runs without a message on the console', async () => {
    await page.evaluate(() => window.polhode.play());
    await page.waitForFunction(() => window.polhode.time() > 0.3);
    return said.length === 0 || said.join('; ');
  });
  await shot(page, 'play-light');
  await check('the hash of the given scene is that of the program that wrote the page', async () => {
    await page.evaluate(() => window.polhode.toEnd());
    await page.waitForFunction(() => document.getElementById('hash').textContent.includes('same bits, to the end'));
  });
  for (const pair of hashes) {
    const at = pair.indexOf('=');
    const [hash, file] = [pair.slice(0, at), pair.slice(at + 1)];
    await check(`${basename(file, '.toml')}: hash in the browser`, async () => {
      const made = await page.evaluate(async (text) => {
        await window.polhode.load(text);
        window.polhode.pause();
        return window.polhode.toEnd();
      }, readFileSync(file, 'utf8'));
      return made.split(' ')[0] === hash || `${made} instead of ${hash}`;
    });
  }
  await check('200 boxes run in tier fast', async () => {
    const pace = await page.evaluate(async (text) => {
      await window.polhode.load(text);
      const begun = performance.now();
      while (performance.now() - begun < 4000) {
        window.polhode.self.engine.goTo(30, false);
        await new Promise((over) => setTimeout(over, 20));
      }
      const { steps, used_ms } = window.polhode.track();
      return { steps, used_ms };
    }, BOXES);
    console.log(`info 200 boxes in tier fast: ${((1000 * pace.steps) / pace.used_ms).toFixed(0)} steps a second in the worker`);
    return pace.steps > 0;
  });
  await check('no message on the console until the end', () => said.length === 0 || said.join('; '));
  await close();
}

async function hands(browser) {
  const { page, said, close } = await open(browser);
  const time = () => page.evaluate(() => window.polhode.time());
  await check('Space pauses and runs', async () => {
    await page.evaluate(() => document.activeElement.blur());
    await page.evaluate(() => window.polhode.play());
    await page.waitForFunction(() => window.polhode.time() > 0.2);
    await page.keyboard.press('Space');
    const before = await time();
    await page.waitForTimeout(200);
    if ((await time()) !== before) return 'it runs on';
    await page.keyboard.press('Space');
    await page.waitForFunction((t) => window.polhode.time() > t, before);
  });
  await check('arrows scrub back and on', async () => {
    await page.keyboard.press('Shift+ArrowLeft');
    const back = await time();
    await page.keyboard.press('ArrowRight');
    return (await time()) > back || 'the time stays';
  });
  await check('N tells the forces on the next body', async () => {
    await page.keyboard.press('n');
    await page.waitForSelector('#why svg');
    return (await words(page, '#why h2 span')) !== '' || 'no name';
  });
  await shot(page, 'play-why');
  await check('P pushes the body and the run goes on from there', async () => {
    const before = await time();
    await page.keyboard.press('p');
    await page.waitForFunction((t) => window.polhode.time() > t + 0.1, before);
    await page.waitForFunction(() => document.getElementById('hash').textContent.includes('You have acted'));
  });
  await check('a body is dragged by a spring', async () => {
    await page.evaluate(async () => {
      await window.polhode.self.run();
      window.polhode.play();
    });
    await page.waitForFunction(() => window.polhode.time() > 0.05);
    // A body that falls is not where it was when the press comes.
    await page.evaluate(() => window.polhode.pause());
    const place = await page.evaluate(() => {
      const { picture } = window.polhode.self;
      const [body] = picture.run.moving;
      const frame = picture.canvas.getBoundingClientRect();
      const at = picture.camera.target.clone().fromArray(picture.poses, 7 * body).project(picture.stage.camera);
      return [frame.left + ((at.x + 1) / 2) * frame.width, frame.top + ((1 - at.y) / 2) * frame.height];
    });
    await page.mouse.move(...place);
    await page.mouse.down();
    await page.mouse.move(place[0] + 40, place[1] - 60, { steps: 6 });
    await page.waitForFunction(() => window.polhode.self.picture.hand.length === 9);
    await page.waitForTimeout(500);
    await shot(page, 'play-grab');
    await page.mouse.up();
    await page.waitForFunction(() => window.polhode.self.picture.hand.length === 0);
  });
  await check('friction and restitution change while it runs', async () => {
    await page.evaluate(() => {
      for (const [id, value] of [
        ['friction', 0.9],
        ['restitution', 0.6],
      ]) {
        const slider = document.getElementById(id);
        slider.value = value;
        slider.dispatchEvent(new Event('input'));
      }
    });
    await page.waitForTimeout(600);
    return (await words(page, '#notices')) === '' || (await words(page, '#notices'));
  });
  await check('the ghost of truth and a second copy run beside', async () => {
    await page.click('#truth');
    await page.click('#twin');
    await page.evaluate(() => window.polhode.play());
    await page.waitForFunction(() => window.polhode.time() > 0.5);
    const told = await words(page, '#distances p');
    return (/Truth: .* away/.test(told) && /Second copy: .* away/.test(told)) || told;
  });
  await shot(page, 'play-ghost');
  await check('no message on the console with hands on it', () => said.length === 0 || said.join('; '));
  await close();
}

async function bad(browser) {
  const { page, said, close } = await open(browser);
  const type = (text) =>
    page.evaluate((value) => {
      const area = document.querySelector('textarea');
      area.value = value;
      area.dispatchEvent(new Event('input'));
    }, text);
  const text = () => page.evaluate(() => document.querySelector('textarea').value);
  const drop = (name, make) =>
    page.evaluate(
      ([file, code]) => {
        const data = new DataTransfer();
        data.items.add(new File([new Function(`return ${code}`)()], file));
        document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
      },
      [name, make],
    );
  const good = await text();
  await check('a mistake is told at its line, and the text stays', async () => {
    const wrong = good.replace(/duration = .*/, 'duration = -1');
    await type(wrong);
    await page.waitForSelector('.faults button');
    await shot(page, 'play-error');
    const told = await words(page, '.faults');
    const line = wrong.split('\n').findIndex((one) => one.startsWith('duration')) + 1;
    return (told.includes(`line ${line}:`) && (await text()) === wrong) || told;
  });
  await check('a text that is no scene is told, and stays after the page is opened again', async () => {
    await type('this is [ no scene');
    await page.waitForSelector('.faults button, .faults p');
    const kept = await page.evaluate(() => JSON.parse(localStorage.getItem('polhode-playground-text')).text);
    return kept === 'this is [ no scene' || `kept: ${kept}`;
  });
  await check('the text is run again when it is right', async () => {
    await type(good);
    await page.waitForFunction(() => document.querySelector('.faults').hidden);
  });
  for (const [what, name, make, said_words] of [
    ['a picture that is dropped', 'a.png', 'new Uint8Array([137, 80, 78, 71, 255])', /is no scene/],
    ['a text that is no scene', 'a.txt', '"hello"', /is no scene/],
    ['100 MB', 'large.toml', 'new Uint8Array(1e8)', /100 MB/],
    ['a robot without links', 'arm.urdf', '"<robot/>"', /arm\.urdf could not be read: .*link/],
  ]) {
    await check(`${what}: a message, and the text stays`, async () => {
      await drop(name, make);
      await page.waitForFunction((source) => new RegExp(source).test(document.getElementById('notices').textContent), said_words.source);
      return (await text()) === good || 'the text is another one';
    });
  }
  await check('a mesh that is dropped falls on a floor', async () => {
    const facets = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    const solid = facets.map((facet) => `facet normal 0 0 0\nouter loop\n${facet.map((k) => `vertex ${corners[k].join(' ')}`).join('\n')}\nendloop\nendfacet`);
    await drop('part.stl', JSON.stringify(`solid part\n${solid.join('\n')}\nendsolid part\n`));
    await page.waitForFunction(() => window.polhode.self.scene.runs[0].name === 'part');
    await page.waitForFunction(() => window.polhode.time() > 0.2);
  });
  await check('a robot is told to miss its mesh, and runs when that is dropped too', async () => {
    const solid = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';
    const robot =
      '<robot name="dropped"><link name="base"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>' +
      '</inertial><collision><geometry><mesh filename="package://parts/meshes/solid.obj"/></geometry></collision></link></robot>';
    await drop('dropped.urdf', JSON.stringify(robot));
    await page.waitForFunction(() => /solid\.obj/.test(document.getElementById('notices').textContent));
    await drop('solid.obj', JSON.stringify(solid));
    await page.waitForFunction(() => window.polhode.self.scene.runs[0].name === 'dropped');
    await page.waitForFunction(() => window.polhode.time() > 0.2);
  });
  await check('a table of boxes that is dropped runs', async () => {
    await drop('boxes.csv', JSON.stringify('size_x,size_y,size_z,x,y,z,mass\n1,1,1,0,0,0.5,1\n1,1,1,0,0,1.5,1\n'));
    await page.waitForFunction(() => window.polhode.self.scene.runs[0].bodies.length === 3);
    await page.waitForFunction(() => window.polhode.time() > 0.2);
  });
  await check('a shipped scene is chosen from more than fifty', async () => {
    const count = await page.evaluate(() => document.querySelectorAll('#examples option').length);
    await page.selectOption('#examples', { index: 5 });
    await page.waitForFunction(() => window.polhode.time() > 0.1 && window.polhode.self.scene.runs[0].name !== 'scene');
    return count > 50 || count;
  });
  await check('the licences of what is in the page can be read', async () => {
    await page.click('#help-button');
    await page.click('#licences');
    await page.waitForFunction(() => /three\.js authors/.test(document.getElementById('licence-texts').textContent));
    await page.keyboard.press('Escape');
  });
  await check('a scene that never ends leaves the page usable', async () => {
    await type(good.replace(/duration = .*/, 'duration = 1e9'));
    await page.waitForFunction(() => window.polhode.track()?.duration === 1e9);
    await page.evaluate(() => window.polhode.play());
    await page.waitForFunction(() => window.polhode.time() > 0.5);
    await type(good);
    await page.waitForFunction(() => window.polhode.track()?.duration < 1e9);
  });
  await check('no message on the console with bad input', () => said.length === 0 || said.join('; '));
  await close();
}

async function addresses(browser) {
  const first = await open(browser);
  let hash = '';
  await check('an edit stands in the address', async () => {
    await first.page.evaluate(() => {
      const area = document.querySelector('textarea');
      area.value = area.value.replace(/duration = .*/, 'duration = 1.25');
      area.dispatchEvent(new Event('input'));
    });
    await first.page.waitForFunction(() => location.hash.startsWith('#scene='));
    hash = await first.page.evaluate(() => location.hash);
  });
  await first.close();
  await check('the address is the scene', async () => {
    const other = await open(browser, { hash });
    const duration = await other.page.evaluate(() => window.polhode.track().duration);
    await other.close();
    return duration === 1.25 || duration;
  });
  await check('an address that is cut in half says so, and the page runs', async () => {
    const other = await open(browser, { hash: hash.slice(0, hash.length / 2) });
    const told = await words(other.page, '#notices');
    const ran = await other.page.evaluate(() => window.polhode.track() !== null);
    await other.close();
    return (told.includes('cut off') && ran) || told;
  });
}

async function refused(browser) {
  for (const [what, script, said_words] of [
    ['WebAssembly that is missing', 'delete window.WebAssembly;', /no WebAssembly/],
    ['WebAssembly that is refused', "WebAssembly.compile = () => Promise.reject(new Error('disallowed'));", /refuses the engine/],
    ['WebGL that is missing', 'HTMLCanvasElement.prototype.getContext = ((own) => function (kind, ...rest) { return /webgl/.test(kind) ? null : own.call(this, kind, ...rest); })(HTMLCanvasElement.prototype.getContext);', /no WebGL/],
  ]) {
    await check(`${what}: a message with what to do, and the text`, async () => {
      const { page, close } = await open(browser, { script });
      const told = await words(page, '#message');
      const text = await page.evaluate(() => document.querySelector('textarea').value);
      await shot(page, `play-${what.split(' ')[0]}-${what.split(' ').at(-1)}`);
      await close();
      return (said_words.test(told) && text.includes('format')) || told;
    });
  }
}

async function looks(browser) {
  for (const [name, asked] of [
    ['play-dark', { dark: true }],
    ['play-phone', { width: 390, height: 844 }],
    ['play-phone-dark', { width: 390, height: 844, dark: true }],
  ]) {
    await check(`${name}: nothing is wider than the page`, async () => {
      const { page, said, close } = await open(browser, asked);
      await page.waitForFunction(() => window.polhode.time() > 0.3);
      await shot(page, name);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      await close();
      return (wide <= (asked.width ?? 1280) && said.length === 0) || `${wide} pixels; ${said.join('; ')}`;
    });
  }
}

const place = findChromium();
if (place === null) {
  console.error('there is no browser: install Chromium, or name one by the variable CHROMIUM');
  process.exit(2);
}
const browser = await chromium.launch({ executablePath: place, args: GL });
for (const part of [runs, hands, bad, addresses, refused, looks]) {
  if (!options.only || options.only.split(',').includes(part.name)) await part(browser);
}
await browser.close();
process.exitCode = failed > 0 ? 1 : 0;
