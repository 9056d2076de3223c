// The camera: orbit by mouse or finger, presets, framing, following a body. z is up.

import { MathUtils, Raycaster, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { cornersOf, FROM, holding, LOOK, middleOf } from './framing.js';

/** Names of all presets; "fit" keeps the direction, "home" is the first view of the page. */
export const CAMERAS = ['fit', 'home', ...LOOK.cameras.map(({ name }) => name)];
/** Height in CSS pixels of the buttons at the upper and the lower rim, and the least share of the picture without them. */
const BUTTONS = 44;
const LEAST_SHARE = 0.6;
/** A press that moves less than this many pixels is a click. */
const CLICK_PIXELS = 5;

export class Camera {
  /** `home` says from where the page looks at first, and may be null. */
  constructor(stage, changed, home = null) {
    this.stage = stage;
    this.shared = stage.shared;
    this.home = home;
    this.changed = changed;
    this.controls = new OrbitControls(stage.camera, stage.canvas);
    this.controls.addEventListener('change', changed);
    this.tracked = null;
  }

  get target() {
    return this.controls.target;
  }

  /** From where a preset looks. */
  direction(name) {
    if (name === 'home') return this.home?.from ?? FROM;
    const preset = this.shared.cameras.find((camera) => camera.name === name);
    return preset?.from ?? this.stage.camera.position.clone().sub(this.target).toArray();
  }

  /** Where a preset stands to hold all points, or a box of three.js; the canvas is divided in so many parts across and down. */
  place(name, held, [across, down]) {
    const points = held.isBox3 ? cornersOf([held.min.toArray(), held.max.toArray()]) : held;
    const { camera, width, height } = this.stage;
    const home = name === 'home' ? this.home : null;
    if (home?.eye) return { eye: home.eye, target: home.look_at ?? middleOf(points) };
    const [wide, high] = [width / across || 1, height / down || 1];
    const slope = Math.tan(MathUtils.degToRad(camera.fov / 2)) / this.shared.margin;
    const share = Math.max(LEAST_SHARE, 1 - (2 * BUTTONS) / high);
    return holding(points, this.direction(name), (slope * wide) / high, slope * share, home?.look_at ?? null);
  }

  /** How far away a preset stands. */
  distance(name, points, divided) {
    const { eye, target } = this.place(name, points, divided);
    return Math.hypot(...eye.map((value, k) => value - target[k]));
  }

  /** Looks at points from a preset's direction, so that all are seen. */
  look(name, points, divided) {
    const { camera } = this.stage;
    const { eye, target } = this.place(name, points, divided);
    this.target.set(...target);
    camera.position.set(...eye);
    const distance = camera.position.distanceTo(this.target);
    camera.near = distance / 100;
    camera.far = distance * 40;
    this.controls.update();
    this.changed();
  }

  /** Keeps a moving place in the middle: camera and target move along with it. */
  track(place) {
    if (place && this.tracked) {
      const moved = place.clone().sub(this.tracked);
      this.target.add(moved);
      this.stage.camera.position.add(moved);
    } else if (place) {
      this.stage.camera.position.add(place.clone().sub(this.target));
      this.target.copy(place);
    }
    this.tracked = place;
    this.controls.update();
  }

  /**
   * Calls picked(raycaster, view, twice) for each click, `twice` for a double one; `divided` says in how many parts the canvas
   * is divided across and down.
   */
  onClick(divided, picked) {
    const { canvas, camera } = this.stage;
    let pressed = null;
    const pick = (event, twice) => {
      const frame = canvas.getBoundingClientRect();
      const [columns, rows] = divided();
      const across = ((event.clientX - frame.left) / frame.width) * columns;
      const down = ((event.clientY - frame.top) / frame.height) * rows;
      const column = Math.min(columns - 1, Math.floor(across));
      const row = Math.min(rows - 1, Math.floor(down));
      const raycaster = new Raycaster();
      raycaster.setFromCamera(new Vector2(2 * (across - column) - 1, 1 - 2 * (down - row)), camera);
      picked(raycaster, row * columns + column, twice);
    };
    canvas.addEventListener('pointerdown', (event) => {
      pressed = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > CLICK_PIXELS) return;
      pick(event, false);
    });
    canvas.addEventListener('dblclick', (event) => pick(event, true));
  }
}

/** Where a place of the world is on the canvas, in CSS pixels from its upper left corner; null where it is not seen. */
export function spotOf(place, camera, [left, top, width, height]) {
  const seen = new Vector3(...place).project(camera);
  if (!(seen.z > -1 && seen.z < 1)) return null;
  return [left + ((seen.x + 1) / 2) * width, top + ((1 - seen.y) / 2) * height];
}
