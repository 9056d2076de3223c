// Coarse meshes for bodies that are small in the picture, so that thousands of balls stay quick to draw.
//
// Vertices in one cell of a grid over the mesh become one, in their mean (vertex clustering,
// Rossignac and Borrel 1993).
// No vertex moves farther than the diagonal of a cell, and a cell of a body of SMALL_PIXELS has four pixels.

import { BufferAttribute, BufferGeometry } from 'three';

/** Cells of the grid along the longest side of a mesh. */
const CELLS = 6;
/** A body whose radius is smaller than this many pixels is drawn coarse. */
export const SMALL_PIXELS = 12;
/** A mesh with fewer triangles than this has no coarse one, and neither has a scene with fewer altogether. */
const MESH_TRIANGLES = 150;
const SCENE_TRIANGLES = 60000;

/** Whether a mesh drawn `count` times is worth a coarse one. */
export function worthCoarse(geometry, count) {
  const triangles = geometry.index.count / 3;
  return triangles > MESH_TRIANGLES && triangles * count > SCENE_TRIANGLES;
}

/** The cell of each vertex, numbered from 0 in the order met. */
function cellsOf(geometry) {
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox;
  const cell = Math.max(max.x - min.x, max.y - min.y, max.z - min.z) / CELLS;
  const position = geometry.getAttribute('position');
  const numbers = new Map();
  return Uint32Array.from({ length: position.count }, (_, vertex) => {
    const at = [position.getX(vertex) - min.x, position.getY(vertex) - min.y, position.getZ(vertex) - min.z];
    const key = at.map((value) => Math.min(CELLS - 1, Math.floor(value / cell))).join(' ');
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key);
  });
}

/** The mean of an attribute over the vertices of each cell. */
function meanByCell(attribute, cells, count) {
  const sums = new Float32Array(3 * count);
  const members = new Float32Array(count);
  cells.forEach((cell, vertex) => {
    for (let k = 0; k < 3; k += 1) sums[3 * cell + k] += attribute.array[3 * vertex + k];
    members[cell] += 1;
  });
  return sums.map((sum, at) => sum / members[Math.floor(at / 3)]);
}

/** The coarse mesh of a mesh. */
export function coarseGeometry(geometry) {
  const cells = cellsOf(geometry);
  const count = cells.reduce((largest, cell) => Math.max(largest, cell + 1), 0);
  const indices = [];
  for (let at = 0; at < geometry.index.count; at += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => cells[geometry.index.array[at + k]]);
    if (a !== b && b !== c && c !== a) indices.push(a, b, c);
  }
  const coarse = new BufferGeometry();
  const attribute = (name) => new BufferAttribute(meanByCell(geometry.getAttribute(name), cells, count), 3);
  coarse.setAttribute('position', attribute('position'));
  coarse.setAttribute('normal', attribute('normal'));
  coarse.setIndex(indices);
  return coarse;
}
