// The picture: renderer, light, camera, and one or two views of it.

import {
  Color,
  DirectionalLight,
  HemisphereLight,
  LinearSRGBColorSpace,
  MathUtils,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { PageError } from './errors.js';
import { LOOK } from './framing.js';
import { colour } from './theme.js';

/** Pixels of the shadow map along its edge. */
const SHADOW_PIXELS = 1024;
/** Names of renderers that draw on the processor. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Whether WebGL is drawn by the processor, because there is no graphics card or no driver. */
export function drawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return SOFTWARE.test(name);
}

/** In how many parts a row or a column of views divides the picture: across and down. */
export function parts(arrangement, views) {
  return arrangement === 'column' ? [1, views] : [views, 1];
}

export class Stage {
  /** `look` is { shadows, antialias }; `shared` what page and picture have in common. */
  constructor(canvas, { shadows, antialias }, shared = LOOK) {
    this.canvas = canvas;
    this.shared = shared;
    try {
      this.renderer = new WebGLRenderer({ canvas, antialias });
    } catch {
      throw new PageError('This browser draws no WebGL, so the bodies cannot be shown. The numbers can be saved.');
    }
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.shadowMap.enabled = shadows;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(MathUtils.radToDeg(shared.field_of_view_rad), 1, 0.1, 1000);
    this.camera.up.set(0, 0, 1);
    // A surface of albedo a sends a (ambient (1 + sky n.z) + lamp n.l), as in pictures; three.js divides by pi.
    const { towards, lamp, ambient, sky } = shared.light;
    this.towards = new Vector3(...towards).normalize();
    const grey = (value) => new Color().setRGB(value, value, value, LinearSRGBColorSpace);
    this.sky = new HemisphereLight(grey(1), grey((1 - sky) / (1 + sky)), Math.PI * ambient * (1 + sky));
    this.sky.position.set(0, 0, 1);
    this.sun = new DirectionalLight(0xffffff, Math.PI * lamp);
    this.sun.castShadow = shadows;
    this.sun.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.sun.shadow.radius = 3;
    this.scene.add(this.sky, this.sun, this.sun.target);
    this.scene.background = new Color();
    this.applyTheme();
  }

  applyTheme() {
    this.scene.background.setStyle(colour('stage'));
  }

  /** Where the camera is, and how many pixels a thing of one metre has at a distance of one metre. */
  eye() {
    const pixels = this.canvas.clientHeight / 2 / Math.tan(this.shared.field_of_view_rad / 2);
    return { place: this.camera.position, pixels };
  }

  /** Fits the drawing to the canvas's place in the page; true where it changed. */
  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === this.width && clientHeight === this.height) return false;
    this.width = clientWidth;
    this.height = clientHeight;
    this.renderer.setSize(clientWidth, clientHeight, false);
    return true;
  }

  /** The shadow map covers what the camera looks at, so that its grain follows the distance of the camera. */
  aimLight(target) {
    const distance = this.camera.position.distanceTo(target);
    this.camera.near = distance / 100;
    this.camera.far = distance * 40;
    this.sun.target.position.copy(target);
    this.sun.position.copy(target).addScaledVector(this.towards, 2 * distance);
    const { camera, map } = this.sun.shadow;
    const reach = 0.75 * distance;
    Object.assign(camera, { left: -reach, right: reach, bottom: -reach, top: reach, near: 0, far: 4 * distance });
    camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = (3 * reach) / (map ? map.width : SHADOW_PIXELS);
  }

  /** Draws every group of `views` in its own part of the canvas, in a `row` or a `column`; a view is a list of groups. */
  draw(views, target, arrangement) {
    if (!(this.width > 0 && this.height > 0)) return;
    this.aimLight(target);
    const [across, down] = parts(arrangement, views.length);
    const [width, height] = [this.width / across, this.height / down];
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setScissorTest(views.length > 1);
    views.forEach((shown, index) => {
      for (const group of views.flat()) group.visible = shown.includes(group);
      // The first stands at the left, or at the top; WebGL counts from below.
      const [left, below] = down > 1 ? [0, (down - 1 - index) * height] : [index * width, 0];
      this.renderer.setViewport(left, below, width, height);
      this.renderer.setScissor(left, below, width, height);
      this.renderer.render(this.scene, this.camera);
    });
  }
}
