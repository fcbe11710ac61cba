// Makes the models and textures of train.toml. Public domain. Run: node train.mjs
import fs from 'node:fs';

import {joined, occluded, welded, writeModel} from './models.mjs';
import {writePicture} from './pictures.mjs';
import {ball, box, card, covered, extruded, grid, lathe, mix, placed, polygon, random} from './shapes.mjs';

const kTrack = 2.3;  // radius of the track's middle
// Puts faces that look along +z onto the track, `degrees` from +z towards +x, in the direction of the train.
const onTrack = (faces, degrees, y = 0) =>
    placed(placed(faces, {turn: [0, 90, 0], at: [0, y, kTrack]}), {turn: [0, degrees, 0]});

// A block without its lower side, which stands on something.
const block = (size, colour, place) => placed(box(size, colour), place).filter((f) => {
  const [low, high] = [Math.min, Math.max].map((m) => m(...f.points.map((p) => p[1])));
  return high - low > 1e-6 || high > place.at[1];
});

// The ground: a round board of grass with a rim of wood and a pond.
const height = (r, angle) => 0.05 * Math.sin(3 * angle + 1) * Math.min(1, r) * (r < 1.6 ? 1 : 0);
const kPond = [0.75, 0.55];
const ground =
    lathe([[0, 0], [0.8, 0], [1.5, 0], [1.95, 0], [2.65, 0], [3.1, 0]], 22)
        .map((f) => ({...f, points: f.points.map(([x, , z]) => [x, height(Math.hypot(x, z), Math.atan2(x, z)), z])}))
        .map((f) => ({
               ...f,
               colours: f.points.map(([x, , z]) => {
                 const r = Math.hypot(x, z), own = random(Math.round(40 * x) * 91 + Math.round(40 * z));
                 return r > 1.9 && r < 2.7 ? mix('#b8a47c', '#a89470', own) : mix('#6fa648', '#8fbe58', own);
               })
             }));
const board = lathe([[3.1, 0], [3.22, -0.03], [3.2, -0.34]], 22, '#a8743f');
const pond = polygon(Array.from({length: 10}, (_, i) => {
  const angle = Math.PI * i / 5, r = 0.5 + 0.07 * Math.sin(2 * angle) + 0.05 * Math.cos(3 * angle);
  return [kPond[0] + 1.2 * r * Math.sin(angle), 0.075, kPond[1] + r * Math.cos(angle)];
}), '#58a4d8');
const shore = polygon(Array.from({length: 10}, (_, i) => {
  const angle = Math.PI * i / 5, r = 0.58 + 0.07 * Math.sin(2 * angle) + 0.05 * Math.cos(3 * angle);
  return [kPond[0] + 1.2 * r * Math.sin(angle), 0.06, kPond[1] + r * Math.cos(angle)];
}), '#d8c890');

// The hill at the back, and where the track goes through it.
const kHill = [0, -2.05];
const hill = grid(14, 4, (u, v, i, j) => {
  const angle = 2 * Math.PI * (i % 14) / 14, r = [1.25, 1.12, 0.82, 0.42, 0][j],
        rough = 1 + (j < 4 ? 0.12 * (random(i % 14 + 40 * j) - 0.5) : 0);
  const y = [0, 0.55, 1.0, 1.28, 1.38][j] * rough;
  return {
    point: [kHill[0] + 1.15 * r * Math.sin(angle) * rough, y, kHill[1] + 0.86 * r * Math.cos(angle) * rough],
    colour: j < 2 ? mix('#8f8478', '#74695e', random(i % 14 + 9 * j)) :
                    mix('#5c9440', '#7cae50', random(i % 14 + 9 * j))
  };
});
const arch = (w, h) => [
    [w, 0],
    ...Array.from({length: 5}, (_, k) => [w * Math.cos(Math.PI * k / 4), h - w + w * Math.sin(Math.PI * k / 4)]),
    [-w, 0]];
const portal = (out) => {
  const mouth = polygon(arch(0.3, 0.72).map(([x, y]) => [x, y, 0.002]), '#15120f');
  // Leaves out the sides that lie in the hill and on the ground.
  const stone = extruded(arch(0.42, 0.86), 0.3, '#a89c90').filter((f) => f.points.some(([, , z]) => z > 0));
  return placed(
      [...placed(covered(stone, ([, y]) => y === 0), {at: [0, 0, -0.3]}), ...mouth], {turn: [0, out ? 0 : 180, 0]});
};
const portals = [...onTrack(portal(true), 217), ...onTrack(portal(false), 143)];

// A house, a windmill's tower, trees, a fence of the station.
const gable = (w, h, d, roof) =>
    [...block([w, h, d], '#f4e6cc', {at: [0, h / 2, 0]}),
     ...polygon(
         [
           [-w * 0.58, h * 0.95, d * 0.62], [w * 0.58, h * 0.95, d * 0.62], [w * 0.58, h * 1.75, 0],
           [-w * 0.58, h * 1.75, 0]
         ],
         roof),
     ...polygon(
         [
           [w * 0.58, h * 0.95, -d * 0.62], [-w * 0.58, h * 0.95, -d * 0.62], [-w * 0.58, h * 1.75, 0],
           [w * 0.58, h * 1.75, 0]
         ],
         roof),
     ...polygon([[w / 2, h, d / 2], [w / 2, h, -d / 2], [w / 2, h * 1.66, 0]], '#f4e6cc'),
     ...polygon([[-w / 2, h, -d / 2], [-w / 2, h, d / 2], [-w / 2, h * 1.66, 0]], '#f4e6cc'),
];
const panes = (w, d, y) => [-0.28, 0, 0.28].flatMap(
    (x) => polygon(
        [[-0.05 + x * w, y, d], [0.05 + x * w, y, d], [0.05 + x * w, y + 0.12, d], [-0.05 + x * w, y + 0.12, d]],
        x ? '#3c5a78' : '#7a4a2c'));
const station = placed(
    [
      ...gable(0.9, 0.36, 0.5, '#c8503c'), ...panes(1, 0.256, 0.13),
      ...block([1.3, 0.08, 0.3], '#c4b8a8', {at: [0, 0.04, 0.45]})
    ],
    {at: [-0.55, 0.02, 1.05], turn: [0, -18, 0]});
const mill = placed(
    [
      ...lathe([[0, 0.95], [0.2, 0.74], [0.17, 0.72], [0.26, 0]], 8, ([, y]) => (y > 0.73 ? '#7c4630' : '#f0e8dc')),
      ...block([0.12, 0.2, 0.02], '#7a4a2c', {at: [0, 0.1, 0.245]})
    ],
    {at: [-0.95, 0, -0.45], turn: [0, 20, 0]});
// Trees stand where train.toml puts them.
const fir = [
  ...placed(lathe([[0, 0.5], [0.2, 0.06]], 6, '#4a9050'), {at: [0, 0.32, 0]}),
  ...placed(lathe([[0, 0.44], [0.26, 0]], 6, '#3a7a44'), {at: [0, 0.12, 0]}),
  ...lathe([[0.05, 0.14], [0.05, 0]], 3, '#6c4a30')
];
const leafy = [
  ...placed(ball(0.25, 4, 6, ([, y]) => mix('#5c9c3c', '#9ccc5c', 0.5 + 2 * y)), {at: [0, 0.47, 0]}),
  ...lathe([[0.045, 0.3], [0.045, 0]], 3, '#7a5234')
];
const trees = [
  ...fs.readFileSync('train.toml', 'utf8').matchAll(/model = "(fir|leafy)"\ntranslation = (\[.*\])\nscale = (.*)/g)
].flatMap(([, name, at, scale]) => placed(name === 'fir' ? fir : leafy, {at: JSON.parse(at), scale: Number(scale)}));
writeModel('train/fir.glb', {fir: occluded(welded(fir, 70), {reach: 0.5})});
writeModel('train/leafy.glb', {leafy: occluded(welded(leafy, 70), {reach: 0.5})});
const land = [...ground, ...board, ...shore, ...pond, ...hill, ...portals, ...station, ...mill];
writeModel('train/land.glb', {land: occluded(welded(land, 42), {others: trees, reach: 0.9, dark: [0.36, 0.34, 0.44]})});

// Sails of the mill, around the origin.
writeModel('train/sails.glb', {
  sails: welded([0, 90, 180, 270].flatMap(
      (turn) => placed(
          polygon([[-0.02, 0.02, 0], [0.02, 0.02, 0], [0.09, 0.14, 0], [0.09, 0.54, 0], [-0.02, 0.54, 0]], '#fff6e0'),
          {turn: [0, 0, turn]})))
});

// The track: sleepers and rails are texels, once for each of kSleepers.
const kSleepers = 40, kPieces = 32;
writeModel(
    'train/track.glb', {
      track: welded(
          grid(
              kPieces, 1,
              (u, v, i, j) => {
                const angle = 2 * Math.PI * (i % kPieces) / kPieces, r = j ? kTrack - 0.27 : kTrack + 0.27;
                return {
                  point: [r * Math.sin(angle), 0.025, r * Math.cos(angle)],
                  texcoord: [i * kSleepers / kPieces, j]
                };
              }),
          80)
    },
    {texcoords: true});
writePicture('train/track.png', 16, 32, (u, v) => {
  const rail = Math.abs(Math.abs(v - 0.5) - 0.27);
  if (rail < 0.035) return [206, 208, 214];
  if (rail < 0.06) return [96, 90, 90];
  if (Math.abs(u - 0.5) < 0.22 && Math.abs(v - 0.5) < 0.44)
    return mix('#6e4a2e', '#8a6240', random(Math.floor(v * 16)));
  return mix('#a4947a', '#c0b090', random(Math.floor(u * 16) + 16 * Math.floor(v * 32)));
});

// The train. Each car looks along +z.
// Wheels have only their outer side, which is the one that is seen.
const wheel = (x, z, r) => placed(
    polygon(
        Array.from({length: 7}, (_, i) => [r * Math.cos(2 * Math.PI * i / 7), r * Math.sin(2 * Math.PI * i / 7), 0]),
        '#4a4a54'),
    {turn: [0, x > 0 ? 90 : -90, 0], at: [x, r, z]});
const wheels = (zs, r = 0.085) => zs.flatMap((z) => [...wheel(0.185, z, r), ...wheel(-0.185, z, r)]);
const above = (bottom) => ([, y]) => y > bottom;
const engine = [
  ...wheels([-0.28, -0.06, 0.18], 0.1),
  ...block([0.32, 0.08, 0.86], '#44444e', {at: [0, 0.15, 0]}),
  ...placed(
      lathe([[0, 0.54], [0.15, 0.54], [0.15, 0.46], [0.15, 0]], 8, ([, y]) => (y > 0.45 ? '#44444e' : '#38a878')),
      {turn: [90, 0, 0], at: [0, 0.33, -0.1]}),
  ...covered(block([0.36, 0.36, 0.3], '#e85040', {at: [0, 0.36, -0.26]}), above(0.53)),
  ...block([0.42, 0.04, 0.38], '#44444e', {at: [0, 0.56, -0.26]}),
  ...polygon([[0.182, 0.4, -0.16], [0.182, 0.4, -0.36], [0.182, 0.5, -0.36], [0.182, 0.5, -0.16]], '#bfe0f0'),
  ...polygon([[-0.182, 0.4, -0.36], [-0.182, 0.4, -0.16], [-0.182, 0.5, -0.16], [-0.182, 0.5, -0.36]], '#bfe0f0'),
  ...placed(lathe([[0, 0.22], [0.085, 0.22], [0.05, 0.1], [0.05, 0]], 6, '#44444e'), {at: [0, 0.45, 0.32]}),
  ...placed(lathe([[0, 0.1], [0.06, 0.05], [0.06, 0]], 5, '#e0b040'), {at: [0, 0.47, 0.1]}),
  ...block([0.36, 0.1, 0.05], '#e85040', {at: [0, 0.15, 0.44]}),
  ...placed(lathe([[0, 0.03], [0.05, 0]], 5, '#fff4c0'), {turn: [90, 0, 0], at: [0, 0.4, 0.44]}),
];
const wagon = (side, load) =>
    [...wheels([-0.18, 0.18]),
     ...block([0.36, 0.07, 0.6], '#44444e', {at: [0, 0.15, 0]}),
     ...block([0.38, 0.2, 0.58], side, {at: [0, 0.27, 0]}),
     ...load,
     ...covered(block([0.06, 0.05, 0.16], '#44444e', {at: [0, 0.15, 0.36]}), ([, , z]) => z < 0.29),
];
const coal = placed(
    lathe([[0, 0.13], [0.1, 0.1], [0.19, 0]], 7, ([x, y]) => mix('#3a363c', '#66606c', random(Math.round(99 * x)) + y)),
    {at: [0, 0.37, 0], scale: [0.9, 1, 1.4]});
const logs = [[-0.09, 0.43], [0.09, 0.43], [0, 0.56]].flatMap(
    ([x, y]) => placed(
        lathe(
            [[0, 0.27], [0.085, 0.27], [0.085, -0.27], [0, -0.27]], 6,
            ([a, , c]) => (Math.hypot(a, c) < 0.05 ? '#e8c890' : '#a87848')),
        {turn: [90, 0, 0], at: [x, y, 0]}));
const coach =
    [
      ...covered(block([0.38, 0.2, 0.58], '#f0e0b0', {at: [0, 0.45, 0]}), above(0.54)),
      ...block([0.44, 0.04, 0.66], '#5a6478', {at: [0, 0.57, 0]}),
      ...[1, -1].flatMap(
          (s) => [-0.18, 0, 0.18].flatMap(
              (z) =>
                  polygon(
                      [
                        [0.192 * s, 0.4, z + 0.06 * s], [0.192 * s, 0.4, z - 0.06 * s], [0.192 * s, 0.5, z - 0.06 * s],
                        [0.192 * s, 0.5, z + 0.06 * s]
                      ],
                      '#4a7088')))
    ];
const cars =
    [[engine, 0], [wagon('#3c78b8', coal), -21], [wagon('#e0a030', logs), -40], [wagon('#b84848', coach), -59]];
const shades = cars.flatMap(
    ([, degrees], i) => onTrack(
        polygon(
            [[-0.24, 0, 0.4], [0.24, 0, 0.4], [0.24, 0, -0.4], [-0.24, 0, -0.4]].map(
                ([x, y, z]) => [x, y, i ? z * 0.82 : z]),
            '#54463a'),
        degrees, 0.035));
const floor = box([9, 0.02, 9], '#000000');
const train = occluded(
    welded(cars.flatMap(([car, degrees]) => onTrack(car, degrees, 0.03)), 62),
    {others: floor, reach: 0.4, dark: [0.5, 0.5, 0.56]});
writeModel('train/train.glb', {train: joined(train, welded(shades))});
// A puff of smoke.
writeModel('train/puff.glb', {puff: welded(card(1))}, {texcoords: true});
writePicture('train/puff.png', 16, 16, (u, v) => {
  const d = 2 * Math.hypot(u - 0.5, v - 0.5);
  return [255, 255, 255, 235 * Math.max(0, Math.min(1, 2.2 * (1 - d)))];
}, {alpha: true});
