// Bundles the viewer into dist/viewer.js, and puts the licence of three.js beside it.

import { copyFileSync, statSync } from 'node:fs';
import { build } from 'esbuild';

await build({
  entryPoints: ['src/main.js'],
  outfile: 'dist/viewer.js',
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  legalComments: 'inline',
  charset: 'utf8',
});
copyFileSync('node_modules/three/LICENSE', 'dist/LICENSES.txt');
console.log(`dist/viewer.js: ${statSync('dist/viewer.js').size} bytes`);
