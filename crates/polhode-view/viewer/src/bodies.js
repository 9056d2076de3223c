// The bodies of one run: all bodies that share a mesh are drawn by one instanced call.

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Group,
  InstancedBufferAttribute,
  LineBasicMaterial,
  MeshLambertMaterial,
  Vector3,
} from 'three';
import { BODY_COLOURS } from './colours.js';
import { instancedLines, instancedMesh, writeMatrix } from './instances.js';
import { matrixOf, turn } from './rotation.js';
import { colour } from './theme.js';

/** How much of a ghosted run is seen. */
const GHOST_OPACITY = 0.3;

/** The geometries of a mesh of the page: { faces, edges }, edges null where it has no sharp ones. */
export function meshGeometry(mesh) {
  const faces = new BufferGeometry();
  faces.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  faces.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  faces.setIndex(new BufferAttribute(mesh.indices, 1));
  if (mesh.edges.length === 0) return { faces, edges: null };
  const edges = new BufferGeometry();
  edges.setAttribute('position', faces.getAttribute('position'));
  edges.setIndex(new BufferAttribute(mesh.edges, 1));
  return { faces, edges };
}

/** Where the octants of a smooth body meet in its own frame: its middle. */
function middleOf(geometry) {
  return new Box3().setFromBufferAttribute(geometry.getAttribute('position')).getCenter(new Vector3());
}

/**
 * The material of bodies. A smooth body (a ball) would not show that it turns, so that its octants are drawn in two
 * tones, like those of a beach ball.
 */
function bodyMaterial(geometry, smooth) {
  const material = new MeshLambertMaterial({
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  if (!smooth) return material;
  const middle = middleOf(geometry);
  material.onBeforeCompile = (shader) => {
    shader.uniforms.middle = { value: middle };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nuniform vec3 middle;\nvarying vec3 inBody;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\ninBody = position - middle;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec3 inBody;')
      .replace(
        '#include <color_fragment>',
        `#include <color_fragment>
        vec3 side = clamp(inBody / max(fwidth(inBody), vec3(1e-30)), -1.0, 1.0);
        diffuseColor.rgb *= 0.89 + 0.11 * side.x * side.y * side.z;`,
      );
  };
  return material;
}

/** A part's place in its body: the 3x3 matrix of turn and scale, row by row, and the origin. */
function partPlace(part) {
  const matrix = matrixOf(part.orientation, 0, new Float64Array(9));
  for (let k = 0; k < 9; k += 1) matrix[k] *= part.scale[k % 3];
  return { matrix, origin: part.position };
}

export class Bodies {
  /** `look` is { ghost, shadows, edges }; `geometries` are those of `meshGeometry`. */
  constructor(run, geometries, look) {
    this.run = run;
    this.group = new Group();
    this.sets = [];
    this.edge_lines = [];
    const members = geometries.map(() => []);
    run.bodies.forEach((body, index) => {
      if (look.ghost && !body.moves) return;
      for (const part of body.parts) members[part.mesh].push({ body: index, ...partPlace(part) });
    });
    members.forEach((list, mesh) => {
      if (list.length > 0) this.addSet(list, geometries[mesh], look);
    });
    this.showEdges(look.edges);
    this.applyTheme();
  }

  addSet(members, geometry, look) {
    const material = bodyMaterial(geometry.faces, geometry.edges === null);
    if (look.ghost) Object.assign(material, { transparent: true, opacity: GHOST_OPACITY, depthWrite: false });
    const mesh = instancedMesh(geometry.faces, material, members.length);
    mesh.castShadow = look.shadows && !look.ghost;
    mesh.receiveShadow = look.shadows;
    mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * members.length).fill(1), 3);
    mesh.instanceColor.setUsage(DynamicDrawUsage);
    this.sets.push({ mesh, members, placed: false });
    this.group.add(mesh);
    if (!geometry.edges) return;
    const ink = new LineBasicMaterial({ transparent: true, opacity: look.ghost ? GHOST_OPACITY : 0.75 });
    const lines = instancedLines(geometry.edges, ink, members.length, mesh.instanceMatrix);
    this.edge_lines.push(lines);
    this.group.add(lines);
  }

  showEdges(on) {
    for (const lines of this.edge_lines) lines.visible = on;
  }

  applyTheme() {
    for (const lines of this.edge_lines) lines.material.color.setStyle(colour('edge'));
    this.paint((body) => this.plainColour(body));
  }

  /** The colour of a body when no overlay asks for another. */
  plainColour(body) {
    return this.run.bodies[body].moves ? BODY_COLOURS[body % BODY_COLOURS.length] : colour('fixed-body');
  }

  /** Paints every body in the colour that colourOf(body) gives. */
  paint(colourOf) {
    const of_text = new Map();
    for (const { mesh, members } of this.sets) {
      members.forEach(({ body }, instance) => {
        const text = colourOf(body);
        if (!of_text.has(text)) of_text.set(text, new Color(text));
        of_text.get(text).toArray(mesh.instanceColor.array, 3 * instance);
      });
      mesh.instanceColor.needsUpdate = true;
    }
  }

  /** Moves every instance to the pose of its body. */
  update(snapshot) {
    const { poses } = snapshot;
    const turned = new Float64Array(9);
    for (const set of this.sets) {
      const out = set.mesh.instanceMatrix.array;
      set.members.forEach(({ body, matrix, origin }, instance) => {
        if (set.placed && !this.run.bodies[body].moves) return;
        matrixOf(poses, 7 * body + 3, turned);
        const o = turn(turned, origin);
        for (let k = 0; k < 3; k += 1) o[k] += poses[7 * body + k];
        const column = (k) => turn(turned, [matrix[k], matrix[3 + k], matrix[6 + k]]);
        writeMatrix(out, instance, column(0), column(1), column(2), o);
      });
      set.placed = true;
      set.mesh.instanceMatrix.needsUpdate = true;
    }
  }

  /** The nearest body that a ray meets, or null: { body, distance }. */
  pick(raycaster) {
    let nearest = null;
    for (const { mesh, members } of this.sets) {
      // The bounding sphere that three.js remembers is that of another frame.
      mesh.boundingSphere = null;
      for (const hit of raycaster.intersectObject(mesh, false)) {
        if (!nearest || hit.distance < nearest.distance) {
          nearest = { body: members[hit.instanceId].body, distance: hit.distance };
        }
      }
    }
    return nearest;
  }
}
