// Makes the models and textures of lighthouse.toml. Public domain. Run: node lighthouse.mjs
import {occluded, welded, writeModel} from './models.mjs';
import {writePicture} from './pictures.mjs';
import {ball, box, card, covered, cylinder, grid, lathe, mix, placed, polygon, random, rgb, scaled} from './shapes.mjs';

// The island: rings of rock around grass, uneven; longer from side to side.
const kStretch = 1.25;
const coast = (angle) => 2.15 + 0.25 * Math.sin(3 * angle + 1) + 0.16 * Math.sin(5 * angle);
const ground = (x, z) => {
  const t = Math.hypot(x / kStretch, z) / coast(Math.atan2(z, x));
  return t < 0.45 ? 0.95 : t < 0.8 ? 0.95 - (t - 0.45) * 1.1 : 0.565 - (t - 0.8) * 4;
};
const around = (i, r) => {
  const angle = 2 * Math.PI * (i % 18) / 18;
  return [kStretch * r * Math.cos(angle), -r * Math.sin(angle)];
};
const coastAt = (i) => coast(-2 * Math.PI * (i % 18) / 18);
const island = grid(18, 5, (u, v, i, j) => {
  const rough = j < 4 ? 0.16 * (random(i % 18 + 31 * j) - 0.5) : 0;
  const [x, z] = around(i, coastAt(i) * [1.02, 0.86, 0.7, 0.5, 0.3, 0][j] * (1 + rough));
  const y = ground(x, z) + (j > 0 ? rough : -0.25);
  const grass = mix('#5d7a3c', '#7c9448', random(7 * i + j)), rock = mix('#66544e', '#b09684', random(i % 18 + 5 * j));
  return {point: [x, y, z], colour: j <= 1 ? mix('#453a3c', rock, 0.7 * j) : j === 2 ? rock : grass};
});
const kLowest = -0.11;  // of the waves
const stone = (at, size, seed) => covered(
    placed(ball(1, 3, 5, mix('#6a5a54', '#8d7a6c', random(seed))), {at, turn: [40 * seed, 70 * seed, 0], scale: size}),
    ([, y]) => y < kLowest);
const rocks = [
  [[2.9, 0.02, 1.1], [0.32, 0.28, 0.3], 1], [[3.35, -0.02, 0.7], [0.2, 0.16, 0.22], 2],
  [[-2.8, 0, 1.3], [0.36, 0.25, 0.3], 3], [[-1.9, 0.05, 2.05], [0.24, 0.26, 0.22], 4],
  [[1.2, 0.02, 2.3], [0.26, 0.2, 0.2], 5]
].flatMap((r) => stone(...r));

// The tower: bands, a gallery with a rail, the lantern's roof.
const tower = [];
const radius = (t) => 0.5 - 0.2 * t;
const kSides = 10, kBands = 5, kHeight = 2.5;
for (let band = 0; band < kBands; ++band) {
  const [low, high] = [band / kBands, (band + 1) / kBands];
  tower.push(...lathe(
      [[radius(high), kHeight * high], [radius(low), kHeight * low]], kSides, band % 2 ? '#c8402c' : '#f4ece0'));
}
tower.push(...lathe(
    [[0.3, kHeight], [0.44, kHeight + 0.02], [0.44, kHeight - 0.05], [0.3, kHeight - 0.16]], kSides, '#3c3a44'));
tower.push(...lathe(
    [[0.425, kHeight + 0.2], [0.445, kHeight + 0.2], [0.445, kHeight + 0.17], [0.425, kHeight + 0.17]], kSides,
    '#3c3a44'));
for (let post = 0; post < 6; ++post) {
  const bar = placed(lathe([[0.016, 0.18], [0.016, 0]], 3, '#3c3a44'), {at: [0.43, kHeight + 0.02, 0]});
  tower.push(...placed(bar, {turn: [0, 60 * post, 0]}));
}
tower.push(...placed(
    lathe([[0, 0.5], [0.05, 0.42], [0.05, 0.36], [0.3, 0.1], [0.3, 0.05], [0, 0.05]], kSides, '#b03424'),
    {at: [0, kHeight + 0.3, 0]}));

tower.push(...placed(box([0.2, 0.34, 0.06], '#5a3826'), {at: [0.1, 0.17, 0.48], turn: [0, 12, 0]}));

// The keeper's house.
const house = [
  ...placed(box([0.9, 0.42, 0.6], '#f0e4d0'), {at: [0, 0.21, 0]}),
  ...polygon([[-0.52, 0.4, 0.36], [0.52, 0.4, 0.36], [0.52, 0.74, 0], [-0.52, 0.74, 0]], '#9c4a34'),
  ...polygon([[0.52, 0.4, -0.36], [-0.52, 0.4, -0.36], [-0.52, 0.74, 0], [0.52, 0.74, 0]], '#9c4a34'),
  ...polygon([[0.45, 0.42, 0.3], [0.45, 0.42, -0.3], [0.45, 0.7, 0]], '#e8dac4'),
  ...polygon([[-0.45, 0.42, -0.3], [-0.45, 0.42, 0.3], [-0.45, 0.7, 0]], '#e8dac4'),
  ...polygon([[-0.52, 0.4, -0.36], [0.52, 0.4, -0.36], [0.52, 0.4, 0.36], [-0.52, 0.4, 0.36]], '#6a3424'),
  ...placed(box([0.12, 0.3, 0.12], '#8a5a48'), {at: [-0.22, 0.72, -0.08]}),
];
const atHouse = {
  at: [1.15, 0.86, 0.2],
  turn: [0, -18, 0]
};
const base = 0.9;
const below = (top) => ([, y]) => y < top;
const tree = (x, z, s) => placed(
    [
      ...placed(covered(lathe([[0, 0.62], [0.2, 0.1], [0, 0.14]], 6, '#3f6340'), below(0.15)), {at: [0, 0.2, 0]}),
      ...placed(covered(lathe([[0, 0.5], [0.26, 0], [0, 0.05]], 6, '#355638'), below(0.06)), {at: [0, 0.1, 0]}),
      ...cylinder(0.05, 0.16, 4, '#5c4030').filter((f) => f.points.some((p) => p[1] < 0.1))
    ],
    {at: [x, ground(x, z) - 0.02, z], scale: s});
const land = [
  ...island, ...rocks, ...placed(tower, {at: [0, base, 0]}), ...placed(house, atHouse), ...tree(-1.25, 0.15, 1),
  ...tree(-1.65, -0.35, 0.8), ...tree(-0.95, -0.6, 1.1), ...tree(1.9, -0.55, 0.9)
];
writeModel('lighthouse/land.glb', {land: occluded(welded(land, 46), {reach: 1.2, dark: [0.4, 0.36, 0.46]})});

// The lantern and the windows shine.
const pane = (at) => placed(placed(scaled(card(1, '#ffd27a'), [0.07, 0.08, 1]), {at}), atHouse);
const towerPane = (y) => placed(
    scaled(card(1, '#ffc468'), [0.06, 0.085, 1]),
    {at: [0, base + y + 0.085, radius((y + 0.05) / kHeight) + 0.004], turn: [-4, 0, 0]});
writeModel('lighthouse/shining.glb', {
  shining: welded([
    ...placed(
        lathe([[0.2, 0.36], [0.2, 0]], 10, ([, y]) => (y > 0.1 ? '#fff6c8' : '#ffdf8a')), {at: [0, base + kHeight, 0]}),
    ...[0.95, 1.7].flatMap(towerPane), ...pane([-0.22, 0.24, 0.306]), ...pane([0.2, 0.24, 0.306])
  ])
});

// There are two beams of two crossed sheets each. Their alpha fades along the beam and to its sides.
const sheet = (turn) => placed(
    polygon(
        [[0.1, -0.08, 0], [4.6, -0.75, 0], [4.6, 0.75, 0], [0.1, 0.08, 0]], '#ffffff',
        [[0.02, 1], [0.98, 1], [0.98, 0], [0.02, 0]]),
    {turn: [turn, 0, 0]});
const half = [...sheet(0), ...sheet(90)];
writeModel('lighthouse/beam.glb', {beam: welded([...half, ...placed(half, {turn: [0, 180, 0]})])}, {texcoords: true});
writePicture('lighthouse/beam.png', 32, 16, (u, v) => {
  const side = Math.abs(2 * v - 1);
  return [255, 236, 170, 215 * (1 - u) ** 1.3 * (1 - side ** 1.5)];
}, {alpha: true});
writeModel('lighthouse/glow.glb', {glow: welded(card(1))}, {texcoords: true});
writePicture('lighthouse/glow.png', 16, 16, (u, v) => {
  const d = Math.min(1, 2 * Math.hypot(u - 0.5, v - 0.5));
  return [255, 240, 190, 255 * Math.min(1, (1 - d) ** 2.2 * 1.25)];
}, {alpha: true});

// The sea: waves that repeat every kPeriod, rows that are longer the farther they are.
const kPeriod = 6;
const rows = [8, 6.2, 5.2, 4.4, 3.7, 3, 2.3, 1.5, 0.5, -1, -3, -5.5, -9, -19];
const columns = 18;
const height = (x, z) => {
  const wave = (a, b, shift) => Math.sin(2 * Math.PI * (a * x / kPeriod + b * z / 5 + shift));
  return Math.min(1, Math.max(0, (z + 9) / 10)) * (0.06 * wave(1, 0.9, 0) + 0.05 * wave(-1, 1.4, 0.3));
};
// The colours contain light and reflections of the sky, because waves move without changing their shape.
const sea = grid(columns, rows.length - 1, (u, v, i, j) => {
  const x = (i - columns / 2) * 1.5, z = rows[j], y = height(x, z),
        slope = (height(x + 0.2, z) - height(x - 0.2, z)) / 0.4;
  const towards = (height(x, z + 0.2) - height(x, z - 0.2)) / 0.4,
        glint = Math.min(1, Math.max(0, 0.3 + 5 * slope - 3 * towards));
  return {point: [x, y, z], colour: mix(mix('#24406c', '#3f6a94', 0.5 + 8 * y), '#e8a088', 0.55 * glint ** 2)};
});
const foam = grid(18, 1, (u, v, i, j) => {
  const [x, z] = around(i, (coastAt(i) + 0.15) * (j ? 0.94 : 1.06 + 0.07 * random(i % 18)));
  return {point: [x, j ? 0.1 : 0.07, z], colour: j ? '#d8ccd4' : '#8c9cb4'};
});
writeModel('lighthouse/sea.glb', {sea: welded(sea, 90)});
writeModel('lighthouse/foam.glb', {foam: welded(foam, 90)});

// The sky, behind everything: colours are those before fog, which is haze of colour kHaze (lighthouse.toml) there.
const kHaze = rgb('#e09a86'), kThere = 0.42;
const sky = [
  ['#e09a86', -0.8], ['#e8a487', 0.3], ['#dd8f8c', 1.6], ['#a8789c', 3.6], ['#665c98', 6.2], ['#644480', 9.5],
  ['#64386e', 13]
];
const before = (colour) =>
    rgb(colour).map((c, i) => Math.min(255, Math.max(0, (c - kThere * kHaze[i]) / (1 - kThere))));
writeModel('lighthouse/sky.glb', {
  sky:
      welded(grid(1, sky.length - 1, (u, v, i, j) => ({point: [u * 30 - 15, sky[j][1], 0], colour: before(sky[j][0])})))
});
// Islands far away.
const ridge = (x, width, height, seed) =>
    Array
        .from(
            {length: 6},
            (_, i) => {
              const top = (k) => height * Math.sin(Math.PI * k / 6) * (0.7 + 0.5 * random(seed + k));
              const at = (k) => x + width * (k / 6 - 0.5);
              return polygon(
                  [[at(i), -0.1, 0], [at(i + 1), -0.1, 0], [at(i + 1), top(i + 1), 0], [at(i), top(i), 0]], '#564668');
            })
        .flat();
writeModel('lighthouse/hills.glb', {hills: welded([...ridge(-4.6, 5.5, 1.0, 3), ...ridge(5.2, 4.5, 0.7, 11)], 10)});
