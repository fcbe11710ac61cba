// Makes the models of fox.toml. Public domain. Run: node fox.mjs
import {joined, occluded, welded, writeModel, writeSkin} from './models.mjs';
import {add, ball, box, dot, grid, lathe, minus, mix, placed, polygon, random, rgb, times, tube} from './shapes.mjs';

const kFur = '#ee7f2e', kPale = '#fff3e0', kDark = '#50301f', kScarf = '#1f9ea8', kEye = '#241a20';
const at = (faces, ...place) => placed(faces, {at: place});
const smooth = (t) => {
  const s = Math.min(1, Math.max(0, t));
  return s * s * (3 - 2 * s);
};
// Paints each face in one colour, by its middle.
const painted = (faces, colour) => faces.map((f) => {
  const middle = times(f.points.reduce(add), 1 / 3), own = rgb(colour(middle));
  return {...f, colours: f.points.map(() => own)};
});

// The fox looks along +z; its own left is +x. Joints as it is modelled.
const kHip = 0.6, kThigh = 0.26, kShin = 0.25, kAnkle = kHip - kThigh - kShin;
const kPlaces = {
  hips: ['', [0, 0.6, 0]],
  chest: ['hips', [0, 0.74, 0]],
  head: ['chest', [0, 1.04, 0]],
  scarf: ['chest', [0.15, 1.0, -0.17]],
  tail: ['hips', [0, 0.56, -0.2]],
  tip: ['tail', [0, 0.68, -0.66]],
};
for (const [side, s] of [['left', 1], ['right', -1]]) {
  Object.assign(kPlaces, {
    [`${side} arm`]: ['chest', [0.2 * s, 0.92, 0]],
    [`${side} hand`]: [`${side} arm`, [0.385 * s, 0.72, 0.01]],
    [`${side} thigh`]: ['hips', [0.135 * s, kHip, 0]],
    [`${side} shin`]: [`${side} thigh`, [0.135 * s, kHip - kThigh, 0]],
    [`${side} foot`]: [`${side} shin`, [0.135 * s, kAnkle, 0]],
  });
}
const bones = Object.entries(kPlaces).map(
    ([name, [parent, place]]) => ({name, parent, at: parent ? minus(place, kPlaces[parent][1]) : place}));

// Joints of a vertex along a chain: `t` grows along it, and joint i + 1 takes over from joint i around borders[i].
const along = (names, borders, soft) => (t) => {
  const i = borders.findIndex((border) => t < border + soft);
  if (i < 0) return {[names.at(-1)]: 1};
  const next = smooth((t - borders[i] + soft) / (2 * soft));
  return next > 0 ? {[names[i]]: 1 - next, [names[i + 1]]: next} : {[names[i]]: 1};
};
const moved = (mesh, joints) => ({...mesh, vertices: mesh.vertices.map((v) => ({...v, joints: joints(v.position)}))});
const by = (name) => () => ({[name]: 1});
const kCrease = 110;

const body = moved(
    welded(
        painted(
            lathe(
                [[0.15, 1.06], [0.2, 0.96], [0.262, 0.82], [0.285, 0.68], [0.25, 0.52], [0.14, 0.43], [0, 0.41]], 10,
                kFur, {squash: 0.9}),
            ([x, y, z]) => (z > 0.14 && Math.abs(x) < 0.18 ? kPale : kFur)),
        kCrease),
    ([, y]) => along(['hips', 'chest'], [0.7], 0.13)(y));

// The head: a ball that is wide at the cheeks, whose fur ends in tufts, and a snout.
const kHead = [0, 1.4, 0.02];
const skull = placed(ball(1, 7, 12, kFur), {
                scale: [0.45, 0.37, 0.4]
              }).map((f) => ({
                       ...f,
                       points: f.points.map(([x, y, z]) => {
                         const cheek = Math.exp(-(((y + 0.1) / 0.14) ** 2));
                         return [x * (1 + 0.16 * cheek), y, z * (y > 0 ? 1 : 1 - 0.05 * cheek)];
                       })
                     }));
const snout = tube(
    [[0, -0.1, 0.2], [0, -0.1, 0.38], [0, -0.115, 0.53], [0, -0.11, 0.56]], [0.235, 0.165, 0.08, 0], 8, kFur,
    [1, 0, 0]);
const tuft = (s) =>
    placed(lathe([[0, 0.24], [0.11, 0]], 4, kPale), {turn: [10, 0, -112 * s], at: [0.36 * s, -0.13, 0.06]});
const ear = (s) =>
    placed(painted(lathe([[0, 0.38], [0.07, 0.25], [0.16, -0.04]], 5, kFur, {squash: 0.5}), ([, y, z]) => {
             if (y > 0.25) return kDark;
             return z > 0.03 ? '#fbd9c0' : kFur;
           }), {turn: [-8, 0, -20 * s], at: [0.25 * s, 0.27, -0.02]});
const eye = (s) => placed(
    ball(1, 4, 7, kEye).filter((f) => f.points.some(([, , z]) => z > 0.1)),
    {scale: [0.062, 0.088, 0.03], turn: [-4, 22 * s, 0], at: [0.175 * s, 0.045, 0.356]});
const glint = (s) =>
    at(polygon([[-0.018, -0.02, 0], [0.018, -0.02, 0.002], [0.018, 0.02, 0], [-0.018, 0.02, 0]], '#ffffff'),
       0.165 * s + 0.012, 0.08, 0.392);
const furry = (faces) => painted(faces, ([, y, z]) => (y < -0.06 && z > 0.02 || (z > 0.3 && y < -0.09) ? kPale : kFur));
const headFaces = [
  ...furry(skull),
  ...painted(snout, ([, y]) => (y > -0.085 ? kFur : kPale)),
  ...at(placed(ball(1, 4, 6, '#2c1c1c'), {scale: [0.052, 0.042, 0.045]}), 0, -0.085, 0.54),
  ...[1, -1].flatMap((s) => [...ear(s), ...eye(s), ...glint(s)]),
];
const head = moved(
    joined(welded(at(headFaces, ...kHead), kCrease), welded(at([...tuft(1), ...tuft(-1)], ...kHead), 180)), by('head'));

// The scarf around the neck, and its end.
const ring = placed(tube(Array.from({length: 10}, (_, i) => {
                      const a = 2 * Math.PI * i / 10;
                      return [0.215 * Math.sin(a), 0.015 * Math.cos(a), 0.205 * Math.cos(a)];
                    }), 0.088, 5, kScarf, [0, 1, 0], true), {at: [0, 1.02, 0]});
const kEnd = kPlaces.scarf[1];
const end = placed(box([0.18, 0.42, 0.05], kScarf), {at: add(kEnd, [0.02, -0.2, -0.04]), turn: [0, 50, 0]});
const stripe = placed(box([0.19, 0.08, 0.06], '#f8efd8'), {at: add(kEnd, [0.02, -0.33, -0.04]), turn: [0, 50, 0]});
const scarf = joined(
    moved(welded(ring, kCrease), by('chest')),
    moved(welded([...end, ...stripe], 180), ([, y]) => along(['chest', 'scarf'], [0.02], 0.05)(kEnd[1] - y)));

// A limb follows a path; a ring is [units along the path, radius, colour of the faces behind it].
function limb(points, rings, sides, across) {
  const place = (t) => {
    for (let i = 0;; ++i) {
      const length = Math.hypot(...minus(points[i + 1], points[i]));
      if (t <= length || i + 2 === points.length)
        return add(points[i], times(minus(points[i + 1], points[i]), t / length));
      t -= length;
    }
  };
  const faces = tube(rings.map(([t]) => place(t)), rings.map(([, r]) => r), sides, kFur, across);
  return faces.map((f, i) => {
    const own = rgb(rings[Math.floor(i / (2 * sides))][2] ?? kFur);
    return {...f, colours: f.colours.map(() => own)};
  });
}
// How far along the path its nearest point lies.
const share = (points) => (p) => {
  let best = 0, least = Infinity, before = 0;
  for (let i = 0; i + 1 < points.length; ++i) {
    const d = minus(points[i + 1], points[i]), length = Math.hypot(...d), q = minus(p, points[i]);
    const t = Math.min(1, Math.max(0, dot(q, d) / length ** 2));
    const distance = Math.hypot(...minus(q, times(d, t)));
    if (distance < least) [best, least] = [before + t * length, distance];
    before += length;
  }
  return best;
};
const limbs =
    [['left', 1], ['right', -1]]
        .map(([side, s]) => {
          const armPath =
              [[0.12 * s, 0.96, 0], kPlaces[`${side} arm`][1], kPlaces[`${side} hand`][1], [0.5 * s, 0.47, 0.05]];
          const arm = limb(
              armPath,
              [
                [0.03, 0.075], [0.15, 0.09], [0.26, 0.08], [0.35, 0.076], [0.44, 0.076, kDark], [0.54, 0.083, kDark],
                [0.61, 0.066, kDark], [0.64, 0]
              ],
              6, [0, 0, 1]);
          const legPath = [
            kPlaces[`${side} thigh`][1], kPlaces[`${side} shin`][1], kPlaces[`${side} foot`][1],
            add(kPlaces[`${side} foot`][1], [0, -0.05, 0])
          ];
          const leg = limb(
              legPath,
              [[0, 0.13], [0.1, 0.135], [0.2, 0.112], [0.27, 0.1, kDark], [0.36, 0.088, kDark], [0.5, 0.08, kDark]], 7,
              [1, 0, 0]);
          const foot = placed(ball(1, 5, 6, kDark), {scale: [0.118, 0.105, 0.185], at: [0.14 * s, 0.075, 0.07]})
                           .map((f) => ({...f, points: f.points.map(([x, y, z]) => [x, Math.max(0, y), z])}));
          const closed = foot.filter((f) => !f.points.every(([, y]) => y === 0));
          return [
            moved(
                welded(arm, kCrease),
                (p) => along(['chest', `${side} arm`, `${side} hand`], [0.06, 0.365], 0.075)(share(armPath)(p))),
            moved(
                welded(leg, kCrease),
                (p) => along(
                    ['hips', `${side} thigh`, `${side} shin`, `${side} foot`], [-0.02, kThigh, kThigh + kShin],
                    0.07)(share(legPath)(p))),
            moved(welded(closed, kCrease), by(`${side} foot`)),
          ];
        })
        .flat();

const tailPath =
    [[0, 0.58, -0.14], [0, 0.53, -0.32], [0, 0.57, -0.52], [0, 0.7, -0.68], [0, 0.9, -0.75], [0, 1.1, -0.72]];
const tail = moved(
    welded(
        limb(
            tailPath,
            [[0, 0.06], [0.18, 0.1], [0.38, 0.165], [0.6, 0.19], [0.8, 0.15, kPale], [0.92, 0.09, kPale], [1.03, 0]], 7,
            [1, 0, 0]),
        kCrease),
    (p) => along(['hips', 'tail', 'tip'], [0.06, 0.5], 0.14)(share(tailPath)(p)));

const fox = occluded([body, head, scarf, ...limbs, tail].reduce(joined), {reach: 0.3, dark: [0.6, 0.5, 0.52]});

// Angles of swinging parts, in degrees; a limb that swings forwards has a negative angle about x.
const wave = (t, shift = 0) => Math.sin(2 * Math.PI * (t + shift));
const degrees = (angle) => angle * 180 / Math.PI;
// A leg whose ankle is `ahead` of the hip's place and `up` above the ground, with a hip at this height: angles of
// thigh, shin and foot; the sole is tilted by `tilt`, toes down.
function leg(hip, ahead, up, tilt) {
  const down = hip - up - kAnkle, reach = Math.min(Math.hypot(ahead, down), 0.9995 * (kThigh + kShin));
  const cosine = (kThigh ** 2 + kShin ** 2 - reach ** 2) / (2 * kThigh * kShin);
  const knee = Math.PI - Math.acos(cosine);
  const inner = Math.acos((kThigh ** 2 + reach ** 2 - kShin ** 2) / (2 * kThigh * reach));
  const thigh = -Math.atan2(ahead, down) - inner;
  return [degrees(thigh), degrees(knee), tilt - degrees(thigh + knee)];
}
// One step: during `stance` of it the foot goes back on the ground, at the speed of the ground; then it swings.
const step = ({stance, ahead, behind, lift, toes}) => (t) => {
  t -= Math.floor(t);
  if (t < stance) {
    const s = t / stance, off = smooth((s - 0.7) / 0.3);
    return {ahead: ahead - (ahead + behind) * s, up: 0.035 * off, tilt: 18 * off};
  }
  const s = (t - stance) / (1 - stance), way = ahead + behind;
  // It leaves with the speed of the ground, and returns with it.
  const speed = way / stance * (1 - stance);
  const h = (2 * s ** 3 - 3 * s ** 2 + 1) * -behind + (s ** 3 - 2 * s ** 2 + s) * -speed +
      (3 * s ** 2 - 2 * s ** 3) * ahead + (s ** 3 - s ** 2) * -speed;
  const up = lift * Math.sin(Math.PI * s ** 0.8) + 0.035 * (1 - smooth(s / 0.3));
  return {
    ahead: h,
    up,
    tilt: 18 * (1 - smooth(s / 0.2)) + toes * Math.sin(Math.PI * Math.min(1, s / 0.7)) - 10 * Math.sin(Math.PI * s) * s
  };
};
function gait({foot, base, bob, phase, lean, arms, elbow, spread, twist, sway, flap, tailUp}) {
  const path = step(foot);
  return (t) => {
    const rise = bob * Math.cos(4 * Math.PI * (t - phase)), hip = base + rise;
    const side = (name, shift, s) => {
      const {ahead, up, tilt} = path(t + shift), [thigh, shin, sole] = leg(hip, ahead, up, tilt);
      const swing = wave(t + shift, 0.25 - foot.stance / 2 + 0.25);
      return {
        [`${name} thigh`]: {turn: [thigh, 0, 0]},
        [`${name} shin`]: {turn: [shin, 0, 0]},
        [`${name} foot`]: {turn: [sole, 0, 0]},
        [`${name} arm`]: {turn: [arms * swing, 0, s * spread]},
        [`${name} hand`]: {turn: [-elbow - 0.3 * arms * (1 - swing) / 2, 0, 0]},
      };
    };
    const turn = wave(t, 0.25 - foot.stance / 2 + 0.25);
    return {
      hips: {move: [0, hip - kHip, 0]},
      chest: {turn: [lean, -twist * turn, -sway * turn]},
      head: {turn: [-0.8 * lean + 2 * Math.cos(4 * Math.PI * t), 12 + 0.8 * twist * turn, 0.8 * sway * turn]},
      scarf: {turn: [flap + 9 * wave(2 * t), 0, 6 * wave(t)]},
      tail: {turn: [tailUp, 11 * wave(t), 0]},
      tip: {turn: [-0.4 * tailUp + 5 * wave(2 * t, 0.1), 15 * wave(t, -0.12), 0]},
      ...side('left', 0, 1),
      ...side('right', 0.5, -1),
    };
  };
}
// Keys of the clips are at sixtieths of a second, at which a sequence of clips is sampled: others would need two
// keyframes each.
const kWalk = {
  seconds: 0.8,
  foot: {stance: 0.6, ahead: 0.2, behind: 0.2, lift: 0.1, toes: 14}
};
const kRun = {
  seconds: 8 / 15,
  foot: {stance: 0.36, ahead: 0.2, behind: 0.24, lift: 0.2, toes: 45}
};
const speed = ({seconds, foot}) => (foot.ahead + foot.behind) / (foot.stance * seconds);
const standing = leg(0.59, 0.01, 0, 0);
writeSkin('fox/fox.glb', bones, fox, {
  walk: {
    seconds: kWalk.seconds,
    keys: 8,
    pose: gait({
      foot: kWalk.foot,
      base: 0.572,
      bob: 0.014,
      phase: kWalk.foot.stance / 2,
      lean: 3,
      arms: 30,
      elbow: 14,
      spread: -6,
      twist: 7,
      sway: 3,
      flap: 12,
      tailUp: 0
    })
  },
  wave: {
    seconds: 0.8,
    keys: 6,
    pose: (t) => {
      const one = Object.fromEntries(['left', 'right'].flatMap(
          (side) => [
              [`${side} thigh`, {turn: [standing[0], 0, 0]}], [`${side} shin`, {turn: [standing[1], 0, 0]}],
              [`${side} foot`, {turn: [standing[2], 0, 0]}]]));
      return {
        hips: {move: [0, -0.01, 0], turn: [0, 14, 0]},
        chest: {turn: [-2, 14, 4 + 2 * wave(t)]},
        head: {turn: [-3, 16, 5 + 3 * wave(t)]},
        scarf: {turn: [6, 0, 3 * wave(t)]},
        tail: {turn: [-14, 18 * wave(t), 0]},
        tip: {turn: [0, 20 * wave(t, -0.12), 0]},
        'left arm': {turn: [-8, 0, 66 + 5 * wave(t)]},
        'left hand': {turn: [0, 0, 46 + 30 * wave(t)]},
        'right arm': {turn: [0, 0, 6]},
        'right hand': {turn: [-16, 0, 0]},
        ...one,
      };
    }
  },
  run: {
    seconds: kRun.seconds,
    keys: 8,
    pose: gait({
      foot: kRun.foot,
      base: 0.575,
      bob: -0.035,
      phase: kRun.foot.stance / 2,
      lean: 16,
      arms: 48,
      elbow: 78,
      spread: -14,
      twist: 12,
      sway: 4,
      flap: 58,
      tailUp: 22
    })
  },
});

// An island of two equal halves turns, so that its path moves back below the fox at the speed of the clips. kSteps are
// those of fox.toml; their distance is half around.
const kSteps = [
  {speed: speed(kWalk), seconds: 1.6, fade: 0.3}, {speed: 0, seconds: 1.6, fade: 0.35},
  {speed: speed(kRun), seconds: 1.6, fade: 0.3}
];
const speedAt = (seconds) => {
  let i = 0;
  while (seconds >= kSteps[i].seconds && i + 1 < kSteps.length) seconds -= kSteps[i++].seconds;
  const before = kSteps[(i + kSteps.length - 1) % kSteps.length].speed;
  return before + (kSteps[i].speed - before) * Math.min(1, seconds / kSteps[i].fade);
};
const kDuration = kSteps.reduce((sum, {seconds}) => sum + seconds, 0);
const way = [0];
for (let i = 0; i < 1000 * kDuration; ++i) way.push(way.at(-1) + speedAt((i + 0.5) / 1000) / 1000);
const kRadius = way.at(-1) / Math.PI;
console.log(`the island's radius is ${kRadius.toFixed(3)}; fox.toml has its keyframes:`);
let start = 0;
for (const {seconds, fade} of kSteps) {
  for (const part of [0, 0.25, 0.5, 0.75, 1]) {
    const time = start + part * fade;
    console.log(`  { time = ${+ time.toFixed(3)}, rotation = [0, ${
        (180 * way[Math.round(1000 * time)] / way.at(-1)).toFixed(2)}, 0] },`);
  }
  start += seconds;
}

const kSand = '#ecd3a2', kWide = 0.36, kSides = 16, kHalf = {
  from: 0,
  to: 180
};
const meadow = ([x, , z]) =>
    mix('#8fd060', '#62b65c', 0.5 + 0.5 * Math.sin(4 * Math.atan2(z, x) + 4 * Math.hypot(x, z)));
const island = [
  ...lathe([[0, 0], [0.6, 0], [kRadius - kWide, 0]], kSides, meadow, kHalf),
  ...lathe([[kRadius - kWide, 0], [kRadius + kWide, 0]], kSides, kSand, kHalf),
  ...lathe([[kRadius + kWide, 0], [kRadius + 0.66, 0]], kSides, meadow, kHalf),
  ...lathe(
      [
        [kRadius + 0.66, 0, '#5aa856'], [kRadius + 0.66, -0.12, '#4a9450'], [kRadius + 0.66, -0.12, '#b98a5e'],
        [kRadius + 0.46, -0.3, '#9a6f4b'], [0, -0.7, '#7c573f']
      ],
      kSides, '#ffffff', kHalf)
];
const trunk = (tall) => lathe([[0.06, tall], [0.1, 0]], 5, '#8a5a3c');
const fir = (size, colour) => placed(
    [
      ...trunk(0.25), ...at(lathe([[0, 0.6], [0.4, 0]], 7, colour), 0, 0.2, 0),
      ...at(lathe([[0, 0.5], [0.3, 0]], 7, mix(colour, '#ffffff', 0.1)), 0, 0.55, 0)
    ],
    {scale: size});
const leafy = (size, colour) => placed(
    [...trunk(0.5), ...at(ball(0.4, 5, 7, ([, y]) => mix(colour, '#f4f0a0', Math.max(0, 1.2 * y))), 0, 0.8, 0)],
    {scale: size});
const stone = (i) => placed(
    ball(1, 4, 5, mix('#c4c0c0', '#8f8f98', random(i))).filter((f) => f.points.every(([, y]) => y > -0.1)),
    {scale: [0.09 + 0.05 * random(i + 3), 0.08, 0.08]});
const flower = (colour) => lathe([[0, 0.15, '#fff0a0'], [0.085, 0.11, colour], [0, 0, '#3f8a48']], 5);
const mushroom = [
  ...lathe([[0.03, 0.1], [0.04, 0]], 5, '#fbf0dc'),
  ...at(lathe([[0, 0.1], [0.07, 0.07], [0.11, 0]], 6, '#dc4a3c'), 0, 0.08, 0)
];
const around = (faces, angle, radius) => {
  const a = angle * Math.PI / 180;
  return placed(faces, {at: [radius * Math.sin(a), 0, radius * Math.cos(a)], turn: [0, 50 * angle, 0]});
};
const grown = [
  ...around(leafy(1.5, '#62b04c'), 100, 0.42),
  ...around(fir(1.3, '#2f8a5c'), 40, 0.75),
  ...around(fir(0.95, '#3f9a56'), 160, 0.82),
  ...around(leafy(0.8, '#86c04c'), 10, 0.95),
  ...around(mushroom, 66, 1.08),
  ...around(placed(mushroom, {scale: 1.4}), 128, 1.08),
  ...[[24, -0.42], [58, 0.43], [96, -0.43], [140, 0.42]].flatMap(([a, r], i) => around(stone(i), a, kRadius + r)),
  ...[12, 44, 80, 118, 166].flatMap(
      (a, i) => around(flower(['#ff7fae', '#fff6e0', '#ffb347'][i % 3]), a, kRadius + 0.52 + 0.06 * (i % 2))),
];
// The light comes from above alone, because the island turns.
const fromAbove = (mesh) => {
  for (const v of mesh.vertices) v.colour = times(v.colour, 0.86 + 0.14 * v.normal[1]);
  return mesh;
};
const shaded = fromAbove(occluded(welded(grown, 180), {others: island, reach: 0.5, dark: [0.5, 0.52, 0.58]}));
writeModel('fox/island.glb', {island: joined(welded(island, 180), shaded)});
// The soft shadow below the fox has the colour of the path at its border.
writeModel('fox/shade.glb', {
  shade: welded(placed(
      lathe([[0, 0, '#a98d68'], [0.5, 0, '#b3966f'], [0.75, 0, '#cfb486'], [1, 0, kSand]], 14),
      {scale: [0.31, 1, 0.34]}))
});
writeModel('fox/sky.glb', {
  sky: welded(grid(1, 3, (u, v) => ({
                           point: [10 * u - 5, 9 * v - 4.5, 0],
                           colour: ['#fdf0d8', '#fbeed6', '#c4e6f4', '#86c8ee'][Math.round(3 * v)]
                         })))
});
