// A chunk of frames: gzip, planes of bytes, second differences, contacts.
//
// For B bodies and F frames a chunk holds 13 channels (position 3, orientation 4, velocity 3, angular velocity 3) of
// 32-bit integers. Of each channel of each body the second differences over the frames are stored,
//   d[0] = x[0],  d[1] = x[1] - x[0],  d[k] = x[k] - 2 x[k-1] + x[k-2],
// all wrapping at 32 bits, folded to unsigned by zigzag, z = (d << 1) ^ (d >> 31), and split into four planes of bytes,
// the lowest byte first. Smooth motion has small second differences, so that the upper planes are nearly all zero.
// After the channels stand, where the run has contacts, the motion kinds, the islands and the contacts of each frame;
// loads of joints stand among these (JOINT_LOAD).

import { PageError } from './errors.js';

/** Channels of a body: px py pz, qw qx qy qz, vx vy vz, wx wy wz. */
export const CHANNELS = 13;
/** Bytes of one contact: two bodies, point, normal, separation, force. */
export const CONTACT_BYTES = 40;
/** 32-bit words of one contact. */
export const CONTACT_WORDS = CONTACT_BYTES / 4;
/** What stands in place of the first body of a contact where it is the load of a joint. */
export const JOINT_LOAD = 0xffffffff;
/** The island number that says "in no island". */
export const NO_ISLAND = 0xffff;

/** Gunzips bytes; `what` names them in the error text. */
export async function gunzip(bytes, what) {
  if (typeof DecompressionStream === 'undefined') {
    throw new PageError('This browser cannot unpack the frames (it has no DecompressionStream). A newer one can.');
  }
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new PageError(`${what} cannot be unpacked: the data are damaged or were cut off.`);
  }
}

/** The values of one channel of one body over the frames of a chunk, written to `out` from `offset` on. */
export function readRow(bytes, shape, channel, body, out, offset) {
  const { bodies, frames } = shape;
  const plane = CHANNELS * bodies * frames;
  const first = (channel * bodies + body) * frames;
  let value = 0;
  let slope = 0;
  for (let frame = 0; frame < frames; frame += 1) {
    const at = first + frame;
    const folded = bytes[at] | (bytes[at + plane] << 8) | (bytes[at + 2 * plane] << 16) | (bytes[at + 3 * plane] << 24);
    const difference = (folded >>> 1) ^ -(folded & 1);
    if (frame === 0) {
      value = difference;
    } else {
      slope = frame === 1 ? difference : (slope + difference) | 0;
      value = (value + slope) | 0;
    }
    out[offset + frame] = value;
  }
}

/** Says in words that a chunk is shorter or longer than its shape demands. */
function checkLength(bytes, wanted, exactly, what) {
  if (bytes.length === wanted || (!exactly && bytes.length > wanted)) return;
  throw new PageError(`${what} has ${bytes.length} bytes where ${wanted} are wanted: it does not fit the run.`);
}

/** All that a chunk holds. `shape` is { bodies, frames, contacts }. */
export function decodeChunk(bytes, shape, what) {
  const { bodies, frames } = shape;
  const rows = CHANNELS * bodies;
  checkLength(bytes, 4 * rows * frames, !shape.contacts, what);
  const values = new Int32Array(rows * frames);
  for (let row = 0; row < rows; row += 1) {
    readRow(bytes, shape, Math.floor(row / bodies), row % bodies, values, row * frames);
  }
  const chunk = { frames, values, kinds: null, islands: null, contact_start: null, contacts: null };
  if (shape.contacts) Object.assign(chunk, decodeContacts(bytes, shape, what));
  chunk.bytes = values.byteLength + (shape.contacts ? bytes.length - 4 * rows * frames : 0);
  return chunk;
}

/** Motion kinds, islands and contacts: the part of a chunk after the channels. */
function decodeContacts(bytes, shape, what) {
  const { bodies, frames } = shape;
  const cells = bodies * frames;
  const kinds_at = 4 * CHANNELS * cells;
  const islands_at = kinds_at + cells;
  const counts_at = islands_at + 2 * cells;
  const contacts_at = counts_at + 4 * frames;
  checkLength(bytes, contacts_at, false, what);
  // Copies, because typed arrays of more than one byte must begin at a multiple of their size.
  const counts = new Uint32Array(bytes.slice(counts_at, contacts_at).buffer);
  const contact_start = new Uint32Array(frames + 1);
  for (let frame = 0; frame < frames; frame += 1) contact_start[frame + 1] = contact_start[frame] + counts[frame];
  checkLength(bytes, contacts_at + CONTACT_BYTES * contact_start[frames], true, what);
  const records = contactRecords(bytes, contacts_at, contact_start[frames]);
  return {
    kinds: bytes.slice(kinds_at, islands_at),
    islands: new Uint16Array(bytes.slice(islands_at, counts_at).buffer),
    contact_start,
    contacts: { indices: new Uint32Array(records), numbers: new Float32Array(records) },
  };
}

/**
 * The contacts one after the other, ten words each. In the chunk they stand in columns, and the columns in four planes of
 * bytes, the lowest first: byte p of column c of contact n is at (p * 10 + c) * count + n.
 */
function contactRecords(bytes, first, count) {
  const records = new Uint8Array(CONTACT_BYTES * count);
  let at = first;
  for (let plane = 0; plane < 4; plane += 1) {
    for (let column = 0; column < CONTACT_WORDS; column += 1) {
      for (let contact = 0; contact < count; contact += 1) {
        records[(contact * CONTACT_WORDS + column) * 4 + plane] = bytes[at];
        at += 1;
      }
    }
  }
  return records.buffer;
}
