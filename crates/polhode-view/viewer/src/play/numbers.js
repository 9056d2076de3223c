// Numbers in words.

/** A number with three digits and its unit; small and large ones by powers of ten. */
export function worded(value, unit = '') {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const text = size !== 0 && (size < 1e-3 || size >= 1e5) ? value.toExponential(1) : String(Number(value.toPrecision(3)));
  return unit ? `${text} ${unit}` : text;
}

/** A part of a whole, in percent. */
export function percent(part) {
  if (!Number.isFinite(part)) return '–';
  if (part !== 0 && Math.abs(part) < 0.001) return part.toExponential(1);
  return `${Number((100 * part).toPrecision(3))} %`;
}
