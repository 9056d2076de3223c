// The scene in the address: `#scene=` and the text, deflated, as base64 without `+`, `/` and `=`.

import { PageError } from '../errors.js';

const KEY = 'scene=';

async function through(bytes, stream) {
  const passed = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(passed).arrayBuffer());
}

function toText(bytes) {
  let letters = '';
  for (let at = 0; at < bytes.length; at += 0x8000) letters += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function toBytes(text) {
  return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
}

/** The part of an address that holds a scene. A checksum stands before it, so that a part of it is no other scene. */
export async function hashOf(text) {
  const bytes = new TextEncoder().encode(text);
  return `#${KEY}${toText(await through(bytes, new CompressionStream('deflate')))}`;
}

/** The scene in an address, or null where it has none. */
export async function sceneIn(hash) {
  if (!hash.startsWith(`#${KEY}`)) return null;
  try {
    const bytes = await through(toBytes(hash.slice(KEY.length + 1)), new DecompressionStream('deflate'));
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new PageError(
      'The scene in the address cannot be read: the address was cut off or changed on its way. ' +
        'Ask for it again, as a whole; many programs break long lines.',
    );
  }
}
