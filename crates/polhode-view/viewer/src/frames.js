// The frames of one run: chunks are unpacked when they are wanted, kept in a cache of bounded size, and the next one is
// unpacked ahead.

import { bytesOfBase64 } from './bytes.js';
import { CHANNELS, decodeChunk, gunzip, readRow } from './decode.js';
import { PageError, wordsOf } from './errors.js';
import { blockText } from './show.js';

/** Largest size of the unpacked chunks of a run that are kept, in bytes; two chunks are kept in any case. */
const CACHE_BYTES = 256 * 1024 * 1024;
const CHUNKS_ALWAYS_KEPT = 2;
/** A long reading tells of its progress so often, in ms: each telling draws the picture again. */
const TELL_EVERY_MS = 500;

export class Frames {
  /** `when_loaded` is called after each chunk that was asked for, `when_broken` with words and the span of frames. */
  constructor(run, when_loaded, when_broken) {
    this.run = run;
    this.when_loaded = when_loaded;
    this.when_broken = when_broken;
    // A Map keeps the order of insertion: the first key is the one unused for longest.
    this.cache = new Map();
    this.cached_bytes = 0;
    this.loading = new Map();
    this.broken = new Set();
    this.bytes_decoded = 0;
  }

  /** The index of the last frame at or before the time t; the first frame for earlier times. */
  frameAt(t) {
    const { times } = this.run;
    let low = 0;
    let high = times.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle;
      else high = middle;
    }
    return low;
  }

  /** The index of the chunk that holds a frame. */
  chunkOf(frame) {
    const { chunks } = this.run;
    let low = 0;
    let high = chunks.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (chunks[middle].first <= frame) low = middle;
      else high = middle;
    }
    return low;
  }

  /** The unpacked chunk if it is in the cache, else null; asks for it and for the one after it. */
  chunk(index) {
    const found = this.cache.get(index) ?? null;
    if (found) {
      this.cache.delete(index);
      this.cache.set(index, found);
    } else {
      this.load(index);
    }
    if (index + 1 < this.run.chunks.length && !this.cache.has(index + 1)) this.load(index + 1);
    return found;
  }

  /** Whether the frame can be drawn at once (or never: its chunk is broken). */
  ready(frame) {
    if (this.run.times.length === 0) return true;
    const index = this.chunkOf(frame);
    return this.broken.has(index) || this.chunk(index) !== null;
  }

  /** Unpacks a chunk into the cache; the promise never fails. */
  load(index) {
    if (this.cache.has(index) || this.broken.has(index)) return Promise.resolve();
    if (!this.loading.has(index)) {
      const loading = this.unpack(index)
        .then((chunk) => this.keep(index, chunk))
        .catch((error) => this.giveUp(index, error))
        .finally(() => {
          this.loading.delete(index);
          this.when_loaded();
        });
      this.loading.set(index, loading);
    }
    return this.loading.get(index);
  }

  async unpack(index) {
    const bytes = await this.gunzipped(index);
    const { count } = this.run.chunks[index];
    const shape = { bodies: this.run.moving.length, frames: count, contacts: this.run.contacts };
    return decodeChunk(bytes, shape, this.nameOf(index));
  }

  async gunzipped(index) {
    const text = blockText(`polhode-frames-${this.run.index}-${index}`);
    if (text === null) throw new PageError(`${this.nameOf(index)} is missing from the page.`);
    const bytes = await gunzip(bytesOfBase64(text, this.nameOf(index)), this.nameOf(index));
    this.bytes_decoded += bytes.length;
    return bytes;
  }

  nameOf(index) {
    const { first, count } = this.run.chunks[index];
    const { times, name } = this.run;
    const span = `${times[first].toPrecision(4)} s to ${times[first + count - 1].toPrecision(4)} s`;
    return `The part from ${span} of the run “${name}”`;
  }

  keep(index, chunk) {
    this.cache.set(index, chunk);
    this.cached_bytes += chunk.bytes;
    for (const [old, old_chunk] of this.cache) {
      if (this.cached_bytes <= CACHE_BYTES || this.cache.size <= CHUNKS_ALWAYS_KEPT) break;
      this.cache.delete(old);
      this.cached_bytes -= old_chunk.bytes;
    }
  }

  giveUp(index, error) {
    this.broken.add(index);
    this.when_broken(wordsOf(error));
  }

  /**
   * Reads some channels of some bodies of every `stride`-th frame, one chunk after another, without filling the cache.
   * Calls take(frame, values) with the integers channel by channel, body by body, and now and then after_chunk();
   * stops when `signal` is aborted.
   * Bodies are given by their place in `moving`.
   */
  async scan(places, channels, stride, take, signal, after_chunk) {
    let told = performance.now();
    for (let index = 0; index < this.run.chunks.length; index += 1) {
      if (signal.aborted) return;
      if (this.broken.has(index)) continue;
      const { first, count } = this.run.chunks[index];
      const rows = await this.rowsOf(index, places, channels).catch((error) => this.giveUp(index, error));
      if (signal.aborted || !rows) continue;
      const values = new Int32Array(places.length * channels.length);
      for (let frame = 0; frame < count; frame += 1) {
        if ((first + frame) % stride !== 0) continue;
        for (let row = 0; row < values.length; row += 1) values[row] = rows[row * count + frame];
        take(first + frame, values);
      }
      if (performance.now() - told > TELL_EVERY_MS || index === this.run.chunks.length - 1) {
        after_chunk();
        told = performance.now();
      }
    }
  }

  async rowsOf(index, places, channels) {
    const { count } = this.run.chunks[index];
    const shape = { bodies: this.run.moving.length, frames: count };
    const rows = new Int32Array(places.length * channels.length * count);
    const cached = this.cache.get(index);
    const bytes = cached ? null : await this.gunzipped(index);
    if (bytes && bytes.length < 4 * CHANNELS * shape.bodies * count) {
      throw new PageError(`${this.nameOf(index)} is too short: it does not fit the run.`);
    }
    channels.forEach((channel, c) => {
      places.forEach((place, p) => {
        const offset = (c * places.length + p) * count;
        const at = (channel * shape.bodies + place) * count;
        if (cached) rows.set(cached.values.subarray(at, at + count), offset);
        else readRow(bytes, shape, channel, place, rows, offset);
      });
    });
    return rows;
  }
}
