// The playground: reads the page, compiles the engine, and starts; whatever fails is said in words in the page, beside the
// text of the scene, which stays.

import { decompress } from 'lzma1';
import { byId } from '../controls.js';
import { PageError, wordsOf } from '../errors.js';
import { blockText } from '../show.js';
import { packedBytes, packedText } from './packed.js';
import { Playground } from './playground.js';

/** The engine, compiled; whoever refuses says why in words. */
async function compiled() {
  if (typeof WebAssembly !== 'object') {
    throw new PageError(
      'This browser has no WebAssembly, so that the scene cannot run here. Turn it on (it is off in the lockdown mode of ' +
        'some systems), open the page in another browser, or run the scene by the program: polhode run SCENE.',
    );
  }
  const packed = packedBytes('polhode-engine', 'its engine');
  let bytes;
  try {
    bytes = decompress(packed);
  } catch {
    throw new PageError('The engine cannot be unpacked: the page is damaged or was cut off.');
  }
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
  const begins = given();
  begins.examples = JSON.parse(await packedText('polhode-examples', 'The scenes'));
  const playground = new Playground(begins, await packedText('polhode-worker', 'The worker'));
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
