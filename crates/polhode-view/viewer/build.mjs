// Bundles viewer and playground into dist/, and puts the licences of three.js and lzma1 beside them; `node build.mjs FOLDER` into another
// folder, to see whether dist/ is what the sources build to.

import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const folder = process.argv[2] ?? 'dist';
mkdirSync(folder, { recursive: true });

/** The scripts of the pages: the viewer, the playground, its worker, and what unpacks it. */
const SCRIPTS = [
  ['src/main.js', 'viewer.js'],
  ['src/play/main.js', 'play.js'],
  ['src/play/worker.js', 'worker.js'],
  ['src/play/loader.js', 'loader.js'],
];
for (const [source, name] of SCRIPTS) {
  const bundle = join(folder, name);
  await build({
    entryPoints: [source],
    outfile: bundle,
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    legalComments: 'inline',
    charset: 'utf8',
  });
  console.log(`${bundle}: ${statSync(bundle).size} bytes`);
}
const texts = ['three', 'lzma1'].map((name) => readFileSync(`node_modules/${name}/LICENSE`, 'utf8').trim());
writeFileSync(join(folder, 'LICENSES.txt'), `${texts.join('\n\n')}\n`);
