// Makes the models of clips.toml. Public domain. Run: node clips.mjs
import {occluded, welded, writeFigure, writeModel} from './gallery/models.mjs';
import {ball, box, lathe, mix, placed, polygon, random, rgb, tube} from './gallery/shapes.mjs';

const kSkin = '#fcc59c', kHair = '#5a3524', kShirt = '#f2584a', kTrousers = '#31508f', kShoe = '#fdf6e8',
      kCap = '#2f7fd8';
const at = (faces, ...place) => placed(faces, {at: place});

// The runner looks along +z; its own left is +x. Each part stands around the joint by which it moves.
const kHip = 0.94, kThigh = 0.42, kShin = 0.42, kArm = 0.34;
const hips = at(placed(ball(0.27, 4, 9, kTrousers), {scale: [1, 0.72, 0.85]}), 0, 0.02, 0);
const chest = [
  ...lathe(
      [
        [0, 0.62, kShirt], [0.16, 0.58, kShirt], [0.28, 0.4, '#fdf0d8'], [0.28, 0.26, '#fdf0d8'], [0.27, 0.22, kShirt],
        [0.25, 0, kShirt]
      ],
      10, kShirt, {squash: 0.8}),
  ...placed(box([0.4, 0.46, 0.2], '#f6b93c', 0.06), {at: [0, 0.32, -0.3]}),
];
const eye = (x) => at(placed(ball(0.06, 3, 6, '#2a2230'), {scale: [1, 1.4, 0.4]}), x, 0.3, 0.435);
const head = [
  ...at(ball(0.45, 7, 12, ([, y, z]) => (z < -0.12 || y > 0.2 ? kHair : kSkin)), 0, 0.35, 0),
  ...[-1, 1].flatMap((s) => at(ball(0.1, 3, 5, kSkin), 0.44 * s, 0.28, -0.02)),
  ...placed(
      lathe([[0, 0.4], [0.2, 0.36], [0.38, 0.22], [0.48, 0]], 12, kCap), {at: [0, 0.46, -0.02], turn: [-8, 0, 0]}),
  ...placed(lathe([[0.36, 0.03], [0.6, 0]], 6, '#2566b4', {from: -58, to: 58}), {at: [0, 0.5, 0], turn: [4, 0, 0]}),
  ...eye(0.16),
  ...eye(-0.16),
  ...at(ball(0.06, 3, 5, '#eaa078'), 0, 0.22, 0.45),
];
const mouth =
    at(polygon([[-0.08, 0.025, 0], [-0.045, -0.035, 0.006], [0.045, -0.035, 0.006], [0.08, 0.025, 0]], '#a2323f'), 0,
       0.1, 0.395);
const upper = [
  ...tube([[0, 0.1, 0], [0, 0.02, 0], [0, -0.23, 0]], [0.02, 0.13, 0.11], 7, kShirt),
  ...tube([[0, -0.22, 0], [0, -kArm - 0.04, 0]], [0.085, 0.08], 6, kSkin)
];
const lower = [
  ...tube([[0, 0.06, 0], [0, 0, 0], [0, -0.24, 0]], [0.03, 0.082, 0.07], 6, kSkin),
  ...at(ball(0.11, 4, 6, kSkin), 0, -0.31, 0)
];
const thigh =
    tube([[0, 0.1, 0], [0, 0, 0], [0, -kThigh, 0], [0, -kThigh - 0.1, 0]], [0.06, 0.16, 0.13, 0.05], 7, kTrousers);
const shin = [
  ...tube([[0, 0.08, 0], [0, 0, 0], [0, -0.24, 0]], [0.05, 0.13, 0.125], 7, kTrousers),
  ...tube([[0, -0.22, 0], [0, -0.36, 0]], [0.085, 0.08], 6, '#fdf0d8'),
  ...placed(ball(0.15, 4, 8, ([, y]) => (y < -0.05 ? kShoe : kShirt)), {at: [0, -0.4, 0.07], scale: [0.85, 0.72, 1.5]}),
];
const shaded = (faces, crease = 60) => occluded(welded(faces, crease), {reach: 0.3, dark: [0.72, 0.64, 0.68]});
const bones = [
  {name: 'hips', parent: '', at: [0, kHip, 0], mesh: shaded(hips)},
  {name: 'chest', parent: 'hips', at: [0, 0.1, 0], mesh: shaded(chest)},
  {name: 'head', parent: 'chest', at: [0, 0.6, 0.02], mesh: shaded([...head, ...mouth])},
  ...[1, -1].flatMap((s) => {
    const side = s > 0 ? 'left' : 'right';
    return [
      {name: `${side} arm`, parent: 'chest', at: [0.31 * s, 0.46, 0], mesh: shaded(upper)},
      {name: `${side} hand`, parent: `${side} arm`, at: [0, -kArm, 0], mesh: shaded(lower)},
      {name: `${side} thigh`, parent: 'hips', at: [0.14 * s, -0.04, 0], mesh: shaded(thigh)},
      {name: `${side} shin`, parent: `${side} thigh`, at: [0, -kThigh, 0], mesh: shaded(shin)},
    ];
  }),
];

// Angles of swinging parts; a leg that swings forwards has a negative angle about x.
const wave = (share, shift = 0) => Math.sin(2 * Math.PI * (share + shift));
const gait = ({stride, knee, rest, arms, elbow, spread, lean, bob, twist}) => (share) => {
  const leg = (side, shift) => ({
    [`${side} thigh`]: {turn: [-stride * wave(share, shift) - rest, 0, 0]},
    [`${side} shin`]: {turn: [rest + 6 + knee * Math.max(0, wave(share, shift + 0.28)) ** 1.3, 0, 0]},
    [`${side} arm`]: {turn: [arms * wave(share, shift), 0, side === 'left' ? spread : -spread]},
    [`${side} hand`]: {turn: [-elbow - 0.3 * arms * (1 - wave(share, shift)) / 2, 0, 0]},
  });
  return {
    hips: {move: [0, bob * wave(2 * share, 0.25) - bob, 0], turn: [0, -twist * wave(share), 0]},
    chest: {turn: [lean, 1.8 * twist * wave(share), 0]},
    head: {turn: [-0.7 * lean, -20 - 0.8 * twist * wave(share), 0]},
    ...leg('left', 0),
    ...leg('right', 0.5),
  };
};
writeFigure('clips/runner.glb', bones, {
  walk: {
    seconds: 1,
    keys: 16,
    pose: gait({stride: 27, knee: 40, rest: 0, arms: 24, elbow: 14, spread: 9, lean: 3, bob: 0.025, twist: 7})
  },
  wave: {
    seconds: 0.8,
    keys: 12,
    pose: (share) => ({
      hips: {turn: [0, -52, 0], move: [0, -0.01 - 0.01 * wave(share), 0]},
      chest: {turn: [0, 0, 3 + 2 * wave(share)]},
      head: {turn: [0, 0, -9 - 3 * wave(share)]},
      'right arm': {turn: [0, 0, -138 - 6 * wave(share)]},
      'right hand': {turn: [0, 0, -22 + 30 * wave(share)]},
      'left arm': {turn: [0, 0, 14]},
      'left hand': {turn: [-18, 0, 0]},
      'left thigh': {turn: [0, 0, 5]},
      'right thigh': {turn: [0, 0, -5]},
      'left shin': {turn: [2, 0, 0]},
      'right shin': {turn: [2, 0, 0]},
    })
  },
  run: {
    seconds: 0.6,
    keys: 16,
    pose: gait({stride: 46, knee: 82, rest: 10, arms: 44, elbow: 78, spread: 12, lean: 14, bob: 0.06, twist: 11})
  },
});

// A small planet, which turns below the runner about the x axis: a path around it, meadow, trees, flowers, a house.
const kRadius = 2.3;
const paint = ([x, y, z]) => {
  const off = Math.abs(x), angle = Math.atan2(z, y);
  if (off < 0.5) return '#e6c98e';
  return mix(
      '#86cc5e', '#4f9f58', Math.min(1, Math.max(0, 0.45 + 0.4 * Math.sin(5 * angle + 3 * x) + 0.2 * (off - 1.2))));
};
// Rings are close together at the borders of the path.
const kRings = [-0.99, -0.9, -0.72, -0.46, -0.225, -0.2, 0, 0.2, 0.225, 0.46, 0.72, 0.9, 0.99]
                   .map((share) => [Math.sqrt(1 - share ** 2) * kRadius, share * kRadius])
                   .reverse();
const planet = placed(lathe(kRings, 32, '#ffffff'), {
                 turn: [0, 0, -90]
               }).map((f) => ({...f, colours: f.points.map((p) => rgb(paint(p)))}));
const onPlanet = (faces, degrees, across, turn = 0) => {
  const tilt = Math.asin(across / kRadius) * 180 / Math.PI;
  return placed(
      placed(placed(at(placed(faces, {turn: [0, turn, 0]}), 0, kRadius - 0.03, 0), {turn: [0, 0, -tilt]}), {}),
      {turn: [degrees, 0, 0]});
};
const trunk = (tall) => lathe([[0.06, tall], [0.09, 0]], 4, '#8a5a3c');
const fir = (size, colour) => placed(
    [
      ...trunk(0.25), ...at(lathe([[0, 0.5], [0.34, 0]], 6, colour), 0, 0.2, 0),
      ...at(lathe([[0, 0.42], [0.25, 0]], 6, mix(colour, '#ffffff', 0.1)), 0, 0.5, 0)
    ],
    {scale: size});
const round = (size, colour) => placed(
    [...trunk(0.4), ...at(ball(0.34, 4, 6, ([, y]) => mix(colour, '#f4f0a0', Math.max(0, y))), 0, 0.66, 0)],
    {scale: size});
const house = [
  ...at(box([0.5, 0.42, 0.46], '#fbf0dc'), 0, 0.19, 0),
  ...at(polygon([[-0.31, 0, 0.28], [0.31, 0, 0.28], [0.31, 0.3, 0], [-0.31, 0.3, 0]], '#d9584a'), 0, 0.38, 0),
  ...at(polygon([[0.31, 0, -0.28], [-0.31, 0, -0.28], [-0.31, 0.3, 0], [0.31, 0.3, 0]], '#c44a40'), 0, 0.38, 0),
  ...[-1, 1].flatMap(
      (s) => polygon(
          s > 0 ? [[0.25, 0.4, 0.23], [0.25, 0.4, -0.23], [0.25, 0.66, 0]] :
                  [[-0.25, 0.4, -0.23], [-0.25, 0.4, 0.23], [-0.25, 0.66, 0]],
          '#fbf0dc')),
  ...polygon([[-0.255, 0, -0.07], [-0.255, 0, 0.07], [-0.255, 0.24, 0.07], [-0.255, 0.24, -0.07]], '#7a4f36'),
];
const flower = (colour) => [...lathe([[0, 0.14, '#fff0a0'], [0.09, 0.1, colour], [0.02, 0, '#3f8a48']], 5)];
const kGreens = ['#3f9a56', '#2f8a5c', '#57a848'];
const grown = [
  ...Array
      .from(
          {length: 11},
          (_, i) => onPlanet(
              i % 3 ? fir(0.85 + 0.5 * random(i), kGreens[i % 3]) : round(0.7 + 0.4 * random(i), '#6ab04c'),
              32.7 * i + 9, (i % 4 < 2 ? (i % 2 ? 1 : 1.25) : -1.5) * (0.98 + 0.2 * random(i + 40))))
      .flat(),
  ...onPlanet(house, 130, 1.15, 0),
  ...onPlanet(house, 300, 1.2, 40),
  ...Array
      .from(
          {length: 15},
          (_, i) => onPlanet(
              flower(['#ff7fae', '#fff6e0', '#ffb347'][i % 3]), 24 * i,
              (i % 2 ? 1 : -1) * (0.74 + 0.1 * random(i + 9))))
      .flat(),
];
writeModel(
    'clips/planet.glb',
    {planet: occluded(welded([...planet, ...grown], 35), {reach: 0.5, rays: 32, dark: [0.4, 0.46, 0.5]})});
// The dark place below the runner stays where it is.
const shade = placed(ball(kRadius + 0.012, 80, 14, '#b8986a'), {})
                  .filter((f) => f.points.every(([x, y, z]) => Math.hypot(x, z) < 0.36 && y > 0));
writeModel('clips/shade.glb', {shade: welded(shade)});
