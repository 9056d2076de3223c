// The camera of pages stands where that of pictures does: all points lie in the picture, as near to its rims on both sides, and
// the numbers are those of the same test in polhode-view (tests/it/stills.rs).

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FROM, holding, LOOK } from '../src/framing.js';

const corners = Array.from({ length: 8 }, (_, corner) => [0, 1, 2].map((k) => ((corner >> k) & 1 ? 1 : -1)));
/** Where a camera stands that holds a cube of 2 m in a picture of width 3 and height 2. */
const EXPECTED = [2.383938639594104, -4.631333833463414, 1.660965278914695];
const slope = Math.tan(LOOK.field_of_view_rad / 2) / LOOK.margin;

test('a camera stands where that of a picture does', () => {
  const { eye, target } = holding(corners, FROM, 1.5 * slope, slope);
  EXPECTED.forEach((value, k) => assert.ok(Math.abs(eye[k] - value) < 1e-6, `${eye}`));
  const arm = target.map((value, k) => value - eye[k]);
  const size = Math.hypot(...FROM);
  arm.forEach((value, k) => assert.ok(Math.abs(value / Math.hypot(...arm) + FROM[k] / size) < 1e-12));
});

test('a place that is to be in the middle is', () => {
  const { target, distance } = holding(corners, FROM, 1.5 * slope, slope, [0.5, 0, 0]);
  assert.deepEqual(target, [0.5, 0, 0]);
  assert.ok(distance > holding(corners, FROM, 1.5 * slope, slope).distance);
});

test('no points and one point are looked at', () => {
  assert.ok(Number.isFinite(holding([], FROM, slope, slope).distance));
  assert.ok(holding([[1, 2, 3]], FROM, slope, slope).distance > 0);
});
