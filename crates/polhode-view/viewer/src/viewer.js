// The viewer: one time, one camera, one or two views of runs, drawn again whenever something changed.

import { meshGeometry } from './bodies.js';
import { BodyCard, BodyLabels } from './bodycard.js';
import { Camera } from './camera.js';
import { byId, cameraButtons, followList, helpDialog, overlayButtons, playControls, showLegend } from './controls.js';
import { EventList } from './eventlist.js';
import { listen } from './keyboard.js';
import { notice } from './notices.js';
import { buildPlots } from './panel.js';
import { Playback } from './playback.js';
import { Scale } from './scale.js';
import { drawnBySoftware, parts, Stage } from './stage.js';
import { themeSwitch } from './theme.js';
import { Timeline } from './timeline.js';
import { View } from './view.js';

/** With more bodies than this there are no shadows, and sharp edges are off at first. */
const MANY_BODIES = 500;
/** Frames over which the time of a frame is averaged. */
const FRAMES_AVERAGED = 60;
/** Longest step of the clock in s: after a pause of the whole page the run goes on where it was. */
const LONGEST_TICK = 0.25;
/** Below this width of the page in CSS pixels two runs are drawn over each other at first. */
const NARROW_PIXELS = 700;
/** Whether the reader prefers that nothing moves by itself. */
const STILL = '(prefers-reduced-motion: reduce)';

/** Triangles of all bodies; software draws each of them for the shadow too, and three times as slowly when smoothed. */
const SOFTWARE_TRIANGLES = 60000;

/** Triangles of the bodies of all runs together. */
function trianglesOf(show) {
  const of_mesh = show.meshes.map((mesh) => mesh.indices.length / 3);
  const bodies = show.runs.flatMap((run) => run.bodies);
  return bodies.flatMap((body) => body.parts).reduce((sum, part) => sum + of_mesh[part.mesh], 0);
}

export class Viewer {
  constructor(show) {
    this.show = show;
    const many = Math.max(...show.runs.map((run) => run.bodies.length)) > MANY_BODIES;
    const slow = trianglesOf(show) > SOFTWARE_TRIANGLES && drawnBySoftware();
    const shadows = !many && !slow;
    this.stage = new Stage(byId('stage'), { shadows, antialias: !slow }, show.look);
    this.playback = new Playback(show.runs);
    this.dirty = true;
    /** Whether the last picture lacks frames that are being unpacked. */
    this.incomplete = true;
    this.waiting = [];
    this.frame_times = [];
    this.frames_drawn = 0;
    const tell = {
      requestDraw: () => (this.dirty = true),
      loaded: () => (this.dirty ||= this.incomplete),
      broken: (words) => notice(words, true),
    };
    const geometries = show.meshes.map(meshGeometry);
    const look = { shadows, edges: !many, fixture: show.look.fixture, gravity: show.gravity };
    const scales = new Map();
    this.views = show.runs.map((run) => new View(run, geometries, look, tell, scales, () => this.stage.eye()));
    for (const view of this.views) this.stage.scene.add(view.group);
    this.on = new Set(many ? [] : ['edges']);
    for (const view of this.views) view.setOverlay('edges', !many);
    /** How views that share the picture stand: what brings the bodies closer is chosen when they are fitted. */
    this.arrangement = 'row';
    this.camera = new Camera(this.stage, tell.requestDraw, show.runs[0].frame);
    const ground = this.views[0].ground;
    this.scale = new Scale(byId('scale'), show.look.axes, ground.holders.length > 0 ? ground.cell : null);
    this.card = new BodyCard(byId('card'));
    this.body_labels = this.views.map((view) => new BodyLabels(byId('body-labels'), view.run));
    this.seek = (t) => {
      this.playback.seek(t);
      this.dirty = true;
      return this.drawn();
    };
    this.buildControls();
    this.setLayout(innerWidth < NARROW_PIXELS ? 'over' : 'side');
  }

  buildControls() {
    const { playback, show, views } = this;
    const changed = () => (this.dirty = true);
    this.showPlaying = playControls(playback, changed);
    this.showOverlays = overlayButtons(views, (name) => this.toggleOverlay(name));
    this.showFollowed = followList(views[0].run, (body) => this.follow(body));
    cameraButtons((name) => this.look(name));
    this.events = new EventList(byId('events'), show.runs, playback.duration, () => this.timeline.refresh(), this.seek);
    this.timeline = new Timeline(byId('timeline'), playback, show.runs, () => this.events.marks(), this.seek);
    this.plots = buildPlots(byId('plots'), views, playback, this.seek);
    themeSwitch(byId('theme'), () => this.applyTheme());
    listen({
      playback,
      changed,
      event: (forward) => {
        const t = this.events.neighbour(playback.time, forward);
        if (t !== null) this.seek(t);
      },
      fit: () => this.look('fit'),
      home: () => this.look('home'),
      unfollow: () => {
        this.follow(null);
        this.card.show(null);
      },
      overlay: (name) => this.toggleOverlay(name),
      help: helpDialog(),
    });
    this.stage.canvas.addEventListener('webglcontextrestored', changed);
    byId('layout').hidden = views.length < 2;
    byId('layout').addEventListener('click', () => this.setLayout(this.layout === 'side' ? 'over' : 'side'));
    this.camera.onClick(
      () => this.divided(),
      (raycaster, picture, twice) => this.pick(raycaster, this.pictures()[picture], twice),
    );
    this.showOverlays(this.on);
  }

  applyTheme() {
    this.stage.applyTheme();
    for (const view of this.views) view.applyTheme();
    this.timeline.refresh();
    for (const plot of this.plots) plot.refresh();
    this.dirty = true;
  }

  /** What is drawn from left to right, or from above: for each part of the picture its views. */
  pictures() {
    return this.layout === 'side' ? this.views.map((view) => [view]) : [this.views];
  }

  /** In how many parts the picture is divided, across and down. */
  divided() {
    return parts(this.arrangement, this.pictures().length);
  }

  /** Two runs 'side' by side, or the second as a ghost 'over' the first. */
  setLayout(layout) {
    this.layout = this.views.length < 2 ? 'over' : layout;
    this.views.slice(1).forEach((view) => view.setGhost(this.layout === 'over'));
    for (const view of this.views) view.setOverlay('edges', this.on.has('edges'));
    byId('layout').textContent = this.layout === 'side' ? 'Overlay' : 'Side by side';
    const labels = this.views.map((view, index) => {
      const label = document.createElement('span');
      label.textContent = this.layout === 'over' && index > 0 ? `${view.run.name} (ghost)` : view.run.name;
      return label;
    });
    byId('labels').replaceChildren(...(this.views.length < 2 ? [] : labels));
    this.arrange(this.arrangement);
  }

  /** Views that share the picture stand in a 'row' or a 'column'. */
  arrange(arrangement) {
    this.arrangement = arrangement;
    byId('labels').className = this.layout === 'side' ? arrangement : this.layout;
    this.dirty = true;
  }

  setOverlay(name, on) {
    if (on) this.on.add(name);
    else this.on.delete(name);
    for (const view of this.views) view.setOverlay(name, on);
    this.showOverlays(this.on);
    this.dirty = true;
  }

  toggleOverlay(name) {
    this.setOverlay(name, !this.on.has(name));
  }

  follow(body) {
    for (const view of this.views) view.followed = body;
    this.camera.tracked = null;
    if (body !== null) this.camera.track(this.views[0].placeOf(body));
    this.showFollowed(body);
    this.dirty = true;
  }

  /** A click shows the numbers of a body, a double one follows it; beside all bodies it shows none. */
  pick(raycaster, views, twice) {
    const hits = views.map((view) => view.bodies.pick(raycaster)).filter(Boolean);
    const nearest = hits.reduce((best, hit) => (best && best.distance <= hit.distance ? best : hit), null);
    const body = nearest?.body ?? null;
    const first = this.views[0].run.bodies;
    if (twice) {
      if (first[body]?.moves) this.follow(body);
    } else {
      this.card.show(body !== null && body < first.length ? body : null);
    }
    this.dirty = true;
  }

  /** Looks from a preset at points: by default at the bodies as they stand now, of the first view at what it holds. */
  look(name, points = this.views.flatMap((view) => (name === 'home' ? view.framed() : view.framedNow()))) {
    this.stage.resize();
    this.camera.tracked = null;
    const views = this.pictures().length;
    const distance = (arrangement) => this.camera.distance(name, points, parts(arrangement, views));
    this.arrange(distance('column') < distance('row') ? 'column' : 'row');
    this.camera.look(name, points, this.divided());
  }

  /** A promise that is kept when the picture of the present time has been drawn. */
  drawn() {
    return new Promise((kept) => this.waiting.push(kept));
  }

  /** Draws the first picture from the first chunk, and from then on whatever changes. */
  async start() {
    await Promise.all(this.views.map(({ frames, run }) => (run.chunks.length > 0 ? frames.load(0) : null)));
    for (const view of this.views) view.moveTo(this.playback.time, true);
    this.look('home');
    let before = performance.now();
    const tick = (now) => {
      const clock_s = Math.max(0, Math.min(LONGEST_TICK, (now - before) / 1000));
      this.tick(clock_s, now - before);
      before = now;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    await this.drawn();
    if (this.show.plays_at_once && !matchMedia(STILL).matches) {
      this.playback.loop = true;
      this.playback.play();
      this.dirty = true;
    }
  }

  tick(clock_s, elapsed_ms) {
    const { playback } = this;
    if (playback.playing) {
      playback.advance(clock_s, (t) => this.views.every(({ frames }) => frames.ready(frames.frameAt(t))));
      this.frame_times.push(elapsed_ms);
      if (this.frame_times.length > FRAMES_AVERAGED) this.frame_times.shift();
      this.dirty = true;
    }
    if (this.stage.resize()) this.dirty = true;
    if (this.dirty) this.draw();
  }

  draw() {
    this.dirty = false;
    const { playback, views } = this;
    const states = views.map((view) => view.moveTo(playback.time, playback.interpolate));
    const followed = views[0].followed;
    if (followed !== null) this.camera.track(views[0].placeOf(followed));
    this.stage.draw(
      this.pictures().map((list) => list.map((view) => view.group)),
      this.camera.target,
      this.arrangement,
    );
    this.frames_drawn += 1;
    const spin = Math.max(...views.map((view) => view.snapshot.fastestSpin()));
    this.showPlaying(views[0].snapshot.frame, views[0].run.times.length, spin);
    this.timeline.draw();
    for (const plot of this.plots) plot.draw();
    this.events.update(playback.time, playback.playing);
    showLegend(views.flatMap((view) => view.legend()));
    this.drawWords();
    this.incomplete = !states.every(Boolean);
    // A scale of arrows may have grown; then this is not yet the final picture either.
    if (this.dirty || this.incomplete) return;
    for (const kept of this.waiting.splice(0)) kept();
  }

  /** Axes, scale, the numbers of a body and the words beside bodies. */
  drawWords() {
    const { stage, views } = this;
    const [across, down] = this.divided();
    const [width, height] = [stage.width / across, stage.height / down];
    const distance = stage.camera.position.distanceTo(this.camera.target);
    this.scale.draw(stage.camera, stage.eye().pixels / down / distance);
    this.card.draw(views[0]);
    views.forEach((view, index) => {
      const place = this.layout === 'side' ? index : 0;
      const part = [across > 1 ? place * width : 0, down > 1 ? place * height : 0, width, height];
      this.body_labels[index].draw(view.snapshot, stage.camera, part);
    });
  }

  stats() {
    const sum = this.frame_times.reduce((total, time) => total + time, 0);
    return {
      frames_drawn: this.frames_drawn,
      ms_per_frame: this.frame_times.length > 0 ? sum / this.frame_times.length : null,
      bytes_decoded: this.views.reduce((total, { frames }) => total + frames.bytes_decoded, 0),
    };
  }
}
