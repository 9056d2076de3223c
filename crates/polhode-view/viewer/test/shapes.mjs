// Meshes for the synthetic pages: a box with sharp edges, a smooth ball.

import { base64 } from './encode.mjs';

const pack = (positions, normals, indices, edges) => ({
  positions: base64(Float32Array.from(positions.flat())),
  normals: base64(Float32Array.from(normals.flat())),
  indices: base64(Uint32Array.from(indices.flat())),
  edges: base64(Uint32Array.from(edges.flat())),
});

/** A cube with sides of one metre. */
export function cube() {
  const positions = [];
  const normals = [];
  const indices = [];
  const edges = [];
  for (let axis = 0; axis < 3; axis += 1) {
    for (const side of [-1, 1]) {
      const first = positions.length;
      const normal = [0, 0, 0];
      normal[axis] = side;
      for (const [p, q] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]) {
        const corner = [0, 0, 0];
        corner[axis] = side / 2;
        corner[(axis + 1) % 3] = p / 2;
        corner[(axis + 2) % 3] = q / 2;
        positions.push(corner);
        normals.push(normal);
      }
      const order = side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
      indices.push(order.map((k) => first + k));
      for (let k = 0; k < 4; k += 1) edges.push([first + k, first + ((k + 1) % 4)]);
    }
  }
  return pack(positions, normals, indices, edges);
}

/** A ball of radius one. */
export function ball() {
  const rings = 16;
  const columns = 32;
  const positions = [];
  const indices = [];
  for (let ring = 0; ring <= rings; ring += 1) {
    for (let column = 0; column <= columns; column += 1) {
      const [a, b] = [(ring / rings) * Math.PI, (column / columns) * 2 * Math.PI];
      positions.push([Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)]);
      if (ring === rings || column === columns) continue;
      const at = ring * (columns + 1) + column;
      indices.push([at, at + columns + 1, at + 1, at + 1, at + columns + 1, at + columns + 2]);
    }
  }
  return pack(positions, positions, indices, []);
}
