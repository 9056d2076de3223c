// The parts of the playground that need no page: the scene in the address, frames and what lies between them, words.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { hashOf, sceneIn } from '../src/play/address.js';
import { percent, worded } from '../src/play/numbers.js';
import { Track } from '../src/play/track.js';
import { marginWords } from '../src/play/why.js';

const scene = readFileSync(new URL('../../../../fixtures/scenes/newtons-cradle.toml', import.meta.url), 'utf8');

test('an address is the scene, and holds no letter that programs change', async () => {
  const hash = await hashOf(scene);
  assert.match(hash, /^#scene=[A-Za-z0-9_-]+$/);
  assert.ok(hash.length < scene.length);
  assert.equal(await sceneIn(hash), scene);
  assert.equal(await sceneIn('#other'), null);
  assert.equal(await sceneIn(await hashOf('# ü ∑ 漢')), '# ü ∑ 漢');
});

test('an address that is cut anywhere is told, and no other scene', async () => {
  const hash = await hashOf(scene);
  for (const part of [0.1, 0.5, 0.9, 0.99]) {
    await assert.rejects(sceneIn(hash.slice(0, Math.floor(part * hash.length))), /cut off/);
  }
  await assert.rejects(sceneIn('#scene='), /cut off/);
  await assert.rejects(sceneIn(`${hash.slice(0, -9)}AAAAAAAAA`), /cut off/);
});

function track(frames) {
  const made = new Track({ bodies: [{}], duration_s: 2 });
  const poses = new Float64Array(frames.flatMap(([, ...pose]) => pose));
  made.add({ times: Float64Array.from(frames.map(([t]) => t)), poses, ended: false, now: frames.at(-1)[0], held: [] });
  return made;
}

test('between two frames places are straight, and a turn goes the shorter way', () => {
  const half = Math.SQRT1_2;
  const own = track([
    [0, 0, 0, 0, 1, 0, 0, 0],
    [1, 2, 0, 4, -half, 0, 0, -half],
  ]);
  const pose = new Float64Array(7);
  own.at(0.5, pose);
  assert.deepEqual([...pose.slice(0, 3)], [1, 0, 2]);
  assert.ok(Math.abs(2 * Math.acos(pose[3]) - Math.PI / 4) < 1e-12);
  own.at(9, pose);
  assert.equal(pose[0], 2);
});

test('a track that is cut goes on from there', () => {
  const own = track([
    [0, 0, 0, 0, 1, 0, 0, 0],
    [1, 1, 0, 0, 1, 0, 0, 0],
    [2, 2, 0, 0, 1, 0, 0, 0],
  ]);
  own.cut(0.5, Float64Array.of(7, 0, 0, 1, 0, 0, 0));
  assert.deepEqual(own.times, [0, 0.5]);
  assert.equal(own.distance(track([[0, 0, 0, 0, 1, 0, 0, 0]]), 0.5, [0]), 7);
});

test('numbers and margins in words', () => {
  assert.deepEqual([worded(0.5, 'N'), worded(1234567), worded(1e-5), percent(0.5), percent(1e-16)], [
    '0.5 N',
    '1.2e6',
    '1e−5',
    '50 %',
    '1e−16',
  ]);
  const first = [{ body: 'brick', how: 'slides' }];
  const push = { of_weight: 0.25, tilt_rad: Math.atan(0.25), begins: [{ body: 'brick', how: 'tips' }] };
  const told = marginWords({ bodies: 1, friction_needed: 0.4, begins: first, pushes: [push, { of_weight: 'any' }] });
  assert.equal(
    told,
    'All at rest stand until friction falls to 40 % of what it is; then brick slides. ' +
      'A push of 25 % of each weight, or a tilt of 14°, is the least that moves one: brick tips.',
  );
});
