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

  /** Looks at a box from a preset's direction; `share` is the part of the canvas's width that one view has. */
  look(name, bounds, share) {
    const { camera, width, height } = this.stage;
    const direction = (PRESETS[name]?.clone() ?? camera.position.clone().sub(this.target)).normalize();
    const across = Math.tan(MathUtils.degToRad(camera.fov / 2)) / MARGIN;
    const distance = fittingDistance(bounds, direction, across * ((width * share) / height || 1), across);
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

  /** Calls picked(raycaster, x) for each click; x in 0..1 is the place across the canvas. */
  onClick(views_across, picked) {
    const { canvas, camera } = this.stage;
    let pressed = null;
    canvas.addEventListener('pointerdown', (event) => {
      pressed = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > CLICK_PIXELS) return;
      const frame = canvas.getBoundingClientRect();
      const across = ((event.clientX - frame.left) / frame.width) * views_across();
      const view = Math.min(views_across() - 1, Math.floor(across));
      const down = (event.clientY - frame.top) / frame.height;
      const raycaster = new Raycaster();
      raycaster.setFromCamera(new Vector2(2 * (across - view) - 1, 1 - 2 * down), camera);
      picked(raycaster, view);
    });
  }
}
