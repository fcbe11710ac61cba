// What differs, and what is expected to (expected.csv).
import {readFileSync} from 'node:fs';

/** What is compared of a file, and which share of the pixels compared may be apart. */
const kShares = {
  read: 0,
  silhouette: 0,
  colour: 0.02,
  light: 0.005,
  pose: 0,
  camera: 0,
};

/** How far means of tiles may be apart, in the step by which colours may be. */
const kTileSteps = 1.5;
export const kAspects = Object.keys(kShares);

const keyOf = ({case: name, aspect}) => `${name} ${aspect}`;

/** Colours of fewer pixels say nothing. */
const kFewestPixels = 1000;

/** Whether a measured row is more than what its aspect allows. */
export function differs(row) {
  const {value, pixels = 0, tiles = 0, step = 0} = row;
  if (row.pixels !== undefined && row.pixels < kFewestPixels) return true;
  return value > kShares[row.aspect] * pixels || tiles > kTileSteps * step;
}

/** Sorts the worse row first: one that differs is worse than one that does not, then pixels count, then tiles. */
const worseFirst = (a, b) =>
    Number(differs(b)) - Number(differs(a)) || b.value - a.value || (b.tiles ?? 0) - (a.tiles ?? 0);

/** Of each case and aspect the row that is worst. */
export function worstOf(rows) {
  const worst = new Map();
  for (const row of rows) {
    const known = worst.get(keyOf(row));
    if (!known || worseFirst(row, known) < 0) worst.set(keyOf(row), row);
  }
  return [...worst.values()];
}

/** Lines "case,aspect,reason" below a heading; the reason goes on to the line's end. */
export function readExpected(path) {
  const [, ...lines] = readFileSync(path, 'utf8').split('\n').filter((line) => line !== '');
  return lines.map((line) => {
    const [name, aspect, ...reason] = line.split(',');
    if (!kAspects.includes(aspect) || reason.length === 0) throw new Error(`${path}: '${line}' is no line of it`);
    return {case: name, aspect, reason: reason.join(',')};
  });
}

function wordsOf(row) {
  if (row.aspect === 'read') {
    const says = (error) => (error ? `does not draw it (${error.split('\n')[0]})` : 'draws it');
    return `three.js ${says(row.three)}, zstrip ${says(row.zstrip)}`;
  }
  if (row.zstrip || row.three) return row.zstrip || row.three;
  const tiles = row.tiles === undefined ? '' : `, tiles by ${row.tiles.toFixed(1)} of 255`;
  return `${row.value} pixels${row.pixels === undefined ? '' : ` of ${row.pixels}`}${row.id ? ` in '${row.id}'` : ''}${
      tiles}`;
}

/** A line for each difference that is not expected, and for each that is expected and not there. */
export function surprises(rows, expected, aspect) {
  const keys = new Set(expected.map(keyOf));
  const there = new Set(rows.filter(differs).map(keyOf));
  const asked = (row) => row.aspect === aspect;
  return [
    ...rows.filter(asked)
        .filter((row) => differs(row) && !keys.has(keyOf(row)))
        .map((row) => `${row.case}: ${aspect} differs: ${wordsOf(row)}`),
    ...expected.filter(asked)
        .filter((row) => !there.has(keyOf(row)))
        .map((row) => `${row.case}: ${aspect} does not differ; take the line out of tests/viewer/expected.csv`),
  ];
}
