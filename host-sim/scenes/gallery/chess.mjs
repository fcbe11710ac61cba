// Makes the models and textures of chess.toml. Public domain. Run: node chess.mjs
import fs from 'node:fs';

import {occluded, welded, writeModel} from './models.mjs';
import {writePicture} from './pictures.mjs';
import {box, extruded, lathe, mix, placed, polygon, random} from './shapes.mjs';

const kSides = 8;

// A profile goes from the top down: [radius, y]. Two points at one place make a sharp edge.
const foot = (r) => [[r * 0.62, 0.3], [r * 0.8, 0.24], [r * 0.74, 0.2], [r, 0.14], [r, 0]];
const profiles = {
  pawn: [[0, 1.02], [0.12, 0.98], [0.19, 0.86], [0.16, 0.74], [0.1, 0.68], [0.21, 0.64], [0.11, 0.58], ...foot(0.3)],
  rook: [[0.15, 1.02], [0.17, 1.12], [0.27, 1.12], [0.26, 0.9], [0.17, 0.84], [0.19, 0.42], ...foot(0.34)],
  bishop: [
    [0, 1.5], [0.06, 1.44], [0.04, 1.38], [0.15, 1.25], [0.19, 1.12], [0.12, 0.98], [0.23, 0.93], [0.11, 0.86],
    [0.15, 0.45], ...foot(0.34)
  ],
  queen: [
    [0, 1.78], [0.07, 1.72], [0.05, 1.64], [0.17, 1.62], [0.25, 1.66], [0.15, 1.28], [0.13, 1.18], [0.25, 1.12],
    [0.13, 1.04], [0.18, 0.5], ...foot(0.38)
  ],
  king: [
    [0, 1.72], [0.2, 1.68], [0.24, 1.6], [0.15, 1.28], [0.13, 1.18], [0.26, 1.12], [0.14, 1.04], [0.19, 0.5],
    ...foot(0.4)
  ],
};

function knight() {
  // The outline from the side: [z, y]; the nose looks along +z.
  const parts = [
    [[-0.2, 0.28], [0.2, 0.28], [0.14, 0.62], [-0.24, 0.78]],
    [[-0.24, 0.78], [0.14, 0.62], [0.13, 0.84], [-0.02, 1.24], [-0.16, 1.12]],
    [[0.13, 0.84], [0.32, 0.76], [0.4, 0.86], [0.16, 1.16], [-0.02, 1.24]],
  ];
  const head = parts.flatMap((outline) => placed(extruded(outline, 0.26, '#ffffff'), {at: [0, 0, -0.13]}))
                   .filter(({points: [p, q, r]}) => {
                     // Leaves out the faces where two parts meet.
                     const shared = [[[-0.24, 0.78], [0.14, 0.62]], [[0.13, 0.84], [-0.02, 1.24]]];
                     return !shared.some(
                         (ends) => [p, q, r].every(([x, y]) => ends.some(([a, b]) => Math.hypot(x - a, y - b) < 1e-6)));
                   });
  const ears = [-0.06, 0.06].flatMap((x) => placed(lathe([[0, 0.2], [0.055, 0], [0, 0]], 4), {at: [x, 1.16, -0.03]}));
  return [
    ...placed(head, {turn: [0, -90, 0]}), ...ears,
    ...lathe(foot(0.34).map(([r, y], i) => [r, i ? y : 0.28]).toSpliced(0, 0, [0, 0.3]), kSides)
  ];
}

const cross = [
  ...placed(box([0.07, 0.3, 0.07], '#ffffff'), {at: [0, 1.86, 0]}),
  ...placed(box([0.22, 0.08, 0.06], '#ffffff'), {at: [0, 1.88, 0]})
];
const pieces = {
  ...Object.fromEntries(Object.entries(profiles).map(([name, profile]) => [name, lathe(profile, kSides)])),
  knight: knight(),
};
pieces.king = [...pieces.king, ...cross];
for (const [name, faces] of Object.entries(pieces)) {
  const open = faces.filter(({points}) => !points.every(([, y]) => y < 1e-6));
  writeModel(`chess/${name}.glb`, {
    piece: occluded(
        welded(open, 62),
        {others: placed(box([3, 0.02, 3], '#ffffff'), {at: [0, -0.01, 0]}), reach: 0.7, dark: [0.35, 0.3, 0.35]})
  });
}

// The board: squares on top, whose texture repeats four times; a frame around it.
const square = (x0, z0, x1, z1, y) => [[x0, y, z1], [x1, y, z1], [x1, y, z0], [x0, y, z0]];
const board = [-4, -2, 0, 2].flatMap(
    (x) => [-4, -2, 0, 2].flatMap(
        (z) => polygon(square(x, z, x + 2, z + 2, 0), '#ffffff', [[0, 1], [1, 1], [1, 0], [0, 0]])));
writeModel('chess/squares.glb', {squares: welded(board)}, {texcoords: true});
const [kInner, kLine, kOuter] = [4, 4.12, 4.42];
const side = [
  ...polygon([[-kLine, 0.01, kLine], [kLine, 0.01, kLine], [kInner, 0, kInner], [-kInner, 0, kInner]], '#d6aa64'),
  ...polygon([[-kOuter, 0, kOuter], [kOuter, 0, kOuter], [kLine, 0.01, kLine], [-kLine, 0.01, kLine]], '#743e22'),
  ...polygon([[-kOuter, -0.4, kOuter], [kOuter, -0.4, kOuter], [kOuter, 0, kOuter], [-kOuter, 0, kOuter]], '#5c2e1a')
];
const rim = [0, 90, 180, 270].flatMap((turn) => placed(side, {turn: [0, turn, 0]}));
writeModel('chess/rim.glb', {rim: welded(rim, 10)});

// The pieces shade the board: there is a soft dark spot under each of them, where chess.toml puts it.
const scene = fs.readFileSync('chess.toml', 'utf8');
const places =
    [...scene.matchAll(/material = "(?:ivory|ebony)"\ntranslation = \[(.*)\]/g)].map(([, at]) => JSON.parse(`[${at}]`));
const r = 0.62;
writeModel(
    'chess/shade.glb', {
      shade: welded(places.flatMap(
          ([x, , z]) =>
              polygon(square(x - r, z - r, x + r, z + r, 0.012), '#ffffff', [[0, 1], [1, 1], [1, 0], [0, 0]])))
    },
    {texcoords: true});
writePicture('chess/shade.png', 16, 16, (u, v) => {
  const d = 2 * Math.hypot(u - 0.5, v - 0.5);
  return [0, 0, 0, 200 * Math.max(0, Math.min(1, 1.7 * (1 - d)))];
}, {alpha: true});

// Two light and two dark squares of wood; the grain runs along.
const grain = (u, v, seed) => {
  const wave = Math.sin(2 * Math.PI * (u * 5 + 0.35 * Math.sin(2 * Math.PI * v) + seed)) * 0.5 +
      Math.sin(2 * Math.PI * (u * 13 + 0.2 * Math.sin(2 * Math.PI * v + seed))) * 0.3;
  return wave * 0.5 + (random(Math.floor(u * 64) + 977 * seed) - 0.5) * 0.35;
};
writePicture('chess/squares.png', 64, 64, (u, v) => {
  const [i, j] = [Math.floor(2 * u), Math.floor(2 * v)], dark = (i + j) % 2 === 1;
  const g = grain(2 * u - i, 2 * v - j, i + 2 * j);
  return dark ? mix('#8a4a28', '#5c2c18', 0.5 + g) : mix('#f0d4a0', '#d8ae74', 0.5 + g);
});
