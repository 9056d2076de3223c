// What the page shows: the data block `polhode-show`, checked and turned into runs, meshes, series and events.

import { numbersOfBase64 } from './bytes.js';
import { BODY_COLOURS } from './colours.js';
import { PageError } from './errors.js';
import { LOOK } from './framing.js';

/** The version of the data block that this viewer reads. */
const VERSION = 1;

/** Text of a data block of the page, or null where the page has none. */
export function blockText(id) {
  const element = document.getElementById(id);
  return element === null ? null : element.textContent;
}

/** Parses a JSON block; `what` names it in the error text. */
function parseBlock(id, what) {
  const text = blockText(id);
  if (text === null) throw new PageError(`The page holds no ${what}: it was cut off before its end.`);
  try {
    return JSON.parse(text);
  } catch {
    throw new PageError(`The ${what} of the page cannot be read: it is damaged or was cut off.`);
  }
}

/** Reads what is shown. `notices` collects the words about data that are left out. */
export function readShow(notices) {
  const show = parseBlock('polhode-show', 'description of what is shown');
  if (show?.version !== VERSION) {
    throw new PageError(
      `The page is of version ${show?.version ?? 'unknown'}, and this viewer reads version ${VERSION}. ` +
        'Write the page again with one and the same polhode.',
    );
  }
  if (!Array.isArray(show.runs) || show.runs.length === 0) throw new PageError('The page holds no run.');
  const meshes = (show.meshes ?? []).map(readMesh);
  const runs = show.runs.slice(0, 2).map((run, index) => readRun(run, index, meshes.length, notices));
  if (show.runs.length > 2) notices.push(`The page holds ${show.runs.length} runs; the first two are shown.`);
  return {
    title: show.title || 'polhode',
    description: show.description || '',
    gravity: show.gravity ?? null,
    look: { ...LOOK, ...show.look },
    plays_at_once: Boolean(show.plays_at_once),
    meshes,
    runs,
  };
}

/** Reads a scene that is not in the page from its start, and has no frames. */
export function readScene(show) {
  const meshes = show.meshes.map(readMesh);
  const run = readRun(show.runs[0], 0, meshes.length, []);
  const { title, description, gravity } = show;
  return { title, description, gravity, look: { ...LOOK, ...show.look }, meshes, runs: [run] };
}

/** The text of the JSON report, or null where the page has none. */
export function reportText() {
  const text = blockText('polhode-report')?.trim();
  return !text || text === 'null' ? null : text;
}

/** The reports in this text: one of each run, or none where one cannot be read. */
export function reports(text) {
  try {
    return [JSON.parse(text ?? '[]')].flat().filter((report) => report !== null && typeof report === 'object');
  } catch {
    return [];
  }
}

function readMesh(mesh, index) {
  const what = `Mesh ${index}`;
  const positions = numbersOfBase64(mesh.positions, Float32Array, `${what}: its vertices`);
  const normals = numbersOfBase64(mesh.normals, Float32Array, `${what}: its normals`);
  const indices = numbersOfBase64(mesh.indices, Uint32Array, `${what}: its triangles`);
  const edges = numbersOfBase64(mesh.edges ?? '', Uint32Array, `${what}: its edges`);
  const vertices = positions.length / 3;
  const outside = (vertex) => vertex >= vertices;
  if (indices.some(outside) || edges.some(outside)) throw new PageError(`${what} names a vertex that it lacks.`);
  return { positions, normals, indices, edges };
}

function readRun(run, index, mesh_count, notices) {
  const name = run.name || `run ${index + 1}`;
  const what = `The run “${name}”`;
  const bodies = (run.bodies ?? []).map((body, at) => readBody(body, at, mesh_count, what));
  const frames = run.frames ?? {};
  const times = numbersOfBase64(frames.times ?? '', Float64Array, `${what}: its times`);
  if (times.length !== (frames.count ?? 0)) {
    throw new PageError(`${what} tells of ${frames.count} frames and gives ${times.length} times.`);
  }
  if (times.some((time, at) => !Number.isFinite(time) || (at > 0 && time < times[at - 1]))) {
    throw new PageError(`${what} has frame times that are no numbers or run backwards.`);
  }
  if ((run.initial ?? []).length !== bodies.length) {
    throw new PageError(`${what} has ${bodies.length} bodies and ${(run.initial ?? []).length} initial poses.`);
  }
  const moving = frames.moving ?? [];
  if (moving.some((body) => !(body >= 0 && body < bodies.length))) {
    throw new PageError(`${what} has frames of a body that it does not know.`);
  }
  if (times.length === 0) notices.push(`${what} has no frames: nothing was computed. The start is shown.`);
  return {
    index,
    name,
    outcome: run.outcome ?? 'completed',
    duration: Number.isFinite(run.duration_s) ? run.duration_s : (times.at(-1) ?? 0),
    bodies,
    joints: Array.isArray(run.joints) ? run.joints.length : (run.joints ?? 0),
    fixtures: (run.fixtures ?? []).map((fixture) => readFixture(fixture, bodies.length, mesh_count, what)),
    links: (run.links ?? []).map((link, at) => readLink(link, at, bodies.length, what)),
    frame: run.frame ?? null,
    initial: Float64Array.from(run.initial.flat()),
    times,
    moving,
    contacts: Boolean(frames.contacts),
    quanta: [frames.position_quantum_m, 1 / 32767, frames.velocity_quantum_m_s, frames.spin_quantum_rad_s],
    chunks: checkChunks(frames.chunks ?? [], times.length, what),
    errors: readErrors(run.errors, moving.length, what, notices),
    series: readSeries(run.series ?? [], times.length, what, notices),
    events: readEvents(run.events ?? []),
  };
}

function readBody(body, index, mesh_count, what) {
  const parts = body.parts ?? [];
  const unknown = parts.find((part) => !(part.mesh >= 0 && part.mesh < mesh_count));
  if (unknown) throw new PageError(`${what}: body ${index} has a part of mesh ${unknown.mesh}, which is missing.`);
  return {
    name: body.name || `body ${index}`,
    moves: Boolean(body.moves),
    colour: body.colour ?? (body.moves ? BODY_COLOURS[index % BODY_COLOURS.length] : null),
    label: body.label ?? '',
    opacity: body.opacity ?? 1,
    mass_kg: body.mass_kg ?? null,
    center_of_mass: body.center_of_mass ?? [0, 0, 0],
    principal_inertia: body.principal_inertia_kg_m2 ?? null,
    principal_axes: body.principal_axes ?? [1, 0, 0, 0],
    parts,
    half_spaces: body.half_spaces ?? [],
    box: body.box ?? null,
  };
}

/** What is drawn of a joint as a part of a body, or of the world: its body and the part. */
function readFixture({ body, part }, body_count, mesh_count, what) {
  const known = body === null || (body >= 0 && body < body_count);
  if (!known || !(part?.mesh >= 0 && part.mesh < mesh_count)) {
    throw new PageError(`${what}: something of a joint is of a body or a mesh that is missing.`);
  }
  return { body, part };
}

/** A rod, a rope or a spring: its kind and its ends, of a body (or null, of the world) and a point in its frame. */
function readLink(link, index, body_count, what) {
  const ends = (link.ends ?? []).map(({ body, point }) => ({ body: body ?? null, point }));
  if (ends.length !== 2 || ends.some(({ body }) => body !== null && !(body >= 0 && body < body_count))) {
    throw new PageError(`${what}: link ${index} does not have two ends of bodies that it knows.`);
  }
  return { kind: link.kind, ends, radius_m: link.radius_m, length_m: link.length_m };
}

/** Chunks must follow one another and cover all frames. */
function checkChunks(chunks, frame_count, what) {
  let next = 0;
  for (const chunk of chunks) {
    if (chunk.first !== next || !(chunk.count > 0)) {
      throw new PageError(`${what}: its frames do not follow one another (frame ${next} is missing).`);
    }
    next += chunk.count;
  }
  if (next !== frame_count) throw new PageError(`${what} tells of ${frame_count} frames and holds ${next}.`);
  return chunks;
}

/** Series of a wrong length or without any number are left out, and a notice says so. */
function readSeries(list, frame_count, what, notices) {
  const kept = [];
  for (const series of list) {
    const label = `${what}: the series “${series.group} ${series.name}”`;
    const values = numbersOfBase64(series.values, Float64Array, label);
    if (values.length !== frame_count) {
      notices.push(`${label} has ${values.length} values for ${frame_count} frames and is left out.`);
    } else if (frame_count > 0 && !values.some(Number.isFinite)) {
      notices.push(`${label} has no numbers and is left out.`);
    } else {
      kept.push({ group: series.group, name: series.name, unit: series.unit ?? '', values });
    }
  }
  return kept;
}

/** The estimated errors of the moving bodies, from change to change: position (m), attitude (rad); null without any. */
function readErrors(errors, moving_count, what, notices) {
  if (!errors) return null;
  const times = numbersOfBase64(errors.times, Float64Array, `${what}: the times of its errors`);
  const values = numbersOfBase64(errors.values, Float32Array, `${what}: its errors`);
  if (values.length === 2 * moving_count * times.length) return { times, values };
  notices.push(`${what} has ${values.length} errors at ${times.length} times: they are left out.`);
  return null;
}

function readEvents(list) {
  return list
    .filter((event) => Number.isFinite(event.t))
    .map((event) => ({ t: event.t, kind: event.kind ?? 'event', bodies: event.bodies ?? [], text: event.text ?? '' }))
    .sort((one, other) => one.t - other.t);
}
