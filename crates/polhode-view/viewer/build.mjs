// Bundles viewer and playground into dist/, and puts the licence of three.js beside them; `node build.mjs FOLDER` into another
// folder, to see whether dist/ is what the sources build to.

import { copyFileSync, mkdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const folder = process.argv[2] ?? 'dist';
mkdirSync(folder, { recursive: true });

/** The scripts of the pages: the viewer, the playground, and the playground's worker. */
const SCRIPTS = [
  ['src/main.js', 'viewer.js'],
  ['src/play/main.js', 'play.js'],
  ['src/play/worker.js', 'worker.js'],
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
copyFileSync('node_modules/three/LICENSE', join(folder, 'LICENSES.txt'));
