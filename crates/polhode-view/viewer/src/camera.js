// The camera: orbit by mouse or finger, presets, fitting, following a body. z is up.

import { MathUtils, Raycaster, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** Directions from what is looked at to the camera. Top leans a little: straight from above, "up" has no meaning. */
const PRESETS = {
  front: new Vector3(0, -1, 0.12),
  side: new Vector3(1, 0, 0.12),
  top: new Vector3(0, -0.001, 1),
  iso: new Vector3(0.85, -1.25, 0.75),
};
/** Names of all presets; "fit" keeps the direction. */
export const CAMERAS = ['fit', ...Object.keys(PRESETS)];
/** How much wider than what is looked at the picture is: the buttons stand at its rim. */
const MARGIN = 1.3;
/** A press that moves less than this many pixels is a click. */
const CLICK_PIXELS = 5;

/**
 * The distance from the middle of a box, along `direction`, at which all its corners lie in the picture: a corner at x
 * across, y up and z towards the camera is in it when |x| / (distance - z) is at most `wide` and |y| / (distance - z)
 * at most `high`.
 */
function fittingDistance(box, direction, wide, high) {
  const right = new Vector3(0, 0, 1).cross(direction).normalize();
  const up = direction.clone().cross(right);
  const half = box.getSize(new Vector3()).multiplyScalar(0.5);
  let distance = 0;
  for (let corner = 0; corner < 8; corner += 1) {
    const sign = (bit) => ((corner >> bit) & 1 ? 1 : -1);
    const at = new Vector3(half.x * sign(0), half.y * sign(1), half.z * sign(2));
    const needed = Math.max(Math.abs(at.dot(right)) / wide, Math.abs(at.dot(up)) / high);
    distance = Math.max(distance, needed + at.dot(direction));
  }
  return distance;
}

export class Camera {
  constructor(stage, changed) {
    this.stage = stage;
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
    return (PRESETS[name]?.clone() ?? this.stage.camera.position.clone().sub(this.target)).normalize();
  }

  /** How far away a preset looks at a box from; the canvas is divided in so many parts across and down. */
  distance(name, bounds, [across, down]) {
    const { camera, width, height } = this.stage;
    const high = Math.tan(MathUtils.degToRad(camera.fov / 2)) / MARGIN;
    return fittingDistance(bounds, this.direction(name), high * ((width * down) / (height * across) || 1), high);
  }

  /** Looks at a box from a preset's direction. */
  look(name, bounds, divided) {
    const { camera } = this.stage;
    const direction = this.direction(name);
    const distance = this.distance(name, bounds, divided);
    bounds.getCenter(this.target);
    camera.position.copy(this.target).addScaledVector(direction, distance);
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

  /** Calls picked(raycaster, view) for each click; `divided` says in how many parts the canvas is divided across and down. */
  onClick(divided, picked) {
    const { canvas, camera } = this.stage;
    let pressed = null;
    canvas.addEventListener('pointerdown', (event) => {
      pressed = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > CLICK_PIXELS) return;
      const frame = canvas.getBoundingClientRect();
      const [columns, rows] = divided();
      const across = ((event.clientX - frame.left) / frame.width) * columns;
      const down = ((event.clientY - frame.top) / frame.height) * rows;
      const column = Math.min(columns - 1, Math.floor(across));
      const row = Math.min(rows - 1, Math.floor(down));
      const raycaster = new Raycaster();
      raycaster.setFromCamera(new Vector2(2 * (across - column) - 1, 1 - 2 * (down - row)), camera);
      picked(raycaster, row * columns + column);
    });
  }
}
