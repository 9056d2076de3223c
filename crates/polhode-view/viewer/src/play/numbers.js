// Numbers in words.

import { short } from '../numbers.js';

/** A number in three digits, with its unit. */
export function worded(value, unit = '') {
  return unit ? `${short(value, 3)} ${unit}` : short(value, 3);
}

/** A part of a whole, in percent. */
export function percent(part) {
  if (!Number.isFinite(part)) return '–';
  if (part !== 0 && Math.abs(part) < 0.001) return short(part, 3);
  return `${Number((100 * part).toPrecision(3))} %`;
}
