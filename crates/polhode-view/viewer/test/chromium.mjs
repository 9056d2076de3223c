// Where the browser is that tests pages: what the variable CHROMIUM names, or the first of some programs on the path.
// `node test/chromium.mjs` prints its place; exit code 1 when there is none.

import { accessSync, constants, statSync } from 'node:fs';
import { delimiter, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

/** Programs that are Chromium or behave like it. */
const PROGRAMS = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome.exe'];

/** Whether a file can be run. */
function runs(path) {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

/** The place of the browser, or null. A browser that the variable names and that cannot be run is no browser. */
export function findChromium() {
  const { CHROMIUM, PATH } = process.env;
  if (CHROMIUM) return runs(CHROMIUM) ? resolve(CHROMIUM) : null;
  const folders = (PATH ?? '').split(delimiter).filter(Boolean);
  return PROGRAMS.flatMap((program) => folders.map((folder) => join(folder, program))).find(runs) ?? null;
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const place = findChromium();
  if (place === null) process.exitCode = 1;
  else console.log(place);
}
