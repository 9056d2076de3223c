// Files that are dropped on the page or opened from it: a scene takes the place of the text, a mesh is there for scenes to
// name.

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

async function take(playground, file) {
  const ending = (file.name.match(/\.([^.]*)$/)?.[1] ?? '').toLowerCase();
  if (file.size > MOST_BYTES) {
    playground.notice(
      `${file.name} has ${worded(file.size / 1e6, 'MB')}, and the page takes files of up to ${MOST_BYTES / 1024 / 1024} MB. ` +
        'Run it by the program: polhode run FILE, polhode view FILE. Your text is as it was.',
    );
    return;
  }
  if (['urdf', 'xml', 'mjcf', 'csv'].includes(ending)) {
    playground.notice(
      `${file.name}: the page has no reader of robots and tables. The program has: polhode view ${file.name} -o robot.html ` +
        'shows it in a page. Your text is as it was.',
    );
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (['stl', 'obj', 'off', 'ply'].includes(ending)) {
    await playground.addFile(file.name, bytes);
    if (playground.editor.text.includes(`"${file.name}"`)) await playground.run();
    else await playground.take(sceneOfMesh(file.name));
    return;
  }
  let text;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    playground.notice(`${file.name} is no scene: it is not text. Drop a scene (.toml) or a mesh (.stl, .obj, .off, .ply).`);
    return;
  }
  if (ending !== 'toml' && !/^\s*format\s*=/m.test(text)) {
    playground.notice(`${file.name} is no scene: no line \`format = 1\` is in it. Drop a scene (.toml) or a mesh (.stl, .obj, .off, .ply).`);
    return;
  }
  await playground.take(text);
}

async function takeAll(playground, list) {
  // Meshes first, because a scene that comes with them names them.
  const files = [...list].sort((one, other) => Number(/\.toml$/i.test(one.name)) - Number(/\.toml$/i.test(other.name)));
  for (const file of files) {
    try {
      await take(playground, file);
    } catch (error) {
      playground.notice(`${file.name} could not be read: ${error?.message ?? error}. Your text is kept.`);
    }
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
