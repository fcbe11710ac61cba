// Makes the models and pictures of home.toml. Public domain. Run: node home.mjs
import {lit, tracer} from './light.mjs';
import {joined, welded, writeModel} from './models.mjs';
import {writePicture} from './pictures.mjs';
import {add, ball, box, covered, cross, dot, grid, lathe, minus, mix, placed, polygon, rgb, times, tube, unit} from './shapes.mjs';

// The room: x and z from -kHalf to kHalf, +y up; walls behind, at x = -kHalf and z = -kHalf; the eye looks from +x, +z.
const kHalf = 2, kTall = 2.3, kThick = 0.14, kSlab = 0.2;
const kWood = '#b9835a', kDarkWood = '#7a4f36', kTeal = '#2f8f8a', kCream = '#f2e6d0', kMetal = '#3a3f4a';
const kLamp = [-1.55, 1.72, -1.5], kRug = [0.4, 0, 0.6], kFan = [1.45, 0, -1.35];

const rect = ([x0, y0, z0], [x1, y1, z1], colour) => {
  if (x0 === x1) return polygon([[x0, y0, z1], [x0, y0, z0], [x0, y1, z0], [x0, y1, z1]], colour);
  if (y0 === y1) return polygon([[x0, y0, z1], [x1, y0, z1], [x1, y0, z0], [x0, y0, z0]], colour);
  return polygon([[x0, y0, z0], [x1, y0, z0], [x1, y1, z0], [x0, y1, z0]], colour);
};
const at = (faces, ...place) => placed(faces, {at: place});
// Leaves out the faces on which a thing stands.
const standing = (faces, low = 0.011) => covered(faces, ([, y]) => y < low);

// The sofa stands at the left wall and looks along +x.
const sofa =
    at(
        [
          ...standing(at(box([0.96, 0.3, 2.34], '#276f70'), 0, 0.2, 0), 0.11),
          ...at(box([0.26, 0.62, 2.1], kTeal, 0.07), -0.36, 0.55, 0),
          ...[-1, 1].flatMap((s) => at(box([0.9, 0.5, 0.22], kTeal, 0.07), 0.02, 0.36, 1.05 * s)),
          ...[-1, 1].flatMap((s) => at(box([0.66, 0.17, 0.92], '#3aa39b', 0.05), 0.1, 0.42, 0.47 * s)),
          ...[-1, 1].flatMap(
              (s) => placed(box([0.16, 0.4, 0.86], '#37a098', 0.05), {at: [-0.17, 0.66, 0.47 * s], turn: [0, 0, 12]})),
          ...placed(box([0.14, 0.36, 0.38], '#f0b440', 0.06), {at: [-0.02, 0.66, -0.66], turn: [0, -14, 18]}),
        ],
        -1.46, 0, 0.25);
const fur = '#e8955a', pale = '#fbe3c8';
const cat =
    at(
        [
          ...placed(ball(0.19, 5, 8, fur), {scale: [1, 0.72, 1.4]}),
          ...at(ball(0.125, 5, 7, ([x, y]) => (y < -0.01 && x > 0.04 ? pale : fur)), 0.11, 0.09, 0.2),
          ...[-1, 1].flatMap(
              (s) => placed(
                  lathe([[0, 0.13], [0.062, 0]], 4, '#c8682c'),
                  {at: [0.11 - 0.06 * s, 0.17, 0.2 + 0.06 * s], turn: [16 * s, 0, 16 * s]})),
          ...tube(
              [[-0.02, -0.07, -0.25], [0.14, -0.08, -0.24], [0.22, -0.08, -0.1], [0.22, -0.08, 0.04]],
              [0.05, 0.055, 0.05, 0.03], 4, pale, [0, 1, 0]),
        ],
        -1.3, 0.64, 0.6);

const lampStand = at(
    [
      ...standing(lathe([[0, 0.05], [0.21, 0]], 10, kMetal)),
      ...lathe([[0.022, 1.6], [0.022, 0.052]], 4, '#c8a060'),
    ],
    kLamp[0], 0, kLamp[2]);
const shade =
    at(lathe([[0, 0.21, '#fff6dc'], [0.17, 0.21, '#fff2cc'], [0.22, 0, '#ffe6ae'], [0.27, -0.2, '#ffd488']], 11),
       ...kLamp);

// The sideboard below the window, and what is on it.
const sideboard =
    at(
        [
          ...covered(at(box([1.9, 0.46, 0.46], kWood, 0.025), 0, 0.41, 0), ([, y, z]) => z < -0.2 || y < 0.19),
          ...[-0.84, 0.84].flatMap(
              (x) => [-0.15, 0.17].flatMap(
                  (z) => standing(at(lathe([[0.035, 0.2], [0.02, 0]], 4, kDarkWood), x, 0, z)))),
          ...[-0.31, 0.31].flatMap((x) => rect([x - 0.008, 0.21, 0.233], [x + 0.008, 0.61, 0.233], '#5d3c28')),
          ...[-0.37, 0.25, 0.37].flatMap((x) => rect([x - 0.018, 0.4, 0.236], [x + 0.018, 0.44, 0.236], '#f0d8a0')),
        ],
        -0.05, 0, -1.74);
const top = 0.64;
const books = [['#d8553f', 0.3, 0.06], ['#3f68b8', 0.26, 0.05], ['#f0e4cc', 0.28, 0.05]].flatMap(
    ([colour, wide, high], i) =>
        placed(box([wide, high, 0.22], colour), {at: [-0.62, top + 0.03 + 0.056 * i, -1.72], turn: [0, 9 * i - 6, 0]}));
const speaker =
    at(lathe([[0, 0.25, '#5a6474'], [0.08, 0.25, '#7fe8ff'], [0.09, 0.22, '#454d5c'], [0.1, 0, '#39404e']], 9), 0.62,
       top, -1.7);
const leaf = (tall, wide, bend, turn, colour) => placed(
    grid(2, 2, (u, v) => ({
                 point: [
                   (1 - 2 * u) * wide * Math.sin(Math.PI * (0.16 + 0.84 * v)),
                   tall * Math.sin(1.1 * v + 0.1) - (u === 0.5 ? 0.03 : 0), bend * v * v + 0.02
                 ],
                 colour: mix(colour, '#d8f08c', 0.32 * v + (u < 0.5 ? 0.14 : 0))
               })),
    {turn: [0, turn, 0]});
const plant = (leaves, tall, wide, bend) => Array
                                                .from(
                                                    {length: leaves},
                                                    (_, i) => leaf(
                                                        tall * (0.72 + 0.28 * ((i * 5) % 3) / 2), wide, bend,
                                                        360 * i / leaves + 20, i % 2 ? '#2f8a48' : '#3ea052'))
                                                .flat();
const pot = (r, colour) =>
    lathe([[0, 1.56 * r, '#4a3428'], [0.86 * r, 1.56 * r, '#4a3428'], [r, 1.62 * r], [0.76 * r, 0]], 9, colour);
const bigPlant = at([...standing(pot(0.22, '#e8e0d4')), ...at(plant(9, 0.8, 0.17, 0.42), 0, 0.33, 0)], -1.56, 0, 1.66);
const smallPlant = at([...pot(0.095, '#e07850'), ...at(plant(5, 0.3, 0.055, 0.17), 0, 0.14, 0)], 0.18, top, -1.72);

const table =
    at(
        [
          ...lathe([[0, 0.4], [0.41, 0.4], [0.42, 0.36]], 16, '#d09a68'),
          ...[90, 210, 330].flatMap((a) => standing(placed(lathe([[0.03, 0.36], [0.022, 0]], 4, kDarkWood), {
                                      at: [0.27 * Math.sin(a * Math.PI / 180), 0, 0.27 * Math.cos(a * Math.PI / 180)]
                                    }))),
          ...at(
              lathe(
                  [[0, 0.12, '#6a3c24'], [0.05, 0.12, '#6a3c24'], [0.065, 0.13, '#ffffff'], [0.062, 0.002]], 6,
                  '#f6f6f6'),
              0.14, 0.4, 0.12),
          ...placed(box([0.3, 0.035, 0.22], '#f0b440'), {at: [-0.12, 0.418, -0.08], turn: [0, 28, 0]}),
        ],
        kRug[0], 0, kRug[2]);

// The fan looks into the room; its blades are a model of their own.
const kFacing = {
  turn: [0, -8, 0]
},
      kHub = 1.12;
const fan = at(
    [
      ...standing(lathe([[0, 0.07], [0.05, 0.07], [0.23, 0.02]], 12, '#e8ecf0')),
      ...lathe([[0.028, 0.99], [0.032, 0.075]], 4, '#dfe4ea'),
      ...placed(
          [
            ...placed(
                lathe([[0, 0.1], [0.09, 0.1], [0.07, -0.18], [0, -0.18]], 7, '#e8ecf0'),
                {turn: [90, 0, 0], at: [0, kHub, -0.02]}),
            ...placed(
                lathe([[0.385, 0.01], [0.42, 0.045], [0.445, -0.02]], 18, '#f4f6f8'),
                {turn: [90, 0, 0], at: [0, kHub, 0.1]}),
          ],
          kFacing),
    ],
    ...kFan);
const blade = (i) => placed(grid(2, 2, (u, v) => {
                              const angle = (-34 + 62 * u) * (0.55 + 0.45 * v) * Math.PI / 180,
                                    r = 0.06 + 0.32 * v ** 0.9;
                              return {
                                point: [r * Math.sin(angle), r * Math.cos(angle), 0.05 - 0.1 * u],
                                colour: mix('#46b8d8', '#a8ecff', 0.25 + 0.65 * v)
                              };
                            }), {turn: [0, 0, 120 * i]});
const rotor = placed(
    [
      ...blade(0), ...blade(1), ...blade(2),
      ...placed(lathe([[0, 0.13], [0.07, 0.07]], 7, '#ffffff'), {turn: [90, 0, 0]})
    ],
    kFacing);

// The window, the curtains and the pictures hang at the walls.
const kWindow = {
  left: -0.72,
  right: 0.72,
  low: 0.98,
  high: 1.98
};
const wz = -kHalf,
      bar = (x0, x1, y0, y1, deep = 0.06) =>
          at(box([x1 - x0, y1 - y0, deep], '#f4efe6'), (x0 + x1) / 2, (y0 + y1) / 2, wz + deep / 2);
const {left, right, low, high} = kWindow;
const frame = [
  ...bar(left - 0.05, left, low, high),
  ...bar(right, right + 0.05, low, high),
  ...bar(-0.022, 0.022, low, high, 0.05),
  ...bar(left, right, high, high + 0.05),
  ...bar(left - 0.1, right + 0.1, low - 0.06, low, 0.14),
  ...bar(left, right, 1.46, 1.5, 0.045),
];
const curtain = (x0, x1) => grid(8, 1, (u, v, i) => ({
                                         point: [x0 + (x1 - x0) * u, 0.72 + 1.4 * v, wz + 0.1 + (i % 2 ? 0.07 : 0)],
                                         colour: '#f4c4a8',
                                       }));
const rail = placed(lathe([[0.02, 1.05], [0.02, -1.05]], 4, '#c8a060'), {turn: [0, 0, 90], at: [0, 2.12, wz + 0.12]});
const picture = (z, y, wide, tall, colours) => {
  const x = -kHalf,
        card = (inset, lift, colour) => rect(
            [x + lift, y - tall / 2 + inset, z - wide / 2 + inset],
            [x + lift, y + tall / 2 - inset, z + wide / 2 - inset], colour);
  return [
    ...at(box([0.05, tall, wide], '#3a2c28'), x + 0.025, y, z), ...card(0.04, 0.052, colours[0]),
    ...card(0.04, 0.052, colours[0]).slice(0, 0)
  ];
};
const disc = (x, y, z, r, colour, sides = 11, from = 0, to = 360) => polygon(Array.from({length: sides}, (_, i) => {
  const a = (from + (to - from) * i / (to - from === 360 ? sides : sides - 1)) * Math.PI / 180;
  return [x, y + r * Math.sin(a), z - r * Math.cos(a)];
}), colour);
const art = [
  ...picture(-0.35, 1.5, 0.56, 0.72, ['#f6ead2']),
  ...disc(-kHalf + 0.056, 1.6, -0.35, 0.15, '#f08a4c'),
  ...disc(-kHalf + 0.058, 1.26, -0.27, 0.17, '#2f6f8a', 10, 0, 180),
  ...disc(-kHalf + 0.06, 1.26, -0.46, 0.11, '#4fa39a', 10, 0, 180),
  ...picture(0.6, 1.5, 0.72, 0.56, ['#23406a']),
  ...disc(-kHalf + 0.056, 1.58, 0.72, 0.09, '#fff0c0'),
  ...polygon([[-kHalf + 0.058, 1.26, 0.92], [-kHalf + 0.058, 1.26, 0.44], [-kHalf + 0.058, 1.52, 0.66]], '#6f8fb8'),
  ...polygon([[-kHalf + 0.06, 1.26, 0.7], [-kHalf + 0.06, 1.26, 0.28], [-kHalf + 0.06, 1.44, 0.46]], '#a8c0d8'),
];
const standingThings =
    [...sofa, ...cat, ...lampStand, ...sideboard, ...books, ...speaker, ...bigPlant, ...smallPlant, ...table, ...fan];
const things = [...standingThings, ...frame, ...curtain(-1.12, -0.7), ...curtain(0.7, 1.12), ...rail, ...art];
const shell = [
  ...rect([-kHalf, 0, -kHalf], [kHalf, 0, kHalf], '#000000'),
  ...rect([-kHalf, 0, -kHalf], [-kHalf, kTall, kHalf], '#000000'),
  ...rect([-kHalf, 0, -kHalf], [kHalf, kTall, -kHalf], '#000000')
];

// Moonlight falls in through the four panes.
const kMoon = [-0.16, -0.92, 0.85];
const moonlight = {
  along: kMoon,
  light: [0.5, 0.85, 1.6],
  reach: ([x, y, z]) => {
    const t = (z + kHalf) / kMoon[2], [wx, wy] = [x - kMoon[0] * t, y - kMoon[1] * t];
    const falls = wx > left && wx < right && wy > low && wy < high && Math.abs(wx) > 0.03 && Math.abs(wy - 1.48) > 0.03;
    return falls ? (t - 0.2) * Math.hypot(...kMoon) : 0;
  }
};
const blocked = tracer([...things, ...shell]);
const inRoom = {
  blocked,
  ambient: [0.85, 0.82, 1.0],
  reach: 1.3,
  lamps: [{at: kLamp, radius: 0.24, light: [3.8, 2.5, 1.25]}],
  beams: [moonlight]
};
const atTexel = lit({...inRoom, rays: 24}), atVertex = lit({...inRoom, rays: 96});
// Things that hang at a wall do not shade it: they hide too few of its vertices.
const onWall = lit({...inRoom, rays: 96, blocked: tracer([...standingThings, ...shell])});
// The eye moves by some degrees only, when the user drags. Triangles that no such eye sees are left out.
const kEyes =
    [37, 45, 53]
        .flatMap((phi) => [55, 60, 65].map((theta) => [phi, theta].map((a) => a * Math.PI / 180)))
        .map(([phi, theta]) => [Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi)]);
const kInside =
    Array
        .from(
            {length: 8}, (_, i) => Array.from({length: 8 - i}, (_, j) => [i, j, 7 - i - j].map((n) => (n + 0.1) / 7.3)))
        .flat();
const seen = (faces) => faces.map((f) => {
  const normal = unit(cross(minus(f.points[1], f.points[0]), minus(f.points[2], f.points[0])));
  const places = kInside.map(
      (shares) => [0, 1, 2].map(
          (k) => shares.reduce((sum, share, i) => sum + share * f.points[i][k], 0.003 * normal[k])));
  const shows = kEyes.some((eye) => dot(normal, eye) > 0 && places.some((p) => !blocked(p, eye, 20)));
  return shows ? f : {...f, covered: true};
});
const shone = (mesh, light = atVertex) => {
  mesh.vertices.forEach((v, i) => (v.colour = light(v.position, v.normal, v.colour, i)));
  return mesh;
};

// Floor and walls have textures. The floor has planks and a round rug.
const floorColour = (x, z) => {
  const r = Math.hypot(x - kRug[0], z - kRug[2]);
  if (r < 1.36)
    return rgb(
        r > 1.28     ? '#e8dcc4' :
            r > 1.2  ? '#b8504a' :
            r > 1.12 ? '#e8dcc4' :
            r > 0.62 ? '#c8605a' :
            r > 0.56 ? '#e8dcc4' :
                       '#b8504a');
  const row = Math.floor((z + kHalf) / 0.25), along = (x + kHalf) / 1.15 + (row * 0.37) % 1;
  const plank = row * 17 + Math.floor(along), tone = ((plank * 7919) % 97) / 97;
  const joint = Math.min((z + kHalf) / 0.25 - row, along - Math.floor(along));
  return mix(mix('#a8714a', '#c48c60', tone), '#6a432c', joint < 0.08 ? 0.55 : 0);
};
const started = Date.now();
let seed = 0;
writePicture('home/floor.png', 128, 64, (u, v) => {
  const [x, z] = [2 * kHalf * u - kHalf, 2 * kHalf * v - kHalf];
  return atTexel([x, 0, z], [0, 1, 0], floorColour(x, z), ++seed);
}, {samples: 4});
// The walls' corners are closer together near the lamp.
const wall = (place) =>
    grid(8, 4, (u, v) => ({point: place(-kHalf + 2 * kHalf * u ** 1.4, 0.1 + (kTall - 0.1) * v), colour: '#a39ab8'}));
const skirting = (place) => grid(3, 1, (u, v) => ({point: place(-kHalf + 2 * kHalf * u, 0.1 * v), colour: '#f4efe6'}));
const onLeft = (s, y) => [-kHalf, y, s], onRight = (s, y) => [s, y, -kHalf];
const mirrored = (faces) => faces.map(
    (f) =>
        ({points: [...f.points].reverse(), colours: [...f.colours].reverse(), texcoords: [...f.texcoords].reverse()}));
const walls = [...wall(onRight), ...skirting(onRight), ...mirrored([...wall(onLeft), ...skirting(onLeft)])];
const kCorners = [[0, 1], [1, 1], [1, 0], [0, 0]];
writeModel(
    'home/floor.glb', {
      floor: welded(polygon(
          [[-kHalf, 0, kHalf], [kHalf, 0, kHalf], [kHalf, 0, -kHalf], [-kHalf, 0, -kHalf]], '#ffffff', kCorners)),
    },
    {texcoords: true});

// Things that shine, or that lie outside of the room, get no light.
const kEdge = '#d8cfc4', out = -kHalf - kThick;
const night = (x0, x1) => grid(
    1, 3,
    (u, v) => (
        {point: [x0 + (x1 - x0) * u, low + (high - low) * v, wz + 0.01], colour: mix('#5a7cc0', '#16234e', v ** 0.8)}));
const facingOut = (x, y, r, colour, sides) => polygon(
    Array.from(
        {length: sides},
        (_, i) => [x + r * Math.cos(2 * Math.PI * i / sides), y + r * Math.sin(2 * Math.PI * i / sides), wz + 0.02]),
    colour);
const roofs = [
  [-0.72, -0.5, 0.2], [-0.5, -0.34, 0.32], [-0.34, -0.1, 0.14], [0.05, 0.26, 0.26], [0.26, 0.5, 0.16], [0.5, 0.72, 0.24]
].flatMap(([x0, x1, tall]) => rect([x0, low, wz + 0.015], [x1, low + tall, wz + 0.015], '#1c2a50'));
const outside = [
  ...night(left, right),
  ...facingOut(0.42, 1.76, 0.095, '#fff6d8', 12),
  ...roofs,
  ...[[-0.55, 1.8], [-0.3, 1.62], [-0.15, 1.86], [0.12, 1.7], [0.6, 1.56]].flatMap(
      ([x, y]) => facingOut(x, y, 0.018, '#e8f0ff', 4)),
  ...[[-0.43, 1.16], [-0.62, 1.1], [0.14, 1.14], [0.6, 1.12]].flatMap(([x, y]) => facingOut(x, y, 0.026, '#ffd070', 4)),
];
const cut = [
  ...rect([out, kTall, out], [-kHalf, kTall, kHalf], '#f6efe4'),
  ...rect([-kHalf, kTall, out], [kHalf, kTall, -kHalf], '#f6efe4'),
  ...rect([out, -kSlab, kHalf], [-kHalf, kTall, kHalf], '#b4aeb0'),
  ...polygon([[kHalf, -kSlab, -kHalf], [kHalf, -kSlab, out], [kHalf, kTall, out], [kHalf, kTall, -kHalf]], '#8c8a96'),
  ...rect([-kHalf, -kSlab, kHalf], [kHalf, 0, kHalf], '#8a5f48'),
  ...polygon([[kHalf, -kSlab, kHalf], [kHalf, -kSlab, -kHalf], [kHalf, 0, -kHalf], [kHalf, 0, kHalf]], '#6a4636'),
];
writeModel('home/things.glb', {
  things: [
    shone(welded(seen(things), 62)), shone(welded(walls), onWall), welded(seen([...shade, ...outside, ...cut]), 50)
  ].reduce((a, b) => joined(a, b))
});
writeModel('home/rotor.glb', {rotor: welded(rotor, 40)});

// The robot that cleans goes around the table: its model is that far from the origin.
const kWay = 0.93;
const robot = at(
    [
      ...lathe([[0, 0.115], [0.1, 0.115]], 10, '#f4f6f8'),
      ...lathe([[0.1, 0.115], [0.14, 0.11]], 10, '#48d8f8'),
      ...lathe([[0.14, 0.11], [0.22, 0.1]], 12, '#dfe4ea'),
      ...lathe([[0.22, 0.1, '#b8c0ca'], [0.24, 0.02, '#2c323c']], 12),
      ...lathe([[0, 0.16], [0.05, 0.16], [0.055, 0.115]], 6, '#3a424e'),
      ...lathe([[0.23, 0.012, '#4a2426'], [0.31, 0.012, '#a84a45']], 14),
    ],
    kWay, 0, 0);
writeModel('home/robot.glb', {robot: welded(robot, 40)});

// Digits are made of strokes; each is 0.6 wide and 1 high.
const arc = (x, y, r, from, to, tall = r) => Array.from({length: 17}, (_, i) => {
  const a = (from + (to - from) * i / 16) * Math.PI / 180;
  return [x + r * Math.cos(a), y - tall * Math.sin(a)];
});
const kGlyphs = {
  1: [0.56, [[0.08, 0.24], [0.3, 0.05], [0.3, 0.95]]],
  2: [0.76, [...arc(0.3, 0.31, 0.25, 165, -30), [0.06, 0.95], [0.57, 0.95]]],
  4: [0.78, [[0.44, 0.95], [0.44, 0.05], [0.04, 0.68], [0.6, 0.68]]],
  5: [0.76, [[0.53, 0.05], [0.13, 0.05], [0.1, 0.45], ...arc(0.27, 0.66, 0.29, 130, -145)]],
  6: [0.76, [[0.46, 0.05], ...arc(0.3, 0.67, 0.28, 160, 520)]],
  8: [0.76, arc(0.3, 0.28, 0.22, 0, 360, 0.23), arc(0.3, 0.72, 0.26, 0, 360, 0.23)],
  9: [0.76, [[0.14, 0.95], ...arc(0.3, 0.33, 0.28, -20, 340)]],
  '.': [0.32, [[0.08, 0.94], [0.081, 0.94]]],
  ':': [0.34, [[0.1, 0.32], [0.101, 0.32]], [[0.1, 0.76], [0.101, 0.76]]],
  '%': [0.8, arc(0.16, 0.2, 0.13, 0, 360), arc(0.62, 0.8, 0.13, 0, 360), [[0.66, 0.08], [0.12, 0.92]]],
  '°': [0.4, arc(0.15, 0.17, 0.12, 0, 360)],
};
const toSegment = (x, y, [ax, ay], [bx, by]) => {
  const [dx, dy] = [bx - ax, by - ay],
             t = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
};
const figures = (file, text, em, pen) => {
  let along = 0;
  const strokes = [...text].flatMap((glyph) => {
    const [advance, ...paths] = kGlyphs[glyph], from = along;
    along += advance;
    return paths.map((points) => points.map(([x, y]) => [x + from, y]));
  });
  const [width, height] = [Math.ceil(along * em), Math.ceil(em + 2 * pen)];
  writePicture(`home/${file}.png`, width, height, (u, v) => {
    const [x, y] = [(u * width - pen) / em, (v * height - pen) / em];
    const near = Math.min(...strokes.flatMap((points) => points.slice(1).map((p, i) => toSegment(x, y, points[i], p))));
    return [255, 255, 255, near * em < pen ? 255 : 0];
  }, {alpha: true, samples: 6});
  console.log(`home/${file}.png: ${width}x${height}`);
};
figures('temperature', '21.5°', 25, 1.7);
figures('time', '19:42', 14, 1.05);
figures('humidity', '45%', 14, 1.05);
figures('cleaned', '68%', 14, 1.05);
