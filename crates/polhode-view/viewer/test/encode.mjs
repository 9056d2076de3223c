// Writes chunks and pages after the contract that src/decode.js and src/show.js read.

import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

const here = new URL('..', import.meta.url);
export const QUANTA = { position_quantum_m: 1e-7, velocity_quantum_m_s: 1e-6, spin_quantum_rad_s: 1e-6 };

/** Base64 of a typed array. */
export const base64 = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString('base64');

/** Planes of bytes of the folded second differences of integers x(channel, body, frame). */
export function encodeChannels(values, rows, frames) {
  const total = rows * frames;
  const bytes = new Uint8Array(4 * total);
  for (let row = 0; row < rows; row += 1) {
    for (let k = 0; k < frames; k += 1) {
      const x = (at) => values[row * frames + at];
      let d = x(k);
      if (k === 1) d = (x(1) - x(0)) | 0;
      if (k > 1) d = (x(k) - 2 * x(k - 1) + x(k - 2)) | 0;
      const folded = ((d << 1) ^ (d >> 31)) >>> 0;
      for (let plane = 0; plane < 4; plane += 1) bytes[plane * total + row * frames + k] = folded >>> (8 * plane);
    }
  }
  return bytes;
}

/** The states of a chunk as integers; state(frame, body) gives 13 numbers. */
function integersOf(state, first, frames, bodies) {
  const { position_quantum_m: metre, velocity_quantum_m_s: speed, spin_quantum_rad_s: spin } = QUANTA;
  const unit = [metre, metre, metre, ...Array(4).fill(1 / 32767), speed, speed, speed, spin, spin, spin];
  const values = new Int32Array(13 * bodies * frames);
  for (let body = 0; body < bodies; body += 1) {
    for (let frame = 0; frame < frames; frame += 1) {
      state(first + frame, body).forEach((value, channel) => {
        values[(channel * bodies + body) * frames + frame] = Math.round(value / unit[channel]);
      });
    }
  }
  return values;
}

/** Kinds, islands and contacts of a chunk. */
function contactBytes(run, first, frames, bodies) {
  const kinds = new Uint8Array(bodies * frames);
  const islands = new Uint16Array(bodies * frames);
  const counts = new Uint32Array(frames);
  const records = [];
  for (let frame = 0; frame < frames; frame += 1) {
    for (let body = 0; body < bodies; body += 1) {
      kinds[body * frames + frame] = run.kind(first + frame, body);
      islands[body * frames + frame] = run.island(first + frame, body);
    }
    const list = run.contactsOf(first + frame);
    counts[frame] = list.length;
    for (const { a, b, point, normal, separation, force } of list) {
      records.push(
        base64Bytes(new Uint32Array([a, b])),
        base64Bytes(new Float32Array([...point, ...normal, separation, force])),
      );
    }
  }
  const contacts = inPlanes(Buffer.concat(records));
  return Buffer.concat([kinds, base64Bytes(islands), base64Bytes(counts), contacts]);
}

/** Records of ten words as columns in planes of bytes. */
function inPlanes(records) {
  const count = records.length / 40;
  const planes = Buffer.alloc(records.length);
  for (let i = 0; i < records.length; i += 1) {
    const [contact, column, plane] = [Math.floor(i / 40), Math.floor((i % 40) / 4), i % 4];
    planes[(plane * 10 + column) * count + contact] = records[i];
  }
  return planes;
}

const base64Bytes = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);

/** The chunk of frames from `first` on, not yet packed. */
export function chunkBytes(run, first, frames) {
  const bodies = run.moving.length;
  const channels = encodeChannels(integersOf(run.state, first, frames, bodies), 13 * bodies, frames);
  return run.contactsOf ? Buffer.concat([channels, contactBytes(run, first, frames, bodies)]) : Buffer.from(channels);
}

const jsonText = (value) => JSON.stringify(value).replaceAll('<', '\\u003c');

/** A page of runs; `damage` may change the show, the chunks and the text. */
export function pageText(title, description, meshes, runs, damage = {}) {
  const css = readFileSync(new URL('viewer.css', here), 'utf8');
  const body = readFileSync(new URL('page.html', here), 'utf8');
  const bundle = readFileSync(new URL('dist/viewer.js', here), 'utf8');
  const blocks = [];
  const described = runs.map((run, r) => {
    const chunks = [];
    for (let first = 0; first < run.times.length; first += run.chunk) {
      const count = Math.min(run.chunk, run.times.length - first);
      const packed = gzipSync(chunkBytes(run, first, count), { level: 6 });
      const id = `polhode-frames-${r}-${chunks.length}`;
      const bytes = damage.chunk?.(r, chunks.length, packed) ?? packed;
      blocks.push(`<script id="${id}" type="application/octet-stream">${bytes.toString('base64')}</script>`);
      chunks.push({ first, count });
    }
    const { name, outcome, duration_s, bodies, initial, moving, series, events } = run;
    const frames = { count: run.times.length, times: base64(Float64Array.from(run.times)), ...QUANTA, moving, chunks };
    frames.contacts = Boolean(run.contactsOf);
    const packed_series = series.map((one) => ({ ...one, values: base64(Float64Array.from(one.values)) }));
    return { name, outcome, duration_s, bodies, initial, frames, series: packed_series, events };
  });
  const show = { version: 1, title, description, gravity: [0, 0, -9.81], meshes, runs: described };
  damage.show?.(show);
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>${title}</title><style>${css}</style></head><body>
${body}
${blocks.join('\n')}
<script id="polhode-show" type="application/json">${jsonText(show)}</script>
<script id="polhode-report" type="application/json">${jsonText({ title, outcome: runs[0]?.outcome ?? null })}</script>
<script>${bundle}</script>
</body></html>
`;
}
