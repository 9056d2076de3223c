// Runs scenes by the committed engine, without a page: `node test/play_engine.mjs SCENE...` prints the strict hash of each,
// one a line, or what was thrown.

import { readFileSync } from 'node:fs';
import { decompress } from 'lzma1';

const dist = new URL('../dist/', import.meta.url);
const made = new Function(`${readFileSync(new URL('engine.js', dist), 'utf8')}\nreturn wasm_bindgen;`)();
made.initSync({ module: decompress(new Uint8Array(readFileSync(new URL('engine.wasm.lzma', dist)))) });

for (const scene of process.argv.slice(2)) {
  try {
    const own = new made.Playground();
    own.load(readFileSync(scene, 'utf8'), '');
    while (!own.ended()) own.step();
    console.log(own.hash().split(' ')[0]);
    own.free();
  } catch (error) {
    console.log(String(error?.stack ?? error).replaceAll('\n', ' '));
  }
}
