// The playground: reads the page, compiles the engine, and starts; whatever fails is said in words in the page, beside the
// text of the scene, which stays.

import { bytesOfBase64 } from '../bytes.js';
import { byId } from '../controls.js';
import { gunzip } from '../decode.js';
import { PageError, wordsOf } from '../errors.js';
import { blockText } from '../show.js';
import { Playground } from './playground.js';

/** The engine, compiled; whoever refuses says why in words. */
async function compiled() {
  if (typeof WebAssembly !== 'object') {
    throw new PageError(
      'This browser has no WebAssembly, so that the scene cannot run here. Turn it on (it is off in the lockdown mode of ' +
        'some systems), open the page in another browser, or run the scene by the program: polhode run SCENE.',
    );
  }
  const text = blockText('polhode-engine');
  if (text === null) throw new PageError('The page holds no engine: it was cut off before its end. Get it again, or write it by `polhode play`.');
  const bytes = await gunzip(bytesOfBase64(text, 'The engine'), 'The engine');
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw new PageError(
      `This browser refuses the engine (${error?.message ?? error}). A policy of the page or of the system forbids ` +
        'WebAssembly: open the file itself, use another browser, or run the scene by the program: polhode run SCENE.',
    );
  }
}

function given() {
  try {
    return JSON.parse(blockText('polhode-play') ?? 'null') ?? {};
  } catch {
    return {};
  }
}

async function main() {
  const playground = new Playground(given(), blockText('polhode-worker') ?? '');
  window.polhode = playground.published();
  try {
    await playground.start(compiled);
    document.body.classList.add('ready');
  } catch (error) {
    byId('message').textContent = wordsOf(error);
    byId('message').hidden = false;
    document.body.classList.add('failed');
    window.polhode.failed = wordsOf(error);
  }
}

main();
