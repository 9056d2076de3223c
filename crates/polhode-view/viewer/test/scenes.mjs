// Synthetic runs for the tests: a free top, a pile of boxes, rolling balls.

const IDENTITY = [1, 0, 0, 0];
const NO_ISLAND = 0xffff;

/** Frame times with `rate` frames a second. */
const timesOf = (count, rate) => Array.from({ length: count }, (_, frame) => frame / rate);

const part = (mesh, scale, position = [0, 0, 0]) => ({ mesh, position, orientation: IDENTITY, scale });

const boxOf = (half) => [half.map((value) => -value), half];

const floor = {
  name: 'floor',
  moves: false,
  mass_kg: null,
  principal_inertia_kg_m2: null,
  principal_axes: IDENTITY,
  parts: [],
  half_spaces: [{ normal: [0, 0, 1], offset_m: 0 }],
  box: null,
};

/** A free asymmetric top near its middle axis; Euler's equations by RK4 with many steps a frame. */
export function top(name = 'accurate', error = 0) {
  const inertia = [1, 2, 3.2];
  const frames = 900;
  const states = [];
  let q = IDENTITY;
  let w = [0.05 + error, 6, 0.1];
  const rate = ([q, w]) => {
    const [a, b, c] = inertia;
    const dw = [((b - c) / a) * w[1] * w[2], ((c - a) / b) * w[2] * w[0], ((a - b) / c) * w[0] * w[1]];
    const dq = [
      -(q[1] * w[0] + q[2] * w[1] + q[3] * w[2]) / 2,
      (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]) / 2,
      (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]) / 2,
      (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]) / 2,
    ];
    return [dq, dw];
  };
  const plus = (y, k, h) => y.map((list, i) => list.map((value, j) => value + h * k[i][j]));
  const h = 1 / 60 / 10;
  for (let frame = 0; frame < frames; frame += 1) {
    const [a, b, c, d] = q;
    const [x, y, z] = w;
    const turn = (v) => {
      const t = [2 * (c * v[2] - d * v[1]), 2 * (d * v[0] - b * v[2]), 2 * (b * v[1] - c * v[0])];
      return [
        v[0] + a * t[0] + c * t[2] - d * t[1],
        v[1] + a * t[1] + d * t[0] - b * t[2],
        v[2] + a * t[2] + b * t[1] - c * t[0],
      ];
    };
    const s = frame / 60;
    states.push([0.2 * s, 0, 2 + error * s, a, b, c, d, 0.2, 0, error, ...turn([x, y, z])]);
    for (let k = 0; k < 10; k += 1) {
      const y0 = [q, w];
      const k1 = rate(y0);
      const k2 = rate(plus(y0, k1, h / 2));
      const k3 = rate(plus(y0, k2, h / 2));
      const k4 = rate(plus(y0, k3, h));
      const sum = k1.map((list, i) => list.map((value, j) => (value + 2 * k2[i][j] + 2 * k3[i][j] + k4[i][j]) / 6));
      [q, w] = plus(y0, sum, h);
    }
  }
  const half = [1.2, 0.7, 0.35];
  const spin = states.map(([, , , , , , , , , , ...w]) => w.reduce((sum, value) => sum + value * value, 0) / 2);
  return {
    name,
    outcome: 'completed',
    duration_s: 15,
    chunk: 64,
    times: timesOf(frames, 60),
    moving: [1],
    bodies: [
      floor,
      {
        name: 'top',
        moves: true,
        mass_kg: 2,
        principal_inertia_kg_m2: inertia,
        principal_axes: IDENTITY,
        parts: [
          part(
            0,
            half.map((value) => 2 * value),
          ),
          part(1, [0.3, 0.3, 0.3], [0, 0, 0.5]),
        ],
        half_spaces: [],
        box: boxOf(half),
      },
    ],
    initial: [[0, 0, 0, ...IDENTITY], states[0].slice(0, 7)],
    state: (frame) => states[frame],
    series: [
      { group: 'energy', name: 'kinetic', unit: 'J', values: spin },
      { group: 'energy', name: 'total', unit: 'J', values: spin.map(() => 36 + error) },
      {
        group: 'ledger',
        name: 'D_numerical',
        unit: 'J',
        values: spin.map((_, k) => 1e-15 * (1 + error * 1e6) * Math.exp(k / 60)),
      },
    ],
    events: [],
  };
}

/** Boxes that fall on one another and come to rest, with contacts, islands and events. */
export function pile({ columns = 4, rows = 4, event_count = 40, seconds = 4, outcome = 'completed' } = {}) {
  const half = [0.4, 0.3, 0.2];
  const frames = Math.round(seconds * 60);
  const times = timesOf(frames, 60);
  const count = columns * rows;
  const bodies = Array.from({ length: count }, (_, k) => ({
    name: `r${Math.floor(k / columns) + 1}c${(k % columns) + 1}`,
    moves: true,
    mass_kg: 1,
    principal_inertia_kg_m2: [0.04, 0.06, 0.08],
    principal_axes: IDENTITY,
    parts: [
      part(
        0,
        half.map((value) => 2 * value),
      ),
    ],
    half_spaces: [],
    box: boxOf(half),
  }));
  const restHeight = (k) => half[2] * (2 * Math.floor(k / columns) + 1);
  const restTime = (k) => Math.sqrt((2 * (0.6 + 0.3 * Math.floor(k / columns))) / 9.81);
  const state = (frame, k) => {
    const t = Math.min(times[frame], restTime(k));
    const drop = (9.81 * (restTime(k) ** 2 - t * t)) / 2;
    const left = restTime(k) - t;
    const angle = 0.8 * left;
    const falls = left > 0;
    return [
      (k % columns) * 1.1 - columns / 2,
      0.12 * Math.floor(k / columns),
      restHeight(k) + drop,
      Math.cos(angle / 2),
      0,
      0,
      Math.sin(angle / 2),
      0,
      0,
      falls ? -9.81 * t : 0,
      0,
      0,
      falls ? -0.8 : 0,
    ];
  };
  const rests = (frame, k) => times[frame] >= restTime(k);
  const contactsOf = (frame) =>
    bodies.flatMap((_, k) => {
      if (!rests(frame, k)) return [];
      const [x, y, z] = state(frame, k);
      const below = k >= columns ? k - columns + 1 : 0;
      return [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ].map(([p, q]) => ({
        a: k + 1,
        b: below,
        point: [x + p * half[0], y + q * half[1], z - half[2]],
        normal: [0, 0, 1],
        separation: 0,
        force: k === 0 ? NaN : (9.81 / 4) * (rows - Math.floor(k / columns)),
      }));
    });
  const kinds = ['impact', 'contact_begin', 'rest', 'slide'];
  const potential = times.map((_, frame) => bodies.reduce((sum, _, k) => sum + 9.81 * state(frame, k)[2], 0));
  const kinetic = times.map((_, frame) => bodies.reduce((sum, _, k) => sum + state(frame, k)[9] ** 2 / 2, 0));
  return {
    name: 'pile',
    outcome,
    duration_s: outcome === 'completed' ? seconds : 2 * seconds,
    chunk: 48,
    times,
    bodies: [floor, ...bodies],
    moving: bodies.map((_, k) => k + 1),
    initial: [[0, 0, 0, ...IDENTITY], ...bodies.map((_, k) => state(0, k).slice(0, 7))],
    state,
    contactsOf,
    kind: (frame, k) => (rests(frame, k) ? 3 : 1),
    island: (frame, k) => (rests(frame, k) && times[frame] < restTime(k) + 1 ? k % columns : NO_ISLAND),
    series: [
      { group: 'energy', name: 'kinetic', unit: 'J', values: kinetic },
      { group: 'energy', name: 'potential', unit: 'J', values: potential },
      { group: 'energy', name: 'total', unit: 'J', values: kinetic.map((value, k) => value + potential[k]) },
      { group: 'ledger', name: 'D_impact', unit: 'J', values: times.map((t) => Math.max(0, 40 * (t - 0.3))) },
      { group: 'ledger', name: 'D_friction', unit: 'J', values: times.map((t) => 1e-6 * t) },
      {
        group: 'ledger',
        name: 'closure',
        unit: 'J',
        values: times.map((_, k) => (k % 5 === 0 ? NaN : 1e-14 * (1 + Math.sin(k)))),
      },
      {
        group: 'penetration',
        name: 'largest',
        unit: 'm',
        values: times.map((_, k) => 1e-13 * Math.abs(Math.sin(k / 9))),
      },
      {
        group: 'residual',
        name: 'complementarity',
        unit: 'N',
        values: times.map((_, k) => 10 ** (-12 + 5 * Math.sin(k / 30))),
      },
      { group: 'steps', name: 'step', unit: 's', values: times.map((_, k) => 10 ** (-3 + Math.sin(k / 20))) },
    ],
    events: Array.from({ length: event_count }, (_, k) => ({
      t: (seconds * (k + 0.5)) / event_count,
      kind: kinds[k % kinds.length],
      bodies: [1 + (k % count), 0],
      text: `${bodies[k % count].name} ${kinds[k % kinds.length].replace('_', ' ')} on floor`,
    })),
  };
}

/** A reproducible value in -1..1 for three integers, so that a crowd packs no better than a real run does. */
function noise(frame, body, channel) {
  let bits = (frame * 73856093) ^ (body * 19349663) ^ (channel * 83492791);
  bits = Math.imul(bits ^ (bits >>> 15), 2246822519);
  bits = Math.imul(bits ^ (bits >>> 13), 3266489917);
  return ((bits ^ (bits >>> 16)) >>> 0) / 2 ** 31 - 1;
}

/** Sizes of the noise: position in m, quaternion, velocity in m/s, angular velocity in rad/s. */
const NOISE = [1e-6, 1e-6, 1e-6, 0, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 1e-4];

/** Many rolling balls on a grid. */
export function crowd(bodies, frames) {
  const side = Math.ceil(Math.sqrt(bodies));
  const times = timesOf(frames, 100);
  const state = (frame, k) => {
    const t = times[frame];
    const phase = k * 0.37;
    const x = (k % side) * 0.5 + 0.15 * Math.sin(2 * t + phase);
    const angle = 0.75 * Math.sin(2 * t + phase);
    return [
      x,
      Math.floor(k / side) * 0.5,
      0.2,
      Math.cos(angle / 2),
      0,
      Math.sin(angle / 2),
      0,
      0.3 * Math.cos(2 * t + phase),
      0,
      0,
      0,
      1.5 * Math.cos(2 * t + phase),
      0,
    ];
  };
  const balls = Array.from({ length: bodies }, (_, k) => ({
    name: `ball ${k + 1}`,
    moves: true,
    mass_kg: 1,
    principal_inertia_kg_m2: [1, 1, 1],
    principal_axes: IDENTITY,
    parts: [part(k % 3 === 0 ? 0 : 1, Array(3).fill(k % 3 === 0 ? 0.3 : 0.2))],
    half_spaces: [],
    box: boxOf([0.2, 0.2, 0.2]),
  }));
  return {
    name: 'crowd',
    outcome: 'completed',
    duration_s: frames / 100,
    chunk: 32,
    times,
    bodies: [floor, ...balls],
    moving: balls.map((_, k) => k + 1),
    initial: [[0, 0, 0, ...IDENTITY], ...balls.map((_, k) => state(0, k).slice(0, 7))],
    state: (frame, k) => state(frame, k).map((value, channel) => value + NOISE[channel] * noise(frame, k, channel)),
    series: [{ group: 'energy', name: 'kinetic', unit: 'J', values: times.map((t) => bodies * Math.cos(2 * t) ** 2) }],
    events: Array.from({ length: 10000 }, (_, k) => ({
      t: (k * frames) / 1e6,
      kind: ['impact', 'stick', 'slide'][k % 3],
      bodies: [k % bodies],
      text: `ball ${k % bodies}`,
    })),
  };
}
