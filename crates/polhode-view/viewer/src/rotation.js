// Rotations by unit quaternions [w, x, y, z], body to world, in plain arrays.

/** out = a b, quaternions [w, x, y, z]. */
function product(a, b) {
  return [
    a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
    a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
    a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
    a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
  ];
}

/** The quaternion of a rotation vector in rad, times s. */
function exponential(vector, s) {
  const angle = Math.hypot(vector[0], vector[1], vector[2]);
  if (!(angle > 0)) return [1, 0, 0, 0];
  const scale = Math.sin(0.5 * s * angle) / angle;
  return [Math.cos(0.5 * s * angle), scale * vector[0], scale * vector[1], scale * vector[2]];
}

/** The rotation vector, of at most half a turn, of a quaternion of length one. */
function logarithm(q) {
  const sign = q[0] < 0 ? -1 : 1;
  const sine = Math.hypot(q[1], q[2], q[3]);
  if (!(sine > 0)) return [0, 0, 0];
  const scale = (sign * 2 * Math.atan2(sine, sign * q[0])) / sine;
  return [scale * q[1], scale * q[2], scale * q[3]];
}

/**
 * The orientation at the fraction s of a time h between two frames, whose orientations are a and b and whose angular
 * velocities have the mean w (rad/s): out = exp(s rho) exp(s h w) a with rho = log(b (exp(h w) a)^-1). Two orientations alone
 * do not say how often and which way a body has turned; the shortest way is wrong from half a turn on.
 */
export function turnBetween(out, at, a, b, w, h, s) {
  const turned = w.map((value) => value * h);
  const reached = product(exponential(turned, 1), a);
  const rest = logarithm(product(b, [reached[0], -reached[1], -reached[2], -reached[3]]));
  const q = product(exponential(rest, s), product(exponential(turned, s), a));
  for (let k = 0; k < 4; k += 1) out[at + k] = q[k];
  normalise(out, at);
}

/** Scales a quaternion to length one; a zero quaternion becomes the identity. */
export function normalise(q, at) {
  const length = Math.hypot(q[at], q[at + 1], q[at + 2], q[at + 3]);
  if (!(length > 0)) {
    q[at] = 1;
    q[at + 1] = q[at + 2] = q[at + 3] = 0;
    return;
  }
  for (let k = 0; k < 4; k += 1) q[at + k] /= length;
}

/** The 3x3 rotation matrix, row by row, of the quaternion at `at`. */
export function matrixOf(q, at, out) {
  const w = q[at];
  const x = q[at + 1];
  const y = q[at + 2];
  const z = q[at + 3];
  out[0] = 1 - 2 * (y * y + z * z);
  out[1] = 2 * (x * y - w * z);
  out[2] = 2 * (x * z + w * y);
  out[3] = 2 * (x * y + w * z);
  out[4] = 1 - 2 * (x * x + z * z);
  out[5] = 2 * (y * z - w * x);
  out[6] = 2 * (x * z - w * y);
  out[7] = 2 * (y * z + w * x);
  out[8] = 1 - 2 * (x * x + y * y);
  return out;
}

/** matrix * v. */
export function turn(matrix, v) {
  return [
    matrix[0] * v[0] + matrix[1] * v[1] + matrix[2] * v[2],
    matrix[3] * v[0] + matrix[4] * v[1] + matrix[5] * v[2],
    matrix[6] * v[0] + matrix[7] * v[1] + matrix[8] * v[2],
  ];
}

/** matrix transposed * v: the turn back. */
export function turnBack(matrix, v) {
  return [
    matrix[0] * v[0] + matrix[3] * v[1] + matrix[6] * v[2],
    matrix[1] * v[0] + matrix[4] * v[1] + matrix[7] * v[2],
    matrix[2] * v[0] + matrix[5] * v[1] + matrix[8] * v[2],
  ];
}
