// Rotations by unit quaternions [w, x, y, z], body to world, in plain arrays.

/** Below this angle in rad the sine of slerp loses digits, and straight interpolation agrees with it to 1e-7. */
const SMALL_ANGLE = 1e-3;

/** Spherical interpolation (Shoemake 1985): a sin((1-s) angle)/sin(angle) + b sin(s angle)/sin(angle), made unit. */
export function slerp(out, at, a, a_at, b, b_at, s) {
  let cosine = 0;
  for (let k = 0; k < 4; k += 1) cosine += a[a_at + k] * b[b_at + k];
  const sign = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  let wa = 1 - s;
  let wb = s;
  if (angle > SMALL_ANGLE) {
    wa = Math.sin((1 - s) * angle) / Math.sin(angle);
    wb = Math.sin(s * angle) / Math.sin(angle);
  }
  for (let k = 0; k < 4; k += 1) out[at + k] = wa * a[a_at + k] + sign * wb * b[b_at + k];
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
