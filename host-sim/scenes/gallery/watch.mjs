// Makes the models and textures of watch.toml. Public domain. Run: node watch.mjs
import {joined, occluded, welded, writeModel} from './models.mjs';
import {writePicture} from './pictures.mjs';
import {box, cross, grid, lathe, minus, mix, placed, polygon, unit} from './shapes.mjs';

// The watch looks along +z, twelve is at +y; its dial has radius 1. A lathe's axis becomes z.
const facing = (faces) => placed(faces, {turn: [90, 0, 0]});
const kSides = 40;

// Case, lugs and crown are steel.
const ring = facing(lathe([[1.0, 0.1], [1.02, 0.2], [1.09, 0.25], [1.2, 0.2], [1.29, 0.06], [1.31, -0.08]], kSides));
const lug = (x, y) =>
    placed(box([0.22, 0.46, 0.26], '#ffffff', 0.07), {at: [0.64 * x, 1.24 * y, -0.12], turn: [8 * y, 0, 0]});
const crown = placed(
    lathe([[0, 0.2], [0.11, 0.18], [0.13, 0.14], [0.13, 0.02], [0.07, 0]], 9),
    {turn: [0, 0, -90], at: [1.32, 0, -0.06]});
writeModel('watch/steel.glb', {
  steel: joined(welded(ring, 50), welded([...lug(1, 1), ...lug(-1, 1), ...lug(1, -1), ...lug(-1, -1), ...crown], 75))
});

// The dial: a disc, lighter in the middle, and its marks.
const disc = facing(lathe([[0, 0.02], [0.5, 0.02], [0.84, 0.02], [1.01, 0.02]], kSides, ([x, , z]) => {
  const r = Math.hypot(x, z);
  return r > 0.95 ? '#0a1424' : r > 0.7 ? '#12305c' : r > 0.3 ? '#1c4c84' : '#3474b0';
}));
const turned = (faces, minute) => placed(faces, {turn: [0, 0, -6 * minute]});
const mark = (minute) => {
  const [w, low, high] = minute % 15 === 0 ? [0.045, 0.68, 0.92] : [0.03, 0.74, 0.92];
  // A roof of two slopes, and its ends.
  return turned(
      [
        ...polygon([[-w, low, 0.025], [0, low + 0.02, 0.055], [0, high - 0.02, 0.055], [-w, high, 0.025]], '#ffffff'),
        ...polygon([[0, low + 0.02, 0.055], [w, low, 0.025], [w, high, 0.025], [0, high - 0.02, 0.055]], '#c8d4e4'),
      ],
      minute);
};
const tick = (minute) => turned(
    polygon([[-0.009, 0.88, 0.03], [0.009, 0.88, 0.03], [0.009, 0.93, 0.03], [-0.009, 0.93, 0.03]], '#a8bcd4'), minute);
const minutes = Array.from({length: 60}, (_, i) => i);
const date = [...polygon([[0.5, -0.1, 0.03], [0.72, -0.1, 0.03], [0.72, 0.1, 0.03], [0.5, 0.1, 0.03]], '#e8eef4')];
// "28", of seven strokes.
const strokes = (x, which) => which.flatMap((k) => {
  const [a, b, c, d] = [
    [-0.03, 0.05, 0.03, 0.065], [0.017, 0, 0.032, 0.06], [0.017, -0.06, 0.032, 0], [-0.03, -0.065, 0.03, -0.05],
    [-0.032, -0.06, -0.017, 0], [-0.032, 0, -0.017, 0.06], [-0.03, -0.0075, 0.03, 0.0075]
  ][k];
  return polygon([[x + a, b, 0.036], [x + c, b, 0.036], [x + c, d, 0.036], [x + a, d, 0.036]], '#18202c');
});
const dial = welded(
    [
      ...disc,
      ...minutes.flatMap(
          (m) =>
              (m % 5        ? tick(m) :
                   m === 15 ? [] :
                              mark(m))),
      ...date, ...strokes(0.565, [0, 1, 6, 4, 3]), ...strokes(0.655, [0, 1, 2, 3, 4, 5, 6])
    ],
    20);

// Each hand has two slopes, of one colour and of a darker one.
const hand = (outline, z, ridge, light, dark) => [1, -1].flatMap((s) => {
  const points = outline.map(([x, y]) => [s * x, y, z]), middle = outline.map(([, y]) => [0, y, z + ridge]);
  return points.slice(1).flatMap(
      (p, i) => polygon(
          s > 0 ? [middle[i], points[i], p, middle[i + 1]] : [middle[i], middle[i + 1], p, points[i]],
          s > 0 ? dark : light));
});
const hub = (r, z, colour) => facing(lathe([[0, z + 0.03], [r, z + 0.02], [r, z]], 9, colour));
const hands = [
  ...turned(
      hand([[0.02, -0.16], [0.055, 0.08], [0.05, 0.44], [0, 0.56]], 0.06, 0.02, '#f8fafc', '#b4c0d0'),
      10 * 5 + 50 / 60 * 5 - 0.5),
  ...turned(hand([[0.018, -0.18], [0.045, 0.08], [0.036, 0.72], [0, 0.84]], 0.1, 0.02, '#f8fafc', '#b4c0d0'), 9.4),
  ...hub(0.075, 0.11, '#d4dce4')
];
writeModel('watch/dial.glb', {dial: joined(dial, welded(hands, 20))});
writeModel('watch/second.glb', {
  second: welded(
      [
        ...hand([[0.03, -0.26], [0.016, -0.06], [0.014, 0.3], [0.008, 0.88]], 0.15, 0.006, '#ff8038', '#e06420'),
        ...hub(0.045, 0.15, '#ff8038')
      ],
      20)
});

// The strap: two bands of leather that bend away, with seams.
const band = (s) => {
  const path = Array.from({length: 6}, (_, i) => {
    const angle = i / 5 * 1.2;
    return [0, s * (1.15 + 2.6 * Math.sin(angle)), -0.1 - 1.6 * (1 - Math.cos(angle))];
  });
  const across = (w, lift, colour) => grid(2, 5, (u, v, i, j) => {
    const k = s > 0 ? j : 5 - j, along = unit(minus(path[Math.min(k + 1, 5)], path[Math.max(k - 1, 0)])),
          out = cross([s, 0, 0], along);
    return {
      point: path[k].map((p, n) => p + out[n] * (lift + (i === 1 ? 0.05 : 0)) + (n === 0 ? (2 * u - 1) * w : 0)),
      colour: colour(i)
    };
  });
  // The picture shows no more of them.
  const stitches =
      Array
          .from({length: 7}, (_, n) => [-1, 1].flatMap((side) => {
            const at = (t) => {
              const k = Math.min(4, Math.floor(t)), f = t - k, p = path[k].map((c, m) => c + (path[k + 1][m] - c) * f);
              return [p[0] + 0.44 * side, p[1], p[2] + 0.055];
            };
            const [a, b] = [at(0.6 + n * 0.42), at(0.6 + n * 0.42 + 0.24)].sort((p, q) => p[1] - q[1]),
                      w = [0.014, 0, 0];
            return polygon([minus(a, w), a.map((v, m) => v + w[m]), b.map((v, m) => v + w[m]), minus(b, w)], '#f0d8b0');
          }))
          .flat();
  return [...across(0.52, 0, (i) => (i === 1 ? '#9a5c34' : '#6e3c20')), ...stitches];
};
writeModel('watch/strap.glb', {
  strap: occluded(
      welded([...band(1), ...band(-1)], 60),
      {others: [...ring, ...lug(1, 1), ...lug(-1, 1), ...lug(1, -1), ...lug(-1, -1)], reach: 0.6})
});
// Glass: a shallow dome.
writeModel(
    'watch/glass.glb', {glass: welded(facing(lathe([[0, 0.28], [0.4, 0.27], [0.75, 0.24], [1.02, 0.19]], 20)), 60)});

// A studio as a mirrored ball shows it: a bright window above, a strip to the right, a dark floor.
const studio = (u, v) => {
  const [x, y] = [2 * u - 1, 1 - 2 * v], r = Math.min(1, Math.hypot(x, y)),
            soft = (d, w) => Math.max(0, Math.min(1, 0.5 - d / w));
  let colour = y > 0 ? mix('#5a6472', '#aab6c4', y) : mix('#4a4e58', '#16181e', Math.min(1, -1.6 * y));
  const inside = Math.max(Math.abs(x + 0.25) - 0.34, Math.abs(y - 0.5) - 0.2);
  colour = mix(colour, '#ffffff', soft(inside, 0.1));
  colour = mix(colour, '#e8f0ff', 0.85 * soft(Math.max(Math.abs(x - 0.7) - 0.07, Math.abs(y) - 0.45), 0.08));
  colour = mix(colour, '#c89468', 0.45 * soft(Math.max(Math.abs(y + 0.72) - 0.1, Math.abs(x) - 0.5), 0.4));
  return mix(colour, '#22262e', Math.max(0, (r - 0.88) * 6) * 0.7);
};
writePicture('watch/studio.png', 64, 64, studio);
