// What test/encode.mjs writes is what src/decode.js reads, to the last integer, also where differences wrap.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { decodeChunk, gunzip, readRow } from '../src/decode.js';
import { turnBetween } from '../src/rotation.js';
import { chunkBytes, encodeChannels } from './encode.mjs';
import { pile } from './scenes.mjs';

const BODIES = 3;
const FRAMES = 7;

function wildIntegers() {
  const extremes = [0, 1, -1, 2147483647, -2147483648, 123456789, -40];
  return Int32Array.from({ length: 13 * BODIES * FRAMES }, (_, k) => extremes[(k * 5 + (k >> 3)) % extremes.length]);
}

test('integers come back, also where their differences wrap', () => {
  const values = wildIntegers();
  const bytes = encodeChannels(values, 13 * BODIES, FRAMES);
  assert.deepEqual(decodeChunk(bytes, { bodies: BODIES, frames: FRAMES, contacts: false }, 'it').values, values);
  const row = new Int32Array(FRAMES);
  readRow(bytes, { bodies: BODIES, frames: FRAMES }, 12, 2, row, 0);
  assert.deepEqual(row, values.slice(-FRAMES));
});

test('a chunk of the wrong length is an error in words', () => {
  const bytes = encodeChannels(wildIntegers(), 13 * BODIES, FRAMES);
  const shape = { bodies: BODIES, frames: FRAMES, contacts: false };
  assert.throws(() => decodeChunk(bytes.subarray(1), shape, 'It'), /It has 1091 bytes where 1092 are wanted/);
  assert.throws(() => decodeChunk(bytes, { ...shape, contacts: true }, 'It'), /does not fit the run/);
});

test('contacts, kinds and islands come back', () => {
  const run = pile();
  const first = 180;
  const bytes = new Uint8Array(chunkBytes(run, first, 48));
  const chunk = decodeChunk(bytes, { bodies: 16, frames: 48, contacts: true }, 'it');
  assert.equal(chunk.contact_start[1], run.contactsOf(first).length);
  assert.equal(chunk.contacts.indices[1], run.contactsOf(first)[0].b);
  assert.equal(chunk.kinds[0], 3);
  assert.equal(chunk.islands[0], run.island(first, 0));
});

test('a cut gzip is an error in words', async () => {
  const packed = gzipSync(new Uint8Array(5000).map((_, k) => k * 7));
  assert.equal((await gunzip(packed, 'It')).length, 5000);
  await assert.rejects(gunzip(packed.subarray(0, 100), 'It'), /It cannot be unpacked/);
});

test('without spin half of the shortest way is turned, also between opposite signs of one orientation', () => {
  const out = new Float64Array(4);
  const quarter = [Math.SQRT1_2, 0, 0, Math.SQRT1_2];
  for (const sign of [1, -1]) {
    const end = quarter.map((value) => sign * value);
    turnBetween(out, 0, [1, 0, 0, 0], end, [0, 0, 0], 1, 0.5);
    assert.ok(Math.abs(Math.abs(out[0]) - Math.cos(Math.PI / 8)) < 1e-12);
    assert.ok(Math.abs(Math.abs(out[3]) - Math.sin(Math.PI / 8)) < 1e-12);
  }
});

test('a body that turns by more than half a turn a frame turns forwards', () => {
  const out = new Float64Array(4);
  for (const spin of [250, -250, 1000]) {
    const span = 1 / 60;
    const at = (t) => [Math.cos(0.5 * spin * t), 0, 0, Math.sin(0.5 * spin * t)];
    for (const s of [0, 0.25, 0.5, 1]) {
      turnBetween(out, 0, at(0), at(span), [0, 0, spin], span, s);
      const cosine = at(s * span).reduce((sum, value, k) => sum + value * out[k], 0);
      assert.ok(Math.abs(Math.abs(cosine) - 1) < 1e-12, `${spin} ${s}`);
    }
  }
});
