// The camera: orbit by mouse or finger, presets, fitting, following a body. z is up.

import { MathUtils, Raycaster, Sphere, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** Directions from what is looked at to the camera. Top leans a little, since "up" has no meaning straight from above. */
const PRESETS = {
  front: new Vector3(0, -1, 0.12),
  side: new Vector3(1, 0, 0.12),
  top: new Vector3(0, -0.001, 1),
  iso: new Vector3(0.85, -1.25, 0.75),
};
/** Names of all presets; "fit" keeps the direction. */
export const CAMERAS = ['fit', ...Object.keys(PRESETS)];
/** How much farther than the bounding sphere the picture reaches. */
const MARGIN = 1.12;
/** A press that moves less than this many pixels is a click. */
const CLICK_PIXELS = 5;

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
    const sphere = bounds.getBoundingSphere(new Sphere());
    const half_angle = MathUtils.degToRad(camera.fov / 2);
    const aspect = Math.min(1, (width * share) / height || 1);
    const distance = (MARGIN * sphere.radius) / Math.sin(Math.atan(Math.tan(half_angle) * aspect));
    const direction = PRESETS[name]?.clone() ?? camera.position.clone().sub(this.target);
    this.target.copy(sphere.center);
    camera.position.copy(sphere.center).addScaledVector(direction.normalize(), distance);
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
