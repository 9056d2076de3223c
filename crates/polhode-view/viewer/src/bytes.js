// Base64 text of the page to bytes and to arrays of little-endian numbers.
//
// Every browser that runs WebGL is little-endian today, so the typed arrays are views of the bytes as they stand.

import { PageError } from './errors.js';

/** The bytes of a base64 text; `what` names it in the error text. */
export function bytesOfBase64(text, what) {
  const trimmed = text.trim();
  try {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(trimmed);
    return Uint8Array.from(atob(trimmed), (letter) => letter.charCodeAt(0));
  } catch {
    throw new PageError(`${what} is not base64 text: the page is damaged or was cut off.`);
  }
}

/** The numbers of a base64 text as an array of `kind` (Float64Array, Float32Array, Uint32Array). */
export function numbersOfBase64(text, kind, what) {
  if (typeof text !== 'string') throw new PageError(`${what} is missing.`);
  const bytes = bytesOfBase64(text, what);
  if (bytes.length % kind.BYTES_PER_ELEMENT !== 0) {
    throw new PageError(`${what} has ${bytes.length} bytes, which is no whole number of values.`);
  }
  return new kind(bytes.buffer, bytes.byteOffset, bytes.length / kind.BYTES_PER_ELEMENT);
}
