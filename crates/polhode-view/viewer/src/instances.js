// Instanced drawing: one geometry drawn at many places by one call.

import { DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, LineSegments } from 'three';

/** An instanced mesh whose matrices change from frame to frame. */
export function instancedMesh(geometry, material, count) {
  const mesh = new InstancedMesh(geometry, material, count);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  // The bounds of all instances change with every frame; testing them would cost more than drawing.
  mesh.frustumCulled = false;
  return mesh;
}

/**
 * Instanced lines. three.js has no class for them, but its renderer draws any object that says it is an instanced mesh
 * by its `instanceMatrix` and `count`. `matrices` can be those of an instanced mesh of the same bodies.
 */
export function instancedLines(geometry, material, count, matrices = null) {
  const lines = new LineSegments(geometry, material);
  lines.isInstancedMesh = true;
  lines.instanceMatrix = matrices ?? new InstancedBufferAttribute(new Float32Array(16 * count), 16);
  lines.instanceMatrix.setUsage(DynamicDrawUsage);
  lines.instanceColor = null;
  lines.morphTexture = null;
  lines.count = count;
  lines.frustumCulled = false;
  lines.raycast = () => {};
  return lines;
}

/** Writes the columns u, v, w and the origin o as a 4x4 matrix, column by column. */
export function writeMatrix(out, instance, u, v, w, o) {
  const at = 16 * instance;
  out[at] = u[0];
  out[at + 1] = u[1];
  out[at + 2] = u[2];
  out[at + 3] = 0;
  out[at + 4] = v[0];
  out[at + 5] = v[1];
  out[at + 6] = v[2];
  out[at + 7] = 0;
  out[at + 8] = w[0];
  out[at + 9] = w[1];
  out[at + 10] = w[2];
  out[at + 11] = 0;
  out[at + 12] = o[0];
  out[at + 13] = o[1];
  out[at + 14] = o[2];
  out[at + 15] = 1;
}
