// Rotation of a body in its principal frame: angular velocity, angular momentum L = I w, kinetic energy T = w·Iw / 2.
//
// `principal_axes` turns vectors of the body's frame into the principal frame, in which I is diagonal.

import { matrixOf, turn, turnBack } from './rotation.js';

const body_turn = new Float64Array(9);
const principal_turn = new Float64Array(9);

/** A world vector in the body's principal frame; the body's pose is the quaternion at `at`. */
export function inPrincipalFrame(body, poses, at, vector) {
  matrixOf(poses, at, body_turn);
  matrixOf(body.principal_axes, 0, principal_turn);
  return turn(principal_turn, turnBack(body_turn, vector));
}

/** A vector of the principal frame in the world. */
export function fromPrincipalFrame(body, poses, at, vector) {
  matrixOf(poses, at, body_turn);
  matrixOf(body.principal_axes, 0, principal_turn);
  return turn(body_turn, turnBack(principal_turn, vector));
}

/** The angular momentum in the world in kg m2/s, or null where the inertia is unknown. */
export function angularMomentum(body, poses, at, spin) {
  if (!body.principal_inertia) return null;
  const inside = inPrincipalFrame(body, poses, at, spin);
  return fromPrincipalFrame(
    body,
    poses,
    at,
    inside.map((w, k) => w * body.principal_inertia[k]),
  );
}

/** Kinetic energy of rotation in J of an angular velocity in the principal frame. */
export function spinEnergy(body, inside) {
  return inside.reduce((sum, w, k) => sum + (w * w * body.principal_inertia[k]) / 2, 0);
}
