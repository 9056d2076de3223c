// Where the camera stands so that all points just lie in the picture: the rule of pictures (polhode-view, camera.rs).
//
// Let x, y, z be a point to the right, up and forwards. The camera at (ex, ey, ez) sees it where |x - ex| <= tx (z - ez) and
// |y - ey| <= ty (z - ez). With R = max(x - tx z) and L = max(-x - tx z) over the points, ez <= -(R + L) / (2 tx), and
// ex = (R - L) / 2 puts the camera where both sides are as near; the same up and down. The smaller ez is taken.

import { matrixOf, turn } from './rotation.js';

/** Radius in m of a body of which no bounding box is known. */
const UNKNOWN_RADIUS = 0.5;

/** What page and picture have in common when the page does not say it. */
export const LOOK = {
  field_of_view_rad: 0.6,
  margin: 1.2,
  cameras: [
    { name: 'front', from: [0, -1, 0.12] },
    { name: 'side', from: [1, 0, 0.12] },
    { name: 'top', from: [0, -0.001, 1] },
    { name: 'iso', from: [0.85, -1.25, 0.75] },
  ],
  light: { towards: [-0.35, -0.5, 0.9], lamp: 0.72, ambient: 0.32, sky: 0.3 },
  fixture: '#4a5460',
  axes: ['#c83c3c', '#2f945a', '#2f6fc4'],
};

/** Direction towards the camera when nobody says another: from the front, a little from the right and above. */
export const FROM = [0.55, -1, 0.42];
/** The least distance of a camera, m. */
const LEAST_DISTANCE = 1e-6;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const sum = (a, b, factor = 1) => a.map((value, k) => value + factor * b[k]);

function unit(vector, otherwise) {
  const size = Math.hypot(...vector);
  return size > 0 && Number.isFinite(size) ? vector.map((value) => value / size) : otherwise;
}

/** Smallest and largest coordinates of points. */
export function boundsOf(points) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const point of points) {
    for (let k = 0; k < 3; k += 1) {
      low[k] = Math.min(low[k], point[k]);
      high[k] = Math.max(high[k], point[k]);
    }
  }
  return points.length > 0 ? [low, high] : [[-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]];
}

/** The corners of a box. */
export const cornersOf = (box) =>
  Array.from({ length: 8 }, (_, corner) => [0, 1, 2].map((k) => box[(corner >> k) & 1][k]));

/** The largest distance of a corner of a body's box (in its own frame) from the body's place, m. */
export function radiusOf({ box }) {
  if (!box) return UNKNOWN_RADIUS;
  return Math.hypot(...[0, 1, 2].map((k) => Math.max(Math.abs(box[0][k]), Math.abs(box[1][k]))));
}

/** The middle of the box around points. */
export const middleOf = (points) => {
  const [low, high] = boundsOf(points);
  return low.map((value, k) => (value + high[k]) / 2);
};

/** The points of a run that its first picture holds: what pictures hold too, or the corners of the bodies as they stand. */
export function framed(run, poses) {
  const points = run.frame ? [...run.frame.moving, ...run.frame.standing] : [];
  return points.length > 0 ? points : cornersNow(run, poses, run.bodies.map((_, body) => body));
}

/** The points that a picture of now holds: corners of the bodies that move, and what else is held. */
export function framedNow(run, poses) {
  const { frame, moving } = run;
  const points = [...cornersNow(run, poses, moving), ...(frame && frame.moving.length > 0 ? frame.standing : [])];
  return points.length > 0 ? points : framed(run, poses);
}

/** The corners of the boxes of bodies as they stand now. */
function cornersNow(run, poses, bodies) {
  const turned = new Float64Array(9);
  return bodies.flatMap((body) => {
    const { box, opacity } = run.bodies[body];
    if (!box || opacity === 0) return [];
    matrixOf(poses, 7 * body + 3, turned);
    return cornersOf(box).map((own) => turn(turned, own).map((value, k) => value + poses[7 * body + k]));
  });
}

/**
 * Where the camera stands and what it looks at, { eye, target, distance }: from `from`, so near that all points lie within
 * the slopes `wide` and `high`; with `middle` on the line through that place.
 */
export function holding(points, from, wide, high, middle = null) {
  const forwards = unit(from, [0, -1, 0]).map((value) => -value);
  const right = unit(cross(forwards, [0, 0, 1]), [1, 0, 0]);
  const up = cross(right, forwards);
  const origin = middle ?? middleOf(points);
  let depth = Infinity;
  let place = origin;
  for (const [axis, slope] of [
    [right, wide],
    [up, high],
  ]) {
    let ahead = -Infinity;
    let behind = -Infinity;
    for (const point of points) {
      const arm = sum(point, origin, -1);
      const z = dot(arm, forwards);
      const at = dot(arm, axis);
      ahead = Math.max(ahead, at - slope * z);
      behind = Math.max(behind, -at - slope * z);
    }
    if (middle) {
      depth = Math.min(depth, -Math.max(ahead, behind) / slope);
    } else if (points.length > 0) {
      depth = Math.min(depth, (-0.5 * (ahead + behind)) / slope);
      place = sum(place, axis, 0.5 * (ahead - behind));
    }
  }
  const distance = points.length > 0 && Number.isFinite(depth) ? Math.max(-depth, LEAST_DISTANCE) : 1;
  return { target: place, eye: sum(place, forwards, -distance), distance };
}
