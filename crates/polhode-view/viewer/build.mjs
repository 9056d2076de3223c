// Bundles the viewer into dist/viewer.js, and puts the licence of three.js beside it; `node build.mjs FOLDER` into another
// folder, to see whether dist/ is what the sources build to.

import { copyFileSync, mkdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';

const folder = process.argv[2] ?? 'dist';
const bundle = join(folder, 'viewer.js');
mkdirSync(folder, { recursive: true });
await build({
  entryPoints: ['src/main.js'],
  outfile: bundle,
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  legalComments: 'inline',
  charset: 'utf8',
});
copyFileSync('node_modules/three/LICENSE', join(folder, 'LICENSES.txt'));
console.log(`${bundle}: ${statSync(bundle).size} bytes`);
