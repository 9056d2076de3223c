// Files that are dropped on the page or opened from it: a scene takes the place of the text, as does what a robot file or a
// table stands for; a mesh is there for scenes and robots to name.

import { byId } from '../controls.js';
import { worded } from './numbers.js';

/** Larger files are no scene and no mesh that a page can hold, bytes. */
const MOST_BYTES = 16 * 1024 * 1024;

/** A scene of one mesh that falls on a floor. */
function sceneOfMesh(name) {
  return `format = 1
name = "${name.replace(/\.[^.]*$/, '').replaceAll('"', '')}"
duration = 3.0

[materials.solid]
friction = 0.5
restitution = 0.2

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
position = [0, 0, -1]
material = "solid"

[[bodies]]
name = "body"
shape.convex.file = "${name.replaceAll('"', '')}"
density = 1000.0
position = [0, 0, 0]
material = "solid"
`;
}

/** Files that a scene names. */
const MESHES = ['stl', 'obj', 'off', 'ply'];
/** Files that stand for a scene. */
const ROBOTS = ['urdf', 'xml', 'mjcf', 'xacro'];
const TABLES = ['csv'];
const ACCEPTED = 'a scene (.toml), a robot (.urdf, .xml, .mjcf) with its meshes, a table of boxes (.csv), or a mesh (.stl, .obj, .off, .ply)';

const endingOf = (name) => (name.match(/\.([^.]*)$/)?.[1] ?? '').toLowerCase();
const isNamed = (text, name) => text.includes(`"${name}"`) || text.includes(`/${name}"`);

/** A robot that was refused, as { name, text }: a file that it misses may come later. */
let waiting = null;

/** What can be used of the files, sorted: { texts, named, stands }; what cannot be is told. */
async function read(playground, list) {
  const found = { texts: [], named: [], stands: [] };
  for (const file of list) {
    const ending = endingOf(file.name);
    if (file.size > MOST_BYTES) {
      playground.notice(
        `${file.name} has ${worded(file.size / 1e6, 'MB')}, and the page takes files of up to ${MOST_BYTES / 1024 / 1024} MB. ` +
          'Run it by the program: polhode run FILE, polhode view FILE. Your text is as it was.',
      );
      continue;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { name } = file;
    if (MESHES.includes(ending)) {
      found.named.push({ name, bytes });
      continue;
    }
    let text;
    try {
      text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    } catch {
      playground.notice(`${name} is no scene: it is not text. Drop ${ACCEPTED}.`);
      continue;
    }
    if (ROBOTS.includes(ending) || TABLES.includes(ending)) found.stands.push({ name, bytes, text });
    else if (ending === 'toml' || /^\s*format\s*=/m.test(text)) found.texts.push(text);
    else playground.notice(`${name} is no scene: no line \`format = 1\` is in it. Drop ${ACCEPTED}.`);
  }
  return found;
}

/** Takes the scene that a robot file or a table stands for. */
async function takeStanding(playground, file) {
  const { name } = file;
  try {
    const text = await playground.sceneOf(name);
    waiting = null;
    await playground.take(text);
  } catch (error) {
    waiting = ROBOTS.includes(endingOf(name)) ? file : null;
    const cure = waiting ? ' Where it misses a file, drop that too.' : '';
    playground.notice(`${name} could not be read: ${error?.message ?? error}${cure} Your text is kept.`);
  }
}

async function takeAll(playground, list) {
  try {
    const { texts, named, stands } = await read(playground, list);
    const twice = [...named, ...stands].find(({ name }, at, all) => all.findIndex((one) => one.name === name) < at);
    if (twice) {
      playground.notice(`Two files are called ${twice.name}, and the page knows no folders: give one another name, or use polhode play SCENE.`);
      return;
    }
    for (const { name, bytes } of [...named, ...stands]) await playground.addFile(name, bytes);
    const own = playground.editor.text;
    // Of robot files that include each other, the one that none names is the robot.
    const robot = stands.find(({ name }) => !stands.some((other) => other.name !== name && isNamed(other.text, name)));
    const names = [...named, ...stands].map(({ name }) => name);
    if (texts.length > 0) await playground.take(texts.at(-1));
    else if (names.some((name) => isNamed(own, name))) await playground.run();
    else if (robot) await takeStanding(playground, robot);
    else if (waiting && names.some((name) => isNamed(waiting.text, name))) await takeStanding(playground, waiting);
    else if (named.length > 0) await playground.take(sceneOfMesh(named.at(-1).name));
  } catch (error) {
    playground.notice(`The files could not be read: ${error?.message ?? error}. Your text is kept.`);
  }
}

export function listenForFiles(playground) {
  const app = byId('app');
  const input = byId('file');
  byId('open').addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    takeAll(playground, [...input.files]);
    input.value = '';
  });
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    app.classList.add('dropping');
  });
  document.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) app.classList.remove('dropping');
  });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    app.classList.remove('dropping');
    if (event.dataTransfer.files.length > 0) takeAll(playground, event.dataTransfer.files);
  });
}

/** Saves a text as a file. */
export function saveText(text, name) {
  const url = URL.createObjectURL(new Blob([text], { type: 'application/toml' }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  URL.revokeObjectURL(url);
}
