// What compare.mjs says of small pictures whose difference is known.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {coloursApart, dilate, erode, silhouettesApart, tilesApart, toRgb565} from './compare.mjs';
import {differs, surprises, worstOf} from './expected.mjs';

const kSide = 16;
const kArea = {
  width: kSide,
  height: kSide,
  step: 8
};

/** A square of 8x8 pixels whose upper left corner is at x, y. */
const square = (x, y, side = 8) => Uint8Array.from({length: kSide * kSide}, (_, i) => {
  const u = i % kSide, v = Math.floor(i / kSide);
  return u >= x && u < x + side && v >= y && v < y + side ? 1 : 0;
});

/** Where the mask is, one colour, elsewhere the other. */
const picture = (mask, colour, other = [0, 0, 0]) => Uint8Array.from({length: 4 * mask.length}, (_, i) => {
  return i % 4 === 3 ? 255 : (mask[i >> 2] ? colour : other)[i % 4];
});
const count = (mask) => mask.reduce((a, b) => a + b, 0);
const kAll = square(0, 0, kSide);

test('a silhouette may be one pixel away', () => {
  assert.equal(count(silhouettesApart(square(4, 4), square(4, 4), kArea)), 0);
  assert.equal(count(silhouettesApart(square(4, 4), square(5, 5), kArea)), 0);
  assert.ok(count(silhouettesApart(square(4, 4), square(6, 4), kArea)) > 0);
  assert.ok(count(silhouettesApart(square(4, 4), square(0, 0, 0), kArea)) > 0);
});

test('a hole of more than two pixels is seen, in either picture', () => {
  const whole = square(2, 2, 12), holed = whole.map((covered, i) => covered & (square(6, 6, 3)[i] ^ 1));
  assert.ok(count(silhouettesApart(whole, holed, kArea)) > 0);
  assert.ok(count(silhouettesApart(holed, whole, kArea)) > 0);
});

test('dilating and eroding go one pixel, the border is no edge', () => {
  assert.deepEqual(dilate(square(4, 4, 2), kArea), square(3, 3, 4));
  assert.deepEqual(erode(square(3, 3, 4), kArea), square(4, 4, 2));
  assert.deepEqual(erode(kAll, kArea), kAll);
});

test('colours may be a step away, and their edges a pixel', () => {
  const red = picture(square(4, 4), [200, 0, 0]);
  assert.equal(count(coloursApart(red, picture(square(4, 4), [208, 8, 8]), kAll, kArea)), 0);
  assert.equal(count(coloursApart(red, picture(square(5, 4), [200, 0, 0]), kAll, kArea)), 0);
  assert.ok(count(coloursApart(red, picture(square(4, 4), [209, 0, 0]), kAll, kArea)) > 0);
  assert.ok(count(coloursApart(red, picture(square(6, 4), [200, 0, 0]), kAll, kArea)) > 0);
  assert.equal(count(coloursApart(red, picture(square(6, 4), [200, 0, 0]), square(6, 6, 2), kArea)), 0);
});

test('tiles have means', () => {
  const red = picture(kAll, [200, 0, 0]);
  assert.equal(tilesApart(red, picture(kAll, [190, 0, 0]), kAll, kArea), 10);
  assert.equal(tilesApart(red, picture(square(0, 0, 8), [100, 0, 0], [200, 0, 0]), square(8, 8), kArea), 0);
});

test('RGB565 widens what it has cut', () => {
  assert.deepEqual(
      [...toRgb565([255, 255, 255, 0, 7, 3, 7, 9, 8, 4, 132, 0])], [255, 255, 255, 255, 0, 0, 0, 255, 8, 4, 132, 255]);
});

test('a difference that is not listed is a surprise, and so is a listed one that is not there', () => {
  const rows = [{case: 'a', aspect: 'pose', value: 3}, {case: 'b', aspect: 'pose', value: 0}];
  const listed = (...names) => names.map((name) => ({case: name, aspect: 'pose', reason: 'why'}));
  assert.deepEqual(surprises(rows, listed('a'), 'pose'), []);
  assert.equal(surprises(rows, listed(), 'pose').length, 1);
  assert.equal(surprises(rows, listed('a', 'b'), 'pose').length, 1);
  assert.equal(surprises(rows, listed('a', 'gone'), 'pose').length, 1);
  assert.deepEqual(surprises(rows, listed(), 'light'), []);
});

test('colours may be apart in a share of the pixels, and must be of enough of them', () => {
  const row = (value, pixels, tiles = 0) => ({aspect: 'colour', value, pixels, tiles, step: 8});
  assert.ok(!differs(row(200, 10000)));
  assert.ok(differs(row(201, 10000)));
  assert.ok(!differs(row(0, 10000, 12)));
  assert.ok(differs(row(0, 10000, 12.1)));
  assert.ok(differs(row(0, 999)));
  assert.ok(differs({aspect: 'pose', value: 1}));
});

test('no row that does not differ takes the place of one that does', () => {
  const row = (value, tiles, pixels = 10000) => ({case: 'a', aspect: 'colour', value, pixels, tiles, step: 8});
  const most = row(300, 1), tiles = row(1, 13), few = row(0, 0, 999), same = [row(0, 11), row(200, 2), row(0, 0)];
  for (const worst of [most, tiles, few]) {
    assert.deepEqual(worstOf([worst, ...same]), [worst]);
    assert.deepEqual(worstOf([...same, worst]), [worst]);
  }
  assert.deepEqual(worstOf([tiles, most]), [most]);
  assert.deepEqual(worstOf([row(300, 20), most]), [row(300, 20)]);
  assert.deepEqual(worstOf([same[2], same[0]]), [same[0]]);
  assert.deepEqual(worstOf([row(0, 0), {...most, case: 'b'}]).map((each) => each.case), ['a', 'b']);
});
