// glTF files of one feature each that move: animations of nodes, skins, morph targets.
import {about, build, kUbyte, kUshort} from './gltf_builder.mjs';

/** An animation of a cube beside one that stands still. `curves`: target path, interpolation, times, values. */
function moving(curves) {
  return build((b) => {
    const material = b.material({colour: [0.8, 0.5, 0.2]});
    b.cube(material, {translation: [-3, 0, 0], scale: [0.5, 0.5, 0.5]});
    const node = b.cube(material, {translation: [0, 0, 0]});
    b.cube(material, {translation: [3, 2, 0], scale: [0.5, 0.5, 0.5]});
    const widths = {rotation: 'VEC4', weights: 'SCALAR'};
    const samplers = curves.map(([path, interpolation, times, values]) => ({
                                  interpolation,
                                  input: b.accessor(times, 'SCALAR'),
                                  output: b.accessor(values, widths[path] ?? 'VEC3'),
                                }));
    const channels = curves.map(([path], sampler) => ({sampler, target: {node, path}}));
    b.add('animations', {name: 'Move', samplers, channels});
  });
}

/** A cube on an arm that turns, and turns itself by more than half a turn in three steps. */
function swinging() {
  return build((b) => {
    const material = b.material();
    const hand = b.cube(material, {translation: [3, 0, 0], scale: [0.5, 1, 0.25]});
    const arm = b.cube(material, {scale: [1, 1, 1], children: [hand]});
    b.json.scenes[0].nodes = [arm];
    b.cube(material, {translation: [-3, 2, 0]});
    const input = b.accessor([0, 1, 2], 'SCALAR');
    const turns = (axis, ...degrees) => ({
      input,
      output: b.accessor(degrees.flatMap((each) => about(axis, each)), 'VEC4'),
    });
    const samplers = [turns([0, 1, 0], 0, 90, 180), turns([0, 0, 1], 0, 120, 240)];
    const channels = [arm, hand].map((node, sampler) => ({sampler, target: {node, path: 'rotation'}}));
    b.add('animations', {samplers, channels});
  });
}

/** A bar of two joints that bends; `scale`: of the node above them; `morphs`: a target widens its middle meanwhile. */
function bending(scale = 1, morphs = false) {
  return build((b) => {
    const places = [], indices = [], joints = [], weights = [], kRows = 9;
    for (let i = 0; i < kRows; ++i) {
      const y = (4 * i) / (kRows - 1), share = Math.min(Math.max((y - 1) / 2, 0), 1);
      for (const [x, z] of [[-0.5, 0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, -0.5]]) {
        places.push(x, y, z);
        joints.push(0, 1, 0, 0);
        weights.push(1 - share, share, 0, 0);
      }
      if (i === 0) continue;
      for (let k = 0; k < 4; ++k) {
        const low = 4 * (i - 1), a = low + k, c = low + ((k + 1) % 4);
        indices.push(a, c, c + 4, a, c + 4, a + 4);
      }
    }
    const attributes = {
      POSITION: b.accessor(places, 'VEC3'),
      JOINTS_0: b.accessor(joints, 'VEC4', kUbyte),
      WEIGHTS_0: b.accessor(weights, 'VEC4'),
    };
    const material = b.material({colour: [0.3, 0.7, 0.3], doubleSided: true});
    const primitive = {attributes, indices: b.accessor(indices, 'SCALAR', kUshort), material};
    if (morphs) {
      const wider = places.map((c, i) => (i % 3 === 1 ? 0 : c * Math.max(0, 1 - Math.abs(places[i - (i % 3) + 1] - 2))));
      primitive.targets = [{POSITION: b.accessor(wider, 'VEC3')}];
    }
    const mesh = b.add('meshes', {primitives: [primitive]});
    const tip = b.add('nodes', {translation: [0, 2, 0]});
    const foot = b.add('nodes', {children: [tip]});
    b.root({children: [foot], scale: [scale, scale, scale], rotation: about([0, 1, 0], scale === 1 ? 0 : 40)});
    const at = (y) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -y, 0, 1];
    const inverseBindMatrices = b.accessor([...at(0), ...at(2)], 'MAT4');
    const bar = b.root({mesh, skin: b.add('skins', {joints: [foot, tip], inverseBindMatrices})});
    const input = b.accessor([0, 1, 2], 'SCALAR');
    const output = b.accessor([0, 60, -30].flatMap((degrees) => about([0, 0, 1], degrees)), 'VEC4');
    const samplers = [{input, output}], channels = [{sampler: 0, target: {node: tip, path: 'rotation'}}];
    if (morphs) {
      samplers.push({input, output: b.accessor([0, 1, 0.5], 'SCALAR')});
      channels.push({sampler: 1, target: {node: bar, path: 'weights'}});
    }
    b.add('animations', {samplers, channels});
  });
}

/** A square whose corners two morph targets move: by `weights` of the mesh and of the node, or in an animation. */
function morphed({mesh = undefined, node = undefined, animated = false}) {
  return build((b) => {
    const attributes = {POSITION: b.accessor([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 'VEC3')};
    const targets = [
      {POSITION: b.accessor([0, 0, 0, 0, 0, 0, 1, 1, 0, -1, 0.5, 0], 'VEC3')},
      {POSITION: b.accessor([-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0], 'VEC3')},
    ];
    const primitive =
        {attributes, targets, indices: b.accessor([0, 1, 2, 0, 2, 3], 'SCALAR', kUshort), material: b.material()};
    const weighted = (weights, what) => (weights ? {...what, weights} : what);
    const moved = b.root(weighted(node, {mesh: b.add('meshes', weighted(mesh, {primitives: [primitive]}))}));
    if (!animated) return;
    const input = b.accessor([0, 1, 2], 'SCALAR'), output = b.accessor([0, 0, 1, 0, 0.5, 1], 'SCALAR');
    b.add(
        'animations', {samplers: [{input, output}], channels: [{sampler: 0, target: {node: moved, path: 'weights'}}]});
  });
}

/** A cube with flat faces that becomes thin, then leans: normals of two pairs of faces change. */
function morphingCube() {
  return build((b) => {
    const places = [], normals = [], indices = [];
    for (const [axis, sign] of [[0, 1], [0, -1], [1, 1], [1, -1], [2, 1], [2, -1]]) {
      const first = places.length / 3;
      for (const [s, t] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const corner = [0, 0, 0], normal = [0, 0, 0];
        corner[axis] = normal[axis] = sign;
        corner[(axis + 1) % 3] = s * sign;
        corner[(axis + 2) % 3] = t;
        places.push(...corner);
        normals.push(...normal);
      }
      indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
    const changed = (values, change) => {
      const deltas = [];
      for (let i = 0; i < values.length; i += 3) {
        const from = values.slice(i, i + 3), to = change(from);
        deltas.push(...to.map((c, k) => c - from[k]));
      }
      return b.accessor(deltas, 'VEC3');
    };
    const unit = (v) => v.map((c) => c / Math.hypot(...v));
    const targets = [
      {POSITION: changed(places, ([x, y, z]) => [0.3 * x, y, z]), NORMAL: changed(normals, (n) => n)},
      {POSITION: changed(places, ([x, y, z]) => [x + 0.8 * y, y, z]),
       NORMAL: changed(normals, ([x, y, z]) => unit([x, y - 0.8 * x, z]))},
    ];
    const attributes = {POSITION: b.accessor(places, 'VEC3'), NORMAL: b.accessor(normals, 'VEC3')};
    const primitive = {attributes, targets, indices: b.accessor(indices, 'SCALAR', kUshort), material: b.material()};
    const node = b.root({mesh: b.add('meshes', {weights: [0, 0], primitives: [primitive]})});
    const input = b.accessor([0, 1, 2, 3, 4], 'SCALAR');
    const output = b.accessor([0, 0, 1, 0, 0.25, 0.5, 0, 1, 0, 0], 'SCALAR');
    b.add('animations', {name: 'Move', samplers: [{input, output}], channels: [{sampler: 0, target: {node, path: 'weights'}}]});
  });
}

/** A sheet from which eight targets raise a hill each, one after the other and then together, on curves of all kinds. */
function stressedSheet(interpolation) {
  return build((b) => {
    const kSide = 33, kHills = 8, places = [], normals = [], indices = [];
    for (let row = 0; row < kSide; ++row) {
      for (let column = 0; column < kSide; ++column) {
        places.push((4 * column) / (kSide - 1) - 2, 0, (4 * row) / (kSide - 1) - 2);
        normals.push(0, 1, 0);
        if (row === 0 || column === 0) continue;
        const d = row * kSide + column, c = d - 1, a = c - kSide, e = d - kSide;
        indices.push(a, c, d, a, d, e);
      }
    }
    const targets = Array.from({length: kHills}, (_, hill) => {
      const angle = (2 * Math.PI * hill) / kHills, x = 1.2 * Math.cos(angle), z = 1.2 * Math.sin(angle);
      const moves = [], turns = [];
      for (let i = 0; i < places.length; i += 3) {
        const dx = places[i] - x, dz = places[i + 2] - z, square = (dx * dx + dz * dz) / 0.5;
        const height = square < 1 ? (1 - square) ** 3 : 0, slope = square < 1 ? (6 * (1 - square) ** 2) / 0.5 : 0;
        moves.push(0, height, 0);
        turns.push(slope * dx * 0.2, 0, slope * dz * 0.2);
      }
      return {POSITION: b.accessor(moves, 'VEC3'), NORMAL: b.accessor(turns, 'VEC3')};
    });
    const attributes = {POSITION: b.accessor(places, 'VEC3'), NORMAL: b.accessor(normals, 'VEC3')};
    const primitive = {attributes, targets, indices: b.accessor(indices, 'SCALAR', kUshort), material: b.material()};
    const node = b.root({mesh: b.add('meshes', {primitives: [primitive]})});
    const times = Array.from({length: kHills + 2}, (_, i) => i / 2), all = (value) => Array(kHills).fill(value);
    const weights = times.flatMap((_, key) => {
      const own = all(0).map((_, hill) => (key === hill || key === kHills + 1 ? 1 : 0));
      return interpolation === 'CUBICSPLINE' ? [...all(0.5), ...own, ...all(-0.5)] : own;
    });
    const sampler = {interpolation, input: b.accessor(times, 'SCALAR'), output: b.accessor(weights, 'SCALAR')};
    b.add('animations', {samplers: [sampler], channels: [{sampler: 0, target: {node, path: 'weights'}}]});
  });
}

/** Name to file. */
export const kMovingFiles = {
  'move-linear': () => moving([
    ['translation', 'LINEAR', [0, 1, 2], [0, 0, 0, 0, 2, 0, 2, 2, 0]],
    ['rotation', 'LINEAR', [0, 2], [...about([0, 1, 0], 0), ...about([0, 1, 0], 150)]],
    ['scale', 'LINEAR', [0, 2], [1, 1, 1, 0.5, 0.5, 0.5]]
  ]),
  'move-step': () => moving([['translation', 'STEP', [0, 0.7, 1.2, 2], [0, 0, 0, 0, 2, 0, 1, 0, 0, 2, 2, 0]]]),
  'move-spline': () => moving([[
    'translation', 'CUBICSPLINE', [0, 1, 2],
    [0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 2, 0, -6, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0]
  ]]),
  'move-late': () => moving([['translation', 'LINEAR', [1, 2], [0, 0, 0, 2, 2, 0]]]),
  'move-arm': swinging,
  bending: () => bending(),
  'bending-scaled': () => bending(0.02),
  'morph-weights': () => morphed({mesh: [1, 0.5]}),
  'morph-node-weights': () => morphed({mesh: [1, 0], node: [0.5, 1]}),
  'morph-animated': () => morphed({animated: true}),
  'morph-cube': morphingCube,
  'morph-stress': () => stressedSheet('LINEAR'),
  'morph-stress-spline': () => stressedSheet('CUBICSPLINE'),
  'morph-bending': () => bending(1, true),
};
