// What the page has packed: bytes as letters of 7 bits each, the first bit first, and texts by gzip.
//
// A letter with 128 added stands for one that HTML would replace or take for a tag.

import { gunzip } from '../decode.js';
import { PageError } from '../errors.js';

/** The bytes of an element; `what` names it in the error text. */
export function packedBytes(id, what) {
  const text = document.getElementById(id)?.textContent;
  if (!text) throw new PageError(`The page does not hold ${what}: it was cut off before its end. Get it again, or write it by \`polhode play\`.`);
  const bytes = new Uint8Array(Math.floor((text.length * 7) / 8));
  let held = 0;
  let bits = 0;
  let at = 0;
  for (let k = 0; k < text.length; k += 1) {
    held = (held << 7) | (text.charCodeAt(k) & 127);
    bits += 7;
    if (bits >= 8) {
      bits -= 8;
      bytes[at] = held >> bits;
      at += 1;
      held &= (1 << bits) - 1;
    }
  }
  return bytes;
}

/** The text of an element. */
export async function packedText(id, what) {
  return new TextDecoder().decode(await gunzip(packedBytes(id, what), what));
}
