// Makes the models and textures of astronaut.toml. Public domain. Run: node astronaut.mjs
import {occluded, welded, writeModel} from './models.mjs';
import {writePicture} from './pictures.mjs';
import {ball, box, card, covered, grid, lathe, mix, placed, polygon, random, rgb, textured, tube} from './shapes.mjs';

const kSuit = '#f4f4f2', kGrey = '#8c94a4', kOrange = '#f08030', kDark = '#3c4250';

const kSides = 7;  // of a limb

// The figure looks along +z; its own left is +x.
function limb(path, radii, colours, across) {
  // Each piece has one colour; the end is closed.
  const faces = tube(path, radii, kSides, kSuit, across);
  return faces.map((f, i) => ({...f, colours: f.colours.map(() => rgb(colours[Math.floor(i / (2 * kSides))]))}));
}
const arm = (x) => limb(
    x > 0 ?
        [
          [0.4, 0.72, 0], [0.62, 0.7, 0.02], [0.84, 0.84, 0.08], [0.94, 1.1, 0.14], [0.97, 1.18, 0.15],
          [1.0, 1.36, 0.17], [1.01, 1.42, 0.17]
        ] :
        [
          [-0.4, 0.72, 0], [-0.6, 0.6, 0.05], [-0.74, 0.4, 0.18], [-0.66, 0.2, 0.4], [-0.64, 0.17, 0.46],
          [-0.58, 0.1, 0.6], [-0.56, 0.08, 0.65]
        ],
    [0.2, 0.2, 0.19, 0.16, 0.15, 0.15, 0], [kSuit, kSuit, kSuit, kOrange, kGrey, kGrey], [0, 0.2, 1]);
const leg = (x, bend) => limb(
    [
      [0.2 * x, 0.1, 0], [0.24 * x, -0.16, 0.06 + bend], [0.27 * x, -0.42, 0.02 + bend],
      [0.28 * x, -0.66, -0.14 - 0.2 * bend], [0.28 * x, -0.72, -0.16 - 0.2 * bend],
      [0.29 * x, -0.86, -0.12 - 0.2 * bend], [0.29 * x, -0.92, -0.06 - 0.2 * bend]
    ],
    [0.24, 0.23, 0.21, 0.19, 0.2, 0.22, 0], [kSuit, kSuit, kSuit, kOrange, kGrey, kGrey], [1, 0, 0]);
const torso =
    lathe([[0.36, 0.92], [0.44, 0.76], [0.42, 0.4], [0.4, 0.2], [0.3, 0.02], [0, -0.02]], 12, kSuit, {squash: 0.78});
// Bands around the torso have edges at their borders, which can be smoothed; an intersection could not.
const belt = lathe([[0.44, 0.29], [0.44, 0.18]], 12, kOrange, {squash: 0.8});
const collar = lathe([[0.44, 0.9], [0.44, 0.83]], 12, kGrey, {squash: 0.92});
const pack = [
  ...placed(box([0.74, 0.9, 0.3], '#d8dce4', 0.06), {at: [0, 0.56, -0.45]}),
  ...placed(box([0.2, 0.1, 0.1], kOrange), {at: [-0.2, 1.04, -0.45]})
];
const front = (size, colour) => covered(box(size, colour), ([, , z]) => z < 0);
const chest = [
  ...placed(box([0.36, 0.24, 0.1], '#c4cad4', 0.02), {at: [0, 0.58, 0.37]}),
  ...[[-0.1, '#e84838'], [0, '#f0c040'], [0.1, '#48b868']].flatMap(
      ([x, colour]) => placed(front([0.06, 0.06, 0.04], colour), {at: [x, 0.63, 0.42]})),
  ...placed(front([0.24, 0.05, 0.03], kDark), {at: [0, 0.53, 0.42]})
];
// The helmet is a ball with a hole, out of which the visor bulges.
const kHead = [0, 1.36, 0.02], kHelmet = 0.6;
const helmet =
    ball(kHelmet, 9, 14, kSuit)
        .filter(
            ({points}) => !points.every(([x, y, z]) => z > 0.15 && Math.hypot(x / 0.5, (y + 0.02) / 0.4) < 1) &&
                points.some(([, y]) => y > -0.53));
const outline =
    (cosine,
     sine) => [0.47 * cosine, 0.36 * sine - 0.02, Math.sqrt(kHelmet ** 2 - (0.47 * cosine) ** 2 - (0.36 * sine) ** 2)];
const rim = tube(Array.from({length: 14}, (_, i) => {
  const angle = 2 * Math.PI * i / 14;
  return outline(Math.cos(angle), Math.sin(angle));
}), 0.055, 6, kGrey, [0, 0, 1], true);
const ears = [1, -1].flatMap(
    (s) => placed(
        lathe([[0, 0.1], [0.13, 0.09], [0.16, 0], [0, 0]], 8, kOrange), {turn: [0, 0, -90 * s], at: [0.56 * s, 0, 0]}));
const head = placed([...helmet, ...rim, ...ears], {at: kHead});
const body = [
  ...torso, ...belt, ...collar, ...pack, ...chest, ...arm(1), ...arm(-1), ...leg(1, 0.16), ...leg(-1, 0.02), ...head
];
// The visor's border lies on the rim.
const visor =
    placed(grid(8, 6, (u, v) => {
             const [x, y] = [2 * u - 1, 2 * v - 1];
             const r = Math.max(Math.abs(x), Math.abs(y)), length = Math.hypot(x, y) || 1;
             const [cosine, sine] = [x / length, y / length], border = outline(cosine, sine)[2] + 0.06;
             const bulge = Math.sqrt(1 - 0.96 * r * r) - 0.2;
             return {point: [0.455 * cosine * r, 0.345 * sine * r - 0.02, border + (0.7 - border) * bulge / 0.8]};
           }), {at: kHead});
writeModel(
    'astronaut/suit.glb', {suit: occluded(welded(body, 75), {others: visor, reach: 0.7, dark: [0.34, 0.36, 0.46]})});
writeModel('astronaut/visor.glb', {visor: welded(visor, 80)}, {texcoords: false});

// The visor mirrors, as a ball would: the sky, the sun, the planet below, the astronaut's own arms.
writePicture('astronaut/visor.png', 32, 32, (u, v) => {
  const [x, y] = [2 * u - 1, 1 - 2 * v], r = Math.hypot(x, y);
  let colour = mix('#2a1c08', '#7a5210', Math.min(1, Math.max(0, 0.5 + 0.5 * y)));
  const limb = y - (-0.12 + 0.22 * Math.cos(2.2 * (x - 0.25)) - 0.3);
  if (limb < 0) {
    const cloud = Math.sin(9 * x + 4 * y) * Math.sin(7 * y - 5 * x + 1);
    colour = mix(mix('#f0c860', '#b07c28', Math.min(1, -limb * 2.2)), '#fff0c0', cloud > 0.35 ? 0.7 : 0);
  } else if (limb < 0.09)
    colour = mix('#fff2c8', colour, limb / 0.09);
  const sun = Math.hypot(x + 0.38, y - 0.42);
  colour = mix(colour, '#fffdf0', Math.max(0, Math.min(1, (0.17 - sun) * 14)));
  colour = mix(colour, '#ffe090', 0.6 * Math.max(0, 1 - sun * 1.7) ** 2);
  return mix(colour, '#0c0804', Math.max(0, Math.min(1, (r - 0.86) * 5)) * 0.75);
});

// The planet has seas, land and clouds that repeat after 180 degrees.
const noise = (u, v, n) => {
  const lattice = (i, j) => random(((i % n) + n) % n + 57 * j + 1000 * n), [x, y] = [u * n, v * n];
  const [i, j] = [Math.floor(x), Math.floor(y)], smooth = (t) => t * t * (3 - 2 * t),
            [fx, fy] = [smooth(x - i), smooth(y - j)];
  const row = (k) => lattice(i, k) * (1 - fx) + lattice(i + 1, k) * fx;
  return row(j) * (1 - fy) + row(j + 1) * fy;
};
writePicture('astronaut/planet.png', 64, 64, (u, v) => {
  const h = 0.55 * noise(u, v, 5) + 0.3 * noise(u, v, 10) + 0.15 * noise(u, v, 21),
        c = 0.6 * noise(u + 0.3, v, 7) + 0.4 * noise(u, v + 0.2, 16);
  let colour = h > 0.5 ? mix('#4c8a44', '#b8a468', (h - 0.5) * 7) : mix('#3c9ccc', '#1c509c', (0.5 - h) * 7);
  const pole = Math.abs(v - 0.5);
  if (pole > 0.42) colour = '#eef4fa';
  return mix(colour, '#ffffff', Math.max(0, Math.min(0.9, (c - 0.56) * 8)));
}, {samples: 2});
writeModel(
    'astronaut/planet.glb', {planet: welded(textured(ball(1, 10, 20), (p, [u, v]) => [2 * u, v]), 60)},
    {texcoords: true});
writeModel('astronaut/air.glb', {air: welded(card(1))}, {texcoords: true});
writePicture('astronaut/air.png', 16, 16, (u, v) => {
  const d = 2 * Math.hypot(u - 0.5, v - 0.5);
  return [110, 190, 255, 200 * Math.max(0, Math.min(1, (0.9 - d) * 3)) ** 1.6];
}, {alpha: true});

// The stars are small triangles on a wall behind everything.
writeModel('astronaut/stars.glb', {
  stars: welded(
      Array
          .from(
              {length: 48},
              (_, i) => {
                const [x, y, s] = [
                  14 * (random(3 * i) - 0.5), 14 * (random(3 * i + 1) - 0.5), 0.014 + 0.035 * random(3 * i + 2) ** 4
                ];
                return polygon(
                    [[x - s, y - s, 0], [x + s, y - s, 0], [x, y + s, 0]], mix('#8898c8', '#ffffff', random(i + 500)));
              })
          .flat(),
      90)
});
