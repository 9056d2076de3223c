// Numbers for the reader: short texts, and round values for scales.

/** The least of 1, 2, 5 times a power of ten that is not below a positive value. */
export function roundedUp(value) {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [1, 2, 5, 10].find((factor) => factor * power >= value * (1 - 1e-9)) ?? 10;
  return step * power;
}

/** The largest of 1, 2, 5 times a power of ten that is not above a positive value. */
export function roundedDown(value) {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return ([5, 2, 1].find((factor) => factor * power <= value * (1 + 1e-9)) ?? 1) * power;
}

/** A length in m in the largest unit of which it has one. */
export function lengthWords(length) {
  const units = [
    ['km', 1e3],
    ['m', 1],
    ['cm', 1e-2],
    ['mm', 1e-3],
    ['µm', 1e-6],
  ];
  const [name, unit] = units.find(([, metres]) => length >= metres * (1 - 1e-9)) ?? units.at(-1);
  return `${short(length / unit, 3)} ${name}`;
}

/** A number in at most `digits` digits, with a power of ten where it is far from one. */
export function short(value, digits = 4) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) {
    return value
      .toExponential(digits - 2)
      .replace(/\.?0+e/, 'e')
      .replace('e+', 'e')
      .replace('-', '−')
      .replace('e-', 'e−');
  }
  return String(Number(value.toPrecision(digits))).replace('-', '−');
}

/** Seconds with the same number of places for the whole run, so that the text does not jump. */
export function seconds(value, duration) {
  const places = Math.min(6, Math.max(3, 3 - Math.floor(Math.log10(Math.max(duration, 1e-6)))));
  return `${value.toFixed(places)} s`;
}

/** The finite value below which the share `share` of the values lies, or null where there is none. */
export function quantile(values, share) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  return sorted.length === 0 ? null : sorted[Math.round(share * (sorted.length - 1))];
}
