// The page at work: one time that is shown, the engines that compute it, and what the reader does to them.

import { byId } from '../controls.js';
import { PageError, wordsOf } from '../errors.js';
import { readScene } from '../show.js';
import { themeSwitch } from '../theme.js';
import { hashOf, sceneIn } from './address.js';
import { Distances } from './distance.js';
import { Editor } from './editor.js';
import { Energies } from './energy.js';
import { Engine, Fault } from './engine.js';
import { listenForFiles, saveText } from './files.js';
import { buildControls, helpRows, listenForKeys, SPEEDS } from './hands.js';
import { Lights } from './light.js';
import { worded } from './numbers.js';
import { Picture } from './picture.js';
import { keepText, keptText } from './store.js';
import { Why } from './why.js';

/** The engine computes ahead of the picture by so much of the clock, s. */
const AHEAD_S = 0.1;
/** The same while the reader holds a body, so that it answers at once. */
const AHEAD_HELD_S = 0.03;
/** Longest step of the clock, s: after a pause of the page the run goes on where it was. */
const LONGEST_TICK = 0.25;
/** How often the page asks for energies and certificate, ms. */
const ASK_EVERY_MS = 250;
/** How far the second copy is away at its start, m. */
const APART_M = 1e-12;
/** Colours of the copies. */
const TRUTH = '#12a150';
const TWIN = '#c2379d';

/** A scene to begin with, where the page holds none. */
const FIRST = `format = 1
name = "first"
duration = 5.0

[materials.wood]
friction = 0.4
restitution = 0.3

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "wood"

[[bodies]]
name = "box"
shape.box.size = [0.4, 0.3, 0.2]
mass = 1.0
position = [0, 0, 0.6]
rotation_vector = [0.4, 0.3, 0]
material = "wood"
`;

export class Playground {
  constructor(given, source) {
    this.given = given;
    this.source = source;
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.beyond = false;
    this.engine = null;
    this.copies = new Map();
    this.hand = null;
    this.told = null;
    this.asked_at = 0;
    this.count = 0;
    this.editor = new Editor(byId('editor'), { typed: () => this.keep(), changed: () => this.edited() });
    this.lights = new Lights(byId('panel'));
    this.energies = new Energies(byId('energies'));
    this.distances = new Distances(byId('distances'));
    this.why = new Why(byId('why'));
    byId('title').textContent = given.title || 'polhode playground';
    this.controls = buildControls(this);
    helpRows(byId('help').querySelector('table'));
    listenForKeys(this);
    listenForFiles(this);
  }

  /** What tests and the browser's console use. */
  published() {
    return {
      ready: new Promise((ready) => (this.whenReady = ready)),
      time: () => this.time,
      seek: (t) => this.seek(t),
      play: () => this.play(),
      pause: () => this.pause(),
      load: (text) => this.take(text),
      hash: () => this.engine.ask({ do: 'ask', name: 'hash' }).then(({ answer }) => answer),
      track: () => this.engine.track,
      copy: (name) => this.copies.get(name)?.track ?? null,
      pick: (body) => this.pick(body),
      toEnd: () => this.toEnd(),
      self: this,
    };
  }

  /** The scene to begin with: of the address, of the page, of what was typed before; and words about the first. */
  async firstText() {
    let words = null;
    try {
      const text = await sceneIn(location.hash);
      if (text !== null) return { text, words };
    } catch (error) {
      words = wordsOf(error);
    }
    const own = this.given.text ?? null;
    const kept = keptText(own);
    if (kept !== null && kept !== own && own !== null && !words) {
      words = 'The text that you typed in this page before is here again.';
      this.anew = own;
    }
    return { text: kept ?? own ?? FIRST, words };
  }

  /** Keeps the text that is typed. */
  keep() {
    keepText(this.given.text ?? null, this.editor.text);
  }

  async start(compiled) {
    const { text, words } = await this.firstText();
    this.editor.text = text;
    if (words) this.notice(words);
    if (this.anew) this.offerAnew();
    this.picture = new Picture(byId('stage'), {
      picked: (body) => this.pick(body),
      grabbed: (body, point) => this.grab(body, point),
      pulled: (point) => this.pull(point),
      released: () => this.release(),
    });
    themeSwitch(byId('theme'), () => this.applyTheme());
    this.module = await compiled();
    this.engine = this.newEngine();
    await this.engine.started;
    for (const [name, base64] of Object.entries(this.given.files ?? {})) {
      await this.addFile(name, Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
    }
    addEventListener('hashchange', () => this.followAddress());
    await this.run();
    requestAnimationFrame((now) => this.tick(now));
    this.playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.whenReady();
  }

  /** A button that brings the page's own scene back. */
  offerAnew() {
    const button = document.createElement('button');
    button.textContent = 'Begin with the scene of the page';
    button.addEventListener('click', () => {
      button.parentElement.remove();
      this.take(this.anew);
    });
    byId('notices').lastElementChild.append(' ', button);
  }

  newEngine() {
    return new Engine(this.source, this.module, {
      mark: (mark) => this.lights.mark(mark),
      broke: (fault, engine) => this.broke(fault, engine),
    });
  }

  async followAddress() {
    if (this.own_hash === location.hash) return;
    try {
      const text = await sceneIn(location.hash);
      if (text !== null) this.take(text);
    } catch (error) {
      this.notice(wordsOf(error));
    }
  }

  notice(words) {
    this.count += 1;
    const line = document.createElement('p');
    line.className = 'mild';
    line.textContent = words;
    const close = document.createElement('button');
    close.textContent = 'Close';
    close.addEventListener('click', () => line.remove());
    line.append(' ', close);
    const holder = byId('notices');
    if ([...holder.children].some((one) => one.firstChild.textContent === words)) return;
    holder.replaceChildren(...[...holder.children].slice(-2), line);
  }

  /** Another scene takes the place of the one in the text. */
  take(text) {
    this.editor.text = text;
    this.keep();
    return this.run({ edited: true });
  }

  edited() {
    return this.run({ edited: true });
  }

  /** Changes that the controls make to the scene. */
  changes(tier = byId('tier').value) {
    const law = byId('law').value;
    return [...(tier ? [`method.tier="${tier}"`] : []), ...(law ? [`method.impact="${law}"`] : [])];
  }

  /** The places of the native program's run that can be compared, if this is that run. */
  native() {
    const { native, text } = this.given;
    return native && text === this.editor.text && this.changes().length === 0 ? native : null;
  }

  /** Runs the text from its start. One that is refused leaves the run as it is, and says where and why. */
  async run({ edited = false } = {}) {
    if (!this.engine) return;
    const text = this.editor.text;
    const number = (this.runs = (this.runs ?? 0) + 1);
    if (this.loading) await this.unlessStuck();
    const native = this.native();
    try {
      this.loading = this.engine.load(text, this.changes(), { marks: native?.marks ?? [] });
      const { show, surface } = await this.loading;
      if (number !== this.runs) return;
      this.showScene(show, surface, native);
      if (edited) {
        this.playing = true;
        this.putIntoAddress(text);
      }
      await this.runCopies(text, number);
    } catch (error) {
      if (number === this.runs) this.refuse(error);
    } finally {
      this.loading = null;
    }
  }

  /** A load before this one that takes too long is given up with its engine. */
  async unlessStuck() {
    const waited = new Promise((over) => setTimeout(over, 1500, 'stuck'));
    const ended = await Promise.race([this.loading.catch(() => null), waited]);
    if (ended === 'stuck') this.engine.restart();
  }

  showScene(show, surface, native) {
    this.editor.accept();
    const scene = readScene(show);
    this.scene = scene;
    document.title = scene.title;
    byId('title').textContent = scene.title;
    byId('description').textContent = scene.description;
    byId('description').hidden = scene.description === '';
    this.time = 0;
    this.beyond = false;
    this.hand = null;
    this.told = null;
    this.lights.begin(native);
    this.energies.clear();
    this.distances.clear();
    this.why.clear();
    this.picture.show(scene);
    this.controls.showSurface(surface);
    this.controls.showSpeed(this.firstSpeed(scene.runs[0].duration));
  }

  /** Short scenes are slowed down at first, long ones sped up. */
  firstSpeed(duration) {
    if (this.shown_duration === duration) return this.speed;
    this.shown_duration = duration;
    this.speed = duration < 1 ? (SPEEDS.findLast((speed) => speed <= duration / 2) ?? SPEEDS[0]) : 1;
    return this.speed;
  }

  refuse(error) {
    if (error instanceof Fault && !error.grave) this.editor.refuse(error.message, error.places);
    else this.notice(`${error instanceof Fault ? error.message : wordsOf(error)} Your text is kept.`);
  }

  broke(fault, engine) {
    if (engine !== this.engine) return;
    this.pause();
    this.notice(`The run ended: ${fault.message}. Change the scene, or go back and act in another way; your text is kept.`);
    if (fault.grave) engine.restart();
  }

  async putIntoAddress(text) {
    try {
      this.own_hash = await hashOf(text);
      history.replaceState(null, '', this.own_hash);
    } catch {
      this.own_hash = null;
    }
  }

  // Copies: the accurate run, and a second one that begins a little apart.

  async setCopy(name, on) {
    byId(name).setAttribute('aria-pressed', String(on));
    this.copies.get(name)?.end();
    this.copies.delete(name);
    this.distances.drop(name);
    this.picture.setGhost(name, null);
    if (!on) return;
    // The truth is held against the fast method, unless another one is chosen.
    if (name === 'truth' && byId('tier').value === '') {
      byId('tier').value = 'fast';
      this.copies.set(name, this.newEngine());
      this.distances.begin(name, 'Truth', TRUTH);
      await this.run();
      return;
    }
    this.copies.set(name, this.newEngine());
    this.distances.begin(name, name === 'truth' ? 'Truth' : 'Second copy', name === 'truth' ? TRUTH : TWIN);
    await this.run();
  }

  async runCopies(text, number) {
    for (const [name, copy] of this.copies) {
      const changes = name === 'truth' ? this.changes('accurate') : this.changes();
      try {
        for (const [file, bytes] of this.engine.files) if (!copy.files.has(file)) await copy.addFile(file, bytes);
        const { shifted } = await copy.load(text, changes, { shift: name === 'twin' ? APART_M : 0 });
        if (number !== this.runs) return;
        if (name === 'twin' && shifted === null) throw new PageError('no body of this scene can be moved by itself');
        this.picture.setGhost(name, name === 'truth' ? TRUTH : TWIN);
      } catch (error) {
        if (number !== this.runs) return;
        this.notice(`${name === 'truth' ? 'The accurate method' : 'A second copy'} refuses this scene: ${error.message}`);
        this.setCopy(name, false);
      }
    }
  }

  tracks() {
    return [this.engine?.track, ...[...this.copies.values()].map((copy) => copy.track)].filter(Boolean);
  }

  // Time.

  play() {
    const { track } = this.engine;
    if (track?.ended && this.time >= track.end && !this.beyond) this.time = track.first;
    this.playing = true;
  }

  pause() {
    this.playing = false;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  seek(t) {
    const { track } = this.engine;
    this.time = Math.min(track.end, Math.max(track.first, t));
    this.show();
  }

  restart() {
    this.run();
    this.playing = true;
  }

  /** Computes to the end of the scene; the promise of its hash. */
  async toEnd() {
    this.pause();
    const { track } = this.engine;
    while (!track.ended && !track.done) {
      this.engine.goTo(track.duration, false);
      await new Promise((over) => setTimeout(over, 5));
    }
    this.time = track.end;
    return (await this.engine.ask({ do: 'ask', name: 'hash' })).answer;
  }

  tick(now) {
    requestAnimationFrame((next) => this.tick(next));
    const clock = Math.min(LONGEST_TICK, (now - (this.before ?? now)) / 1000);
    this.before = now;
    const { track } = this.engine;
    if (track && this.playing) this.advance(track, clock);
    if (track) this.show();
    if (this.engine.isStuck()) this.stuck();
    else if (this.told_stuck) this.goesOn();
    if (now - this.asked_at > ASK_EVERY_MS && track && !this.asking) this.askReport(now);
  }

  advance(track, clock) {
    const wanted = this.time + clock * this.speed;
    const ahead = this.hand ? AHEAD_HELD_S : AHEAD_S;
    for (const engine of [this.engine, ...this.copies.values()]) engine.goTo(wanted + ahead * this.speed, this.beyond);
    const ready = Math.min(...this.tracks().map((one) => one.end));
    if (wanted > this.time) this.time = Math.max(this.time, Math.min(wanted, ready));
    const ended = track.ended && !this.beyond && this.time >= track.end;
    if (ended || (track.done && this.time >= track.end)) this.pause();
  }

  stuck() {
    if (this.told_stuck) return;
    this.told_stuck = true;
    const words = 'The engine has been in one step for seconds: this scene may never end.';
    this.notice(`${words} “Stop” ends it and keeps your text; a larger step or another method may help.`);
    const stop = document.createElement('button');
    stop.id = 'stop';
    stop.textContent = 'Stop';
    stop.addEventListener('click', () => this.stop());
    byId('notices').lastElementChild.append(stop);
  }

  /** The step came to its end after all. */
  goesOn() {
    byId('stop')?.parentElement.remove();
    this.told_stuck = false;
  }

  stop() {
    this.pause();
    this.engine.restart();
    for (const copy of this.copies.values()) copy.restart();
    byId('notices').replaceChildren();
    this.told_stuck = false;
    this.editor.refuse('Stopped. Change the scene, and it runs again.', []);
  }

  show() {
    const { picture, engine } = this;
    const { track } = engine;
    if (!picture.run || track.times.length === 0 || track.width !== picture.poses.length) return;
    if (this.time !== this.shown_time || track.end !== this.shown_end) {
      track.at(this.time, picture.poses);
      for (const [name, copy] of this.copies) {
        const ghost = picture.ghosts.get(name);
        if (ghost && copy.track?.width === ghost.poses.length) copy.track.at(this.time, ghost.poses);
      }
      picture.dirty = true;
      this.shown_time = this.time;
      this.shown_end = track.end;
    }
    if (this.hand && track.held.length > 0) picture.setHand([...this.hand, ...track.held.slice(3)]);
    else if (picture.hand.length > 0) picture.setHand([]);
    byId('pull').hidden = picture.hand.length === 0;
    if (picture.hand.length > 0) byId('pull').textContent = `You pull with ${worded(Math.hypot(...picture.hand.slice(6)), 'N')}`;
    this.measure(track);
    this.distances.draw(this.time, picture.size);
    this.controls.showTime(this, track);
    picture.draw();
  }

  /** Adds the distances of the copies at the times that all have reached. */
  measure(track) {
    for (const [name, copy] of this.copies) {
      if (copy.track?.width !== track.width || copy.track.times.length === 0) continue;
      const until = Math.min(this.time, copy.track.end, track.end);
      const step = track.duration / 400;
      if (until - Math.max(0, this.distances.lastTime(name)) < step && this.distances.lastTime(name) >= 0) continue;
      const body = this.picture.run.moving;
      this.distances.add(name, until, track.distance(copy.track, until, body));
    }
  }

  async askReport(now) {
    this.asked_at = now;
    this.asking = true;
    const { engine } = this;
    const number = this.runs;
    try {
      if (engine.track.steps > 0) {
        const { answer } = await engine.ask({ do: 'ask', name: 'told' });
        if (number === this.runs) {
          this.told = JSON.parse(answer);
          this.energies.show(this.told);
          this.lights.show(this.told, this.time);
          this.controls.showPace(engine.track);
        }
      }
    } catch {
      // The engine was stopped or the run has ended; the page has said so.
    }
    this.asking = false;
  }

  // What the reader does.

  /** Does something to all copies at the time that is shown. */
  async act(name, args) {
    this.beyond = true;
    this.distances.cut(this.time);
    const answers = [this.engine, ...this.copies.values()].map((engine) => engine.act(name, args, this.time));
    try {
      const [{ surface }] = await Promise.all(answers);
      this.controls.showSurface(surface);
    } catch (fault) {
      this.notice(`${fault.message}.`);
    }
  }

  grab(body, point) {
    this.hand = point;
    this.playing = true;
    this.select(body);
    return this.act('grab', [body, ...point]);
  }

  pull(point) {
    if (!this.hand) return;
    this.hand = point;
    for (const engine of [this.engine, ...this.copies.values()]) engine.send({ do: 'pull', args: point });
  }

  release() {
    this.hand = null;
    for (const engine of [this.engine, ...this.copies.values()]) {
      engine.ask({ do: 'ask', name: 'release' }).catch(() => {});
    }
  }

  /** Pushes the body that is looked at away from the reader, as fast as it falls by half its size. */
  push() {
    const { picture } = this;
    const body = picture.selected;
    if (body === null || !picture.run.bodies[body].moves) return;
    const away = picture.stage.camera.getWorldDirection(picture.camera.target.clone()).toArray();
    const up = this.scene.gravity ?? [0, 0, -9.81];
    const size = Math.hypot(...up);
    const along = size > 0 ? away.reduce((sum, value, k) => sum + (value * up[k]) / size, 0) : 0;
    const flat = away.map((value, k) => value - (size > 0 ? (along * up[k]) / size : 0));
    const speed = Math.sqrt((size || 9.81) * picture.radii[body]) / (Math.hypot(...flat) || 1);
    const at = 7 * body;
    this.playing = true;
    this.act('push', [body, [...picture.poses.slice(at, at + 3)], flat.map((value) => value * speed)]);
  }

  setFriction(value) {
    return this.act('set_friction', [value]);
  }

  setRestitution(value) {
    return this.act('set_restitution', [value]);
  }

  select(body) {
    this.picture.select(body);
    if (body === null) {
      this.why.clear();
      this.picture.setForces(null);
    }
  }

  /** The forces on a body at the time that is shown. */
  async pick(body) {
    this.select(body);
    if (body === null) return;
    this.pause();
    const run = this.picture.run;
    const { name } = run.bodies[body];
    const { engine } = this;
    if (!run.bodies[body].moves) {
      this.why.refuse(name, 'It is fixed, or moves as prescribed: forces do not move it. Click a body that moves.');
      this.picture.setForces(null);
      return;
    }
    try {
      const { answer } = await engine.ask({ do: 'ask', name: 'why', args: [body], at: this.time });
      const why = JSON.parse(answer);
      if (this.picture.selected !== body) return;
      const touches = this.why.show(why, this.scene.gravity);
      this.picture.setForces(why.forces.map(({ point, force }) => ({ point, force })));
      if (!touches) return;
      const { answer: margins } = await engine.ask({ do: 'ask', name: 'margins', at: this.time });
      if (this.picture.selected === body) this.why.showMargins(JSON.parse(margins));
    } catch (fault) {
      this.why.refuse(name, fault.message);
    }
  }

  applyTheme() {
    this.picture.applyTheme();
    this.picture.dirty = true;
  }

  // Files.

  async addFile(name, bytes) {
    for (const engine of [this.engine, ...this.copies.values()]) await engine.addFile(name, bytes);
  }

  /** The text of the scene that a file stands for, which was added. */
  async sceneOf(name) {
    return (await this.engine.ask({ do: 'ask', name: 'scene_of', args: [name] })).answer;
  }

  saveText() {
    saveText(this.editor.text, `${this.scene?.runs[0].name ?? 'scene'}.toml`);
  }

  async link() {
    await this.putIntoAddress(this.editor.text);
    const { href } = location;
    try {
      await navigator.clipboard.writeText(href);
      this.notice(`The link is copied: ${worded(href.length)} letters. Whoever opens it, sees this scene.`);
    } catch {
      this.notice('The address of this page is now the scene: copy it from the address bar.');
    }
  }
}
