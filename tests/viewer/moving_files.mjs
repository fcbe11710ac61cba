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

/** A bar of two joints that bends; `scale`: of the node above them. */
function bending(scale = 1) {
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
    const mesh =
        b.add('meshes', {primitives: [{attributes, indices: b.accessor(indices, 'SCALAR', kUshort), material}]});
    const tip = b.add('nodes', {translation: [0, 2, 0]});
    const foot = b.add('nodes', {children: [tip]});
    b.root({children: [foot], scale: [scale, scale, scale], rotation: about([0, 1, 0], scale === 1 ? 0 : 40)});
    const at = (y) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -y, 0, 1];
    const inverseBindMatrices = b.accessor([...at(0), ...at(2)], 'MAT4');
    b.root({mesh, skin: b.add('skins', {joints: [foot, tip], inverseBindMatrices})});
    const input = b.accessor([0, 1, 2], 'SCALAR');
    const output = b.accessor([0, 60, -30].flatMap((degrees) => about([0, 0, 1], degrees)), 'VEC4');
    b.add(
        'animations', {samplers: [{input, output}], channels: [{sampler: 0, target: {node: tip, path: 'rotation'}}]});
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
};
