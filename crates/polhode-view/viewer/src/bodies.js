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
import { coarseGeometry, SMALL_PIXELS, worthCoarse } from './coarse.js';
import { LOOK } from './framing.js';
import { instancedLines, instancedMesh, writeMatrix } from './instances.js';
import { matrixOf, turn } from './rotation.js';
import { colour } from './theme.js';

/** The pose of what is fixed in the world. */
const WORLD = [0, 0, 0, 1, 0, 0, 0];
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

/** A part's place in its body: the 3x3 matrix of turn and scale, row by row, the origin, and the radius of the part. */
function partPlace(part, geometry) {
  const matrix = matrixOf(part.orientation, 0, new Float64Array(9));
  for (let k = 0; k < 9; k += 1) matrix[k] *= part.scale[k % 3];
  geometry.computeBoundingSphere();
  return { matrix, origin: part.position, radius: geometry.boundingSphere.radius * Math.max(...part.scale) };
}

/** The parts of one mesh: drawn fine, or coarse where they are small in the picture. */
class PartSet {
  constructor(members, geometry, look, opacity) {
    this.members = members;
    const material = bodyMaterial(geometry.faces, geometry.edges === null);
    const seen = look.ghost ? GHOST_OPACITY * opacity : opacity;
    if (seen < 1) Object.assign(material, { transparent: true, opacity: seen, depthWrite: false });
    /** Colour of each member, red, green, blue. */
    this.colours = new Float32Array(3 * members.length).fill(1);
    this.fine = this.makeMesh(geometry.faces, material, look);
    const coarse = worthCoarse(geometry.faces, members.length);
    this.coarse = coarse ? this.makeMesh(coarseGeometry(geometry.faces), material, look) : null;
    this.lines = null;
    if (!geometry.edges) return;
    const ink = new LineBasicMaterial({ transparent: true, opacity: Math.min(0.75, seen) });
    this.lines = instancedLines(geometry.edges, ink, members.length, this.fine.mesh.instanceMatrix);
  }

  /** A mesh with room for all members; `shown` lists those that it draws now. */
  makeMesh(geometry, material, look) {
    const mesh = instancedMesh(geometry, material, this.members.length);
    mesh.castShadow = look.shadows && !look.ghost && !material.transparent;
    mesh.receiveShadow = look.shadows;
    mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(this.colours.length), 3);
    mesh.instanceColor.setUsage(DynamicDrawUsage);
    return { mesh, shown: [] };
  }

  objects() {
    return [this.fine.mesh, this.coarse?.mesh, this.lines].filter(Boolean);
  }

  /** Places every member by the poses of the bodies; `eye` is { place, pixels } or null before there is a camera. */
  update(poses, eye) {
    const levels = [this.fine, this.coarse].filter(Boolean);
    for (const level of levels) level.shown.length = 0;
    const turned = new Float64Array(9);
    this.members.forEach(({ body, matrix, origin, radius }, member) => {
      const [pose, at] = body === null ? [WORLD, 0] : [poses, 7 * body];
      matrixOf(pose, at + 3, turned);
      const o = turn(turned, origin);
      for (let k = 0; k < 3; k += 1) o[k] += pose[at + k];
      const small = this.coarse && eye && (radius * eye.pixels) / distance(o, eye.place) < SMALL_PIXELS;
      const level = small ? this.coarse : this.fine;
      const instance = level.shown.push(member) - 1;
      const column = (k) => turn(turned, [matrix[k], matrix[3 + k], matrix[6 + k]]);
      writeMatrix(level.mesh.instanceMatrix.array, instance, column(0), column(1), column(2), o);
      for (let k = 0; k < 3; k += 1) level.mesh.instanceColor.array[3 * instance + k] = this.colours[3 * member + k];
    });
    for (const { mesh, shown } of levels) {
      mesh.count = shown.length;
      mesh.instanceMatrix.needsUpdate = true;
      mesh.instanceColor.needsUpdate = true;
    }
    if (this.lines) this.lines.count = this.fine.shown.length;
  }

  /** The nearest hit of a ray: { body, distance }, or null. */
  pick(raycaster) {
    let nearest = null;
    for (const { mesh, shown } of [this.fine, this.coarse].filter(Boolean)) {
      // The bounding sphere that three.js remembers is that of another frame.
      mesh.boundingSphere = null;
      for (const hit of raycaster.intersectObject(mesh, false)) {
        if (nearest && nearest.distance <= hit.distance) continue;
        nearest = { body: this.members[shown[hit.instanceId]].body, distance: hit.distance };
      }
    }
    return nearest;
  }
}

function distance(point, place) {
  return Math.hypot(point[0] - place.x, point[1] - place.y, point[2] - place.z);
}

export class Bodies {
  /** `look` is { ghost, shadows, edges }; `geometries` are those of `meshGeometry`. */
  constructor(run, geometries, look) {
    this.run = run;
    this.group = new Group();
    /** Members by mesh and by how much of them is seen. */
    const members = new Map();
    const add = (part, opacity, member) => {
      const key = `${part.mesh} ${opacity}`;
      if (!members.has(key)) members.set(key, { mesh: part.mesh, opacity, list: [] });
      members.get(key).list.push({ ...member, ...partPlace(part, geometries[part.mesh].faces) });
    };
    run.bodies.forEach((body, index) => {
      if ((look.ghost && !body.moves) || body.opacity === 0) return;
      for (const part of body.parts) add(part, body.opacity, { body: index, colour: null });
    });
    for (const { body, part } of look.ghost ? [] : run.fixtures) {
      if (body !== null && run.bodies[body].opacity === 0) continue;
      add(part, 1, { body, colour: look.fixture ?? LOOK.fixture });
    }
    this.sets = [...members.values()].map(({ mesh, opacity, list }) => new PartSet(list, geometries[mesh], look, opacity));
    for (const set of this.sets) this.group.add(...set.objects());
    this.showEdges(look.edges);
    this.applyTheme();
  }

  showEdges(on) {
    for (const { lines } of this.sets) if (lines) lines.visible = on;
  }

  applyTheme() {
    for (const { lines } of this.sets) lines?.material.color.setStyle(colour('edge'));
    this.paint((body) => this.plainColour(body));
  }

  /** The colour of a body when no overlay asks for another. */
  plainColour(body) {
    return this.run.bodies[body].colour ?? colour('fixed-body');
  }

  /** Paints every body in the colour that colourOf(body) gives; it is seen after the next update. */
  paint(colourOf) {
    const of_text = new Map();
    for (const { colours, members } of this.sets) {
      members.forEach(({ body, colour: own }, member) => {
        const text = own ?? colourOf(body);
        if (!of_text.has(text)) of_text.set(text, new Color(text));
        of_text.get(text).toArray(colours, 3 * member);
      });
    }
  }

  update(snapshot, eye) {
    for (const set of this.sets) set.update(snapshot.poses, eye);
  }

  /** The nearest body that a ray meets, or null: { body, distance }. */
  pick(raycaster) {
    const hits = this.sets.map((set) => set.pick(raycaster)).filter(Boolean);
    return hits.reduce((best, hit) => (best && best.distance <= hit.distance ? best : hit), null);
  }
}
