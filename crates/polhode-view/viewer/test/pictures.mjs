// Small pictures of the canvas, and how they differ.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';

/** Pixels of a picture, and how far a value of 0..255 must be off to count as another. */
const PICTURE = [320, 200];
const ANOTHER_COLOUR = 6;
/** A picture is another one when at least this many of its pixels are. */
export const ANOTHER_PICTURE = 12;
/** Another version of the browser may draw the rims of things differently: so many pixels may be clearly others. */
const CLEARLY_ANOTHER = 40;
const MOST_OTHER_PIXELS = (PICTURE[0] * PICTURE[1]) / 100;

/** A picture as the page gives it, PNG in base64; `from` is null for the canvas at the present time, or such a PNG. */
function pixelsInPage([from, width, height]) {
  const copy = document.createElement('canvas');
  copy.width = width;
  copy.height = height;
  const pen = copy.getContext('2d', { willReadFrequently: true });
  const draw = async () => {
    if (from === null) {
      await window.polhode.seek(window.polhode.time());
      return document.getElementById('stage');
    }
    const image = new Image();
    image.src = from;
    await image.decode();
    return image;
  };
  return draw().then((source) => {
    pen.drawImage(source, 0, 0, width, height);
    const values = Array.from(pen.getImageData(0, 0, width, height).data, (value) => String.fromCharCode(value));
    return { pixels: values.join(''), png: copy.toDataURL('image/png') };
  });
}

const asBytes = (text) => Uint8Array.from(text, (letter) => letter.charCodeAt(0));

/** The pixels of the canvas, small, as the present time is drawn. */
export async function picture(page) {
  return asBytes((await page.evaluate(pixelsInPage, [null, ...PICTURE])).pixels);
}

/** How many pixels of two pictures differ. */
export function difference(one, other, least = ANOTHER_COLOUR) {
  let count = 0;
  for (let at = 0; at < one.length; at += 4) {
    if ([0, 1, 2].some((k) => Math.abs(one[at + k] - other[at + k]) > least)) count += 1;
  }
  return count;
}

/** How many colours a picture has. */
export function colours(pixels) {
  const seen = new Set();
  for (let at = 0; at < pixels.length; at += 4) seen.add((pixels[at] << 16) | (pixels[at + 1] << 8) | pixels[at + 2]);
  return seen.size;
}

/**
 * Compares the canvas with the picture committed at `path`: { good, words }. With `record` a picture that is missing or
 * another one is written anew, and that is good.
 */
export async function compareWith(page, path, record) {
  const now = await page.evaluate(pixelsInPage, [null, ...PICTURE]);
  const write = () => {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, Buffer.from(now.png.split(',')[1], 'base64'));
  };
  if (!existsSync(path)) {
    if (record) write();
    return { good: record, words: record ? 'written for the first time' : `no picture is committed as ${path}` };
  }
  const png = `data:image/png;base64,${readFileSync(path, 'base64')}`;
  const committed = await page.evaluate(pixelsInPage, [png, ...PICTURE]);
  const count = difference(asBytes(now.pixels), asBytes(committed.pixels), CLEARLY_ANOTHER);
  const same = count <= MOST_OTHER_PIXELS;
  if (!same && record) write();
  const words = `${count} pixels differ, at most ${MOST_OTHER_PIXELS} may`;
  return { good: same || record, words: same || !record ? words : `written anew: ${words}` };
}
