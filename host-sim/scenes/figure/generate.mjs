// Makes figure.gltf: a figure of tubes around 19 joints, with the clips "walk" and "wave". Public domain.
// Run: node generate.mjs > figure.gltf
// Metres, y up, the figure looks along +z; its own left is +x.

const kSides = 12;

// Joints as they are modelled: name, parent, place.
const joints = [
  ['hips', -1, [0, 1.0, 0]], ['spine', 0, [0, 1.12, 0]], ['chest', 1, [0, 1.3, 0]], ['neck', 2, [0, 1.52, 0]],
  ['head', 3, [0, 1.6, 0.01]],
];
const index = (name) => joints.findIndex(([own]) => own === name);
for (const [side, x] of [['left', 1], ['right', -1]]) {
  joints.push([`${side} collar`, index('chest'), [0.05 * x, 1.46, 0]]);
  joints.push([`${side} arm`, index(`${side} collar`), [0.19 * x, 1.45, 0]]);
  joints.push([`${side} forearm`, index(`${side} arm`), [0.29 * x, 1.18, 0]]);
  joints.push([`${side} hand`, index(`${side} forearm`), [0.36 * x, 0.95, 0.03]]);
}
for (const [side, x] of [['left', 1], ['right', -1]]) {
  joints.push([`${side} thigh`, index('hips'), [0.1 * x, 0.94, 0]]);
  joints.push([`${side} shin`, index(`${side} thigh`), [0.11 * x, 0.5, 0.01]]);
  joints.push([`${side} foot`, index(`${side} shin`), [0.12 * x, 0.08, -0.02]]);
}

const add = (a, b) => a.map((v, i) => v + b[i]);
const minus = (a, b) => a.map((v, i) => v - b[i]);
const times = (a, s) => a.map((v) => v * s);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);
const unit = (a) => times(a, 1 / (length(a) || 1));

const colours = {
  skin: [224, 172, 132], hair: [70, 44, 30], shirt: [52, 104, 168], trousers: [66, 66, 78], shoes: [150, 60, 40],
};
const vertices = [];  // {position, normal, colour, weights: [[joint, weight], ...]}
const triangles = [];

// A closed tube. Rings: [place, radius across, radius along z or the tube's own second axis, colour, weights].
function tube(rings, across) {
  const first = vertices.length;
  rings.forEach(([place, a, b, colour, weights], i) => {
    const along = unit(minus(rings[Math.min(i + 1, rings.length - 1)][0], rings[Math.max(i - 1, 0)][0]));
    const second = unit(cross(along, across));
    const firstAxis = cross(second, along);
    for (let s = 0; s < kSides; ++s) {
      const angle = 2 * Math.PI * s / kSides;
      const out = add(times(firstAxis, a * Math.cos(angle)), times(second, b * Math.sin(angle)));
      vertices.push({position: add(place, out), normal: [0, 0, 0], colour: colours[colour], weights});
    }
  });
  const end = (i, at) => {
    vertices.push({position: at, normal: [0, 0, 0], colour: colours[rings[i][3]], weights: rings[i][4]});
    return vertices.length - 1;
  };
  const low = end(0, rings[0][0]), high = end(rings.length - 1, rings[rings.length - 1][0]);
  const at = (ring, side) => first + ring * kSides + side % kSides;
  for (let s = 0; s < kSides; ++s) {
    triangles.push([low, at(0, s + 1), at(0, s)]);
    triangles.push([high, at(rings.length - 1, s), at(rings.length - 1, s + 1)]);
    for (let ring = 0; ring + 1 < rings.length; ++ring) {
      triangles.push([at(ring, s), at(ring, s + 1), at(ring + 1, s)]);
      triangles.push([at(ring + 1, s), at(ring, s + 1), at(ring + 1, s + 1)]);
    }
  }
}

// Weights along a chain of joints, at `t` of its length: where two joints meet, each has half.
function weightsAt(chain, ends, t, soft) {
  for (let i = 0; i + 1 < chain.length; ++i) {
    const from = (t - ends[i]) / soft;
    if (from >= 1) continue;
    if (from <= -1) return [[chain[i], 1]];
    const next = (from + 1) / 2, smooth = next * next * (3 - 2 * next);
    return [[chain[i], 1 - smooth], [chain[i + 1], smooth]];
  }
  return [[chain[chain.length - 1], 1]];
}

// The torso has its weights by height.
{
  const chain = ['hips', 'spine', 'chest', 'neck'].map(index), ends = [1.08, 1.24, 1.5];
  const shape = [
    [0.86, 0.1, 0.09], [0.9, 0.155, 0.115], [0.97, 0.165, 0.12], [1.04, 0.15, 0.11], [1.12, 0.14, 0.1],
    [1.2, 0.15, 0.105], [1.28, 0.165, 0.115], [1.36, 0.18, 0.12], [1.43, 0.175, 0.105], [1.48, 0.12, 0.08],
    [1.52, 0.062, 0.06], [1.58, 0.055, 0.058], [1.62, 0.05, 0.055],
  ];
  tube(shape.map(([y, a, b]) => [[0, y, 0], a, b, y < 1.02 ? 'trousers' : y < 1.5 ? 'shirt' : 'skin',
                                  weightsAt(chain, ends, y, 0.07)]), [1, 0, 0]);
}
// The head is an egg with hair.
{
  const rings = [];
  for (let i = 1; i < 10; ++i) {
    const angle = Math.PI * i / 10, y = 1.7 - 0.13 * Math.cos(angle), r = Math.sin(angle);
    rings.push([[0, y, 0.015], 0.085 * r, 0.105 * r, y > 1.74 ? 'hair' : 'skin', [[index('head'), 1]]]);
  }
  tube(rings, [1, 0, 0]);
}
// A limb goes through the places of its joints, and beyond the last one.
function limb(names, beyond, shape, across, soft) {
  const chain = names.map(index);
  const points = [...chain.map((i) => joints[i][2]), beyond];
  const lengths = points.slice(1).map((p, i) => length(minus(p, points[i])));
  const whole = lengths.reduce((a, b) => a + b);
  const ends = [];
  lengths.slice(0, -1).reduce((sum, own, i) => (ends[i] = sum + own), 0);
  const at = (t) => {
    let i = 0;
    while (i + 1 < lengths.length && t > lengths[i]) t -= lengths[i++];
    return add(points[i], times(minus(points[i + 1], points[i]), t / lengths[i]));
  };
  tube(shape.map(([t, a, b, colour]) => [at(t * whole), a, b, colour, weightsAt(chain, ends, t * whole, soft)]), across);
}
for (const [side, x] of [['left', 1], ['right', -1]]) {
  limb(['collar', 'arm', 'forearm', 'hand'].map((part) => `${side} ${part}`), [0.395 * x, 0.8, 0.05], [
    [0.06, 0.05, 0.05, 'shirt'], [0.15, 0.062, 0.066, 'shirt'], [0.22, 0.06, 0.062, 'shirt'], [0.3, 0.055, 0.056, 'shirt'],
    [0.38, 0.05, 0.05, 'shirt'], [0.44, 0.046, 0.047, 'shirt'], [0.5, 0.045, 0.046, 'skin'], [0.56, 0.045, 0.046, 'skin'],
    [0.64, 0.04, 0.042, 'skin'], [0.72, 0.034, 0.034, 'skin'], [0.8, 0.028, 0.026, 'skin'], [0.86, 0.024, 0.042, 'skin'],
    [0.93, 0.02, 0.044, 'skin'], [0.985, 0.012, 0.024, 'skin'],
  ], [1, 0, 0], 0.055);
  limb(['thigh', 'shin'].map((part) => `${side} ${part}`), [0.12 * x, 0.03, -0.02], [
    [-0.02, 0.06, 0.06, 'trousers'], [0.05, 0.088, 0.095, 'trousers'], [0.15, 0.085, 0.092, 'trousers'],
    [0.26, 0.078, 0.084, 'trousers'], [0.37, 0.07, 0.074, 'trousers'], [0.43, 0.064, 0.066, 'trousers'],
    [0.49, 0.062, 0.065, 'trousers'], [0.55, 0.06, 0.064, 'trousers'], [0.64, 0.058, 0.064, 'trousers'],
    [0.76, 0.05, 0.054, 'trousers'], [0.88, 0.045, 0.047, 'trousers'], [0.97, 0.044, 0.046, 'trousers'],
  ], [1, 0, 0], 0.075);
  const foot = [[index(`${side} foot`), 1]];
  tube([[-0.075, 0.03, 0.028], [-0.055, 0.042, 0.045], [0, 0.044, 0.055], [0.06, 0.046, 0.044], [0.12, 0.046, 0.034],
        [0.165, 0.038, 0.026], [0.185, 0.02, 0.016]]
         .map(([z, a, b]) => [[0.12 * x, b + 0.004, z - 0.01], a, b, 'shoes', foot]), [1, 0, 0]);
}

for (const [a, b, c] of triangles) {
  const [p, q, r] = [a, b, c].map((i) => vertices[i].position);
  const normal = cross(minus(q, p), minus(r, p));
  for (const i of [a, b, c]) vertices[i].normal = add(vertices[i].normal, normal);
}

// A clip has the angles of each joint in degrees about x, y and z, at a time of 0..1, and the height of the hips.
const wave = (t, shift = 0) => Math.sin(2 * Math.PI * (t + shift));
const clips = {
  walk: {
    seconds: 1.2, keys: 12,
    rise: (t) => 0.02 * Math.cos(4 * Math.PI * t) - 0.02,
    joints: {
      'hips': (t) => [0, 6 * wave(t), 0], 'spine': (t) => [2, -5 * wave(t), 0], 'chest': (t) => [2, -7 * wave(t), 0],
      'neck': (t) => [-2, 4 * wave(t), 0], 'head': (t) => [-2, 2 * wave(t), 0],
      'left arm': (t) => [28 * wave(t), 0, -14], 'right arm': (t) => [-28 * wave(t), 0, 14],
      'left forearm': (t) => [-22 - 14 * wave(t, 0.5), 0, 0], 'right forearm': (t) => [-22 - 14 * wave(t), 0, 0],
      'left thigh': (t) => [-30 * wave(t), 0, 0], 'right thigh': (t) => [30 * wave(t), 0, 0],
      'left shin': (t) => [8 + 30 * Math.max(0, wave(t, 0.25)), 0, 0],
      'right shin': (t) => [8 + 30 * Math.max(0, wave(t, 0.75)), 0, 0],
      'left foot': (t) => [-4 + 12 * wave(t, 0.1), 0, 0], 'right foot': (t) => [-4 + 12 * wave(t, 0.6), 0, 0],
    },
  },
  wave: {
    seconds: 1.5, keys: 15,
    rise: () => 0,
    joints: {
      'chest': () => [0, 0, -4], 'head': (t) => [0, 0, 6 + 3 * wave(t)], 'left arm': () => [0, 0, 118],
      'left forearm': (t) => [0, 0, 42 + 24 * wave(t)], 'left hand': (t) => [0, 0, 12 * wave(t, 0.1)],
      'right arm': () => [0, 0, 14], 'right forearm': () => [-12, 0, 0],
    },
  },
};
function quaternion(degrees) {
  const [x, y, z] = degrees.map((d) => d * Math.PI / 360);
  const [sx, sy, sz] = [x, y, z].map(Math.sin), [cx, cy, cz] = [x, y, z].map(Math.cos);
  return [sx * cy * cz - cx * sy * sz, cx * sy * cz + sx * cy * sz, cx * cy * sz - sx * sy * cz,
          cx * cy * cz + sx * sy * sz];
}

// The file.
const chunks = [], bufferViews = [], accessors = [];
let size = 0;
function put(buffer, accessor) {
  bufferViews.push({buffer: 0, byteOffset: size, byteLength: buffer.length});
  const padded = Buffer.concat([buffer, Buffer.alloc((4 - buffer.length % 4) % 4)]);
  chunks.push(padded);
  size += padded.length;
  accessors.push({bufferView: bufferViews.length - 1, ...accessor});
  return accessors.length - 1;
}
const floats = (values) => Buffer.from(new Float32Array(values).buffer);
const bounds = (rows) => ({
  min: rows[0].map((_, i) => Math.fround(Math.min(...rows.map((r) => r[i])))),
  max: rows[0].map((_, i) => Math.fround(Math.max(...rows.map((r) => r[i])))),
});
const FLOAT = 5126, BYTE = 5121, SHORT = 5123;
const count = vertices.length;
const places = vertices.map((v) => v.position);
const four = (values) => [...values, 0, 0, 0, 0].slice(0, 4);
const attributes = {
  POSITION: put(floats(places.flat()), {componentType: FLOAT, count, type: 'VEC3', ...bounds(places)}),
  NORMAL: put(floats(vertices.flatMap((v) => unit(v.normal))), {componentType: FLOAT, count, type: 'VEC3'}),
  COLOR_0: put(Buffer.from(vertices.flatMap((v) => [...v.colour.map((c) => Math.round(255 * (c / 255) ** 2.2)), 255])),
               {componentType: BYTE, normalized: true, count, type: 'VEC4'}),
  JOINTS_0: put(Buffer.from(vertices.flatMap((v) => four(v.weights.map(([joint]) => joint)))),
                {componentType: BYTE, count, type: 'VEC4'}),
  WEIGHTS_0: put(Buffer.from(vertices.flatMap((v) => {
    const weights = four(v.weights.map(([, weight]) => Math.round(255 * weight)));
    weights[0] += 255 - weights.reduce((a, b) => a + b);
    return weights;
  })), {componentType: BYTE, normalized: true, count, type: 'VEC4'}),
};
const indices = put(Buffer.from(new Uint16Array(triangles.flat()).buffer),
                    {componentType: SHORT, count: 3 * triangles.length, type: 'SCALAR'});
const inverseBindMatrices = put(
  floats(joints.flatMap(([, , p]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -p[0], -p[1], -p[2], 1])),
  {componentType: FLOAT, count: joints.length, type: 'MAT4'});
const round = (v) => Math.round(v * 1e6) / 1e6;
const local = (i) => minus(joints[i][2], joints[i][1] < 0 ? [0, 0, 0] : joints[joints[i][1]][2]).map(round);
const animations = Object.entries(clips).map(([name, clip]) => {
  const animation = {name, channels: [], samplers: []};
  const shares = Array.from({length: clip.keys + 1}, (_, k) => k / clip.keys);
  const input = put(floats(shares.map((t) => t * clip.seconds)),
                    {componentType: FLOAT, count: shares.length, type: 'SCALAR', min: [0], max: [Math.fround(clip.seconds)]});
  const channel = (joint, path, output) => {
    animation.channels.push({sampler: animation.samplers.length, target: {node: joint + 1, path}});
    animation.samplers.push({input, output});
  };
  for (const [joint, angles] of Object.entries(clip.joints)) {
    channel(index(joint), 'rotation', put(floats(shares.flatMap((t) => quaternion(angles(t)))),
                                          {componentType: FLOAT, count: shares.length, type: 'VEC4'}));
  }
  channel(0, 'translation', put(floats(shares.flatMap((t) => add(joints[0][2], [0, clip.rise(t), 0]))),
                                {componentType: FLOAT, count: shares.length, type: 'VEC3'}));
  return animation;
});
process.stdout.write(JSON.stringify({
  asset: {version: '2.0', generator: 'generate.mjs', copyright: 'public domain'},
  scene: 0,
  scenes: [{nodes: [0, 1]}],
  nodes: [
    {name: 'figure', mesh: 0, skin: 0},
    ...joints.map(([name], i) => {
      const children = joints.flatMap(([, parent], c) => (parent === i ? [c + 1] : []));
      return {name, translation: local(i), ...(children.length ? {children} : {})};
    }),
  ],
  skins: [{inverseBindMatrices, joints: joints.map((_, i) => i + 1)}],
  materials: [{name: 'figure', pbrMetallicRoughness: {metallicFactor: 0}}],
  meshes: [{primitives: [{attributes, indices, material: 0}]}],
  animations,
  accessors,
  bufferViews,
  buffers: [{byteLength: size, uri: 'data:application/octet-stream;base64,' + Buffer.concat(chunks).toString('base64')}],
}) + '\n');
