// glTF files of one feature each, made of numbers.
import {about, build, kFloat, kShort, kUbyte, kUshort} from './gltf_builder.mjs';
import {kKeyDirection} from './lights.mjs';
import {kMovingFiles} from './moving_files.mjs';
import {fieldsPng, greyFields, paletteFields, rgbFields} from './test_pictures.mjs';

const kUnlit = {
  extensions: {KHR_materials_unlit: {}}
};

/** A textured square whose sampler wraps so, seen two and a half times each way. */
function wrapping(wrapS, wrapT) {
  return build(
      (b) => b.square(
          b.material({texture: b.texture(fieldsPng(), {wrapS, wrapT}), ...kUnlit}), {texcoords: [-0.75, 1.75]}));
}

/** Three textured squares beside each other, each with its transform of texture coordinates. */
function transformed(...transforms) {
  return build((b) => {
    const texture = b.texture(fieldsPng());
    transforms.forEach(
        (transform, i) =>
            b.square(b.material({texture, transform, ...kUnlit}), {at: [2.25 * i, 0, 0], texcoords: [0, 1]}));
  });
}

/** A picture of the fields in another kind of PNG file. */
function pictured(png) { return build((b) => b.square(b.material({texture: b.texture(png), ...kUnlit}))); }

const kCorners = [1, 0.1, 0.05, 0.1, 1, 0.1, 0.05, 0.1, 1, 1, 1, 0.2];

/** Colours at the corners of a square; `even`: the same at all. */
function vertexColours(material, {type = kFloat, alpha = false, even = false} = {}) {
  return build((b) => {
    const full = {[kFloat]: 1, [kUbyte]: 255, [kUshort]: 65535}[type];
    const colour = (i) => (even ? [0.3, 0.8, 0.5] : kCorners.slice(3 * i, 3 * i + 3));
    const corner = (i) => (alpha ? [...colour(i), even ? 0.6 : 0.25 + 0.25 * i] : colour(i));
    const values = [0, 1, 2, 3].flatMap(corner).map((value) => (full === 1 ? value : Math.round(full * value)));
    const colours = b.accessor(values, alpha ? 'VEC4' : 'VEC3', type, full === 1 ? {} : {normalized: true});
    b.square(b.material(material(b)), {attributes: {COLOR_0: colours}});
    if (alpha) b.square(b.material({colour: [0.1, 0.4, 0.1], ...kUnlit}), {at: [0, 0, -0.5], side: 2.5});
  });
}

/** Squares that overlap and blend, the nearest first in the file. */
function overlapping() {
  return build((b) => {
    const blends = (colour) => b.material({colour, ...kBlend, ...kUnlit});
    b.square(blends([0.8, 0.1, 0.1, 0.5]), {at: [0.6, 0.3, 0.4]});
    b.square(blends([0.1, 0.8, 0.1, 0.5]));
    b.square(blends([0.1, 0.1, 0.8, 0.7]), {at: [-0.3, -0.5, -0.4]});
    b.square(b.material({colour: [0.5, 0.5, 0.4], ...kUnlit}), {at: [0, 0, -1], side: 3});
  });
}

/** A mesh of two nodes. */
function shared() {
  return build((b) => {
    const mesh = b.json.nodes[b.cube(b.material(), {rotation: about([0, 1, 0], 20)})].mesh;
    b.root({mesh, translation: [3, 1, 0], scale: [0.5, 1, 1]});
  });
}

/** What is seen through, before a plain square. */
function before(material) {
  return build((b) => {
    b.square(b.material({colour: [0.05, 0.3, 0.6], ...kUnlit}), {at: [0, 0, -0.5], side: 2.5});
    b.square(b.material(material(b)));
  });
}

/** Four squares and a mirrored one of which some are seen from behind. */
function sides() {
  return build((b) => {
    const single = b.material({colour: [0.8, 0.2, 0.1], ...kUnlit});
    const both = b.material({colour: [0.1, 0.2, 0.8], doubleSided: true, ...kUnlit});
    b.square(single, {at: [0, 0, 0]});
    b.square(single, {at: [2.5, 0, 0], back: true});
    b.square(both, {at: [0, 2.5, 0]});
    b.square(both, {at: [2.5, 2.5, 0], back: true});
    b.square(single, {at: [5, 0, 0], node: {scale: [-1, 1, 1]}});
    b.square(single, {at: [5, 2.5, 0], back: true, node: {scale: [-1, 1, 1]}});
  });
}

/** Lit by a light of the file's own. */
function lit(light, node, make = (b) => b.sphere(b.material())) {
  return build((b) => {
    make(b);
    b.use('KHR_lights_punctual');
    b.json.extensions = {KHR_lights_punctual: {lights: [light]}};
    b.root({...node, extensions: {KHR_lights_punctual: {light: 0}}});
  });
}

/** Lights shine along -z; this one comes from the right. */
const kFromTheRight = about([0, 1, 0], 60);

/** The intensity that lights white fully where it meets it at right angles, at distance 1. */
const kFull = Math.PI;

/** Nodes in nodes: turned, stretched and mirrored. */
function nested() {
  return build((b) => {
    const material = b.material();
    const leaf = b.cube(material, {scale: [0.5, 1.5, 0.25], translation: [0, 1, 0], rotation: about([0, 0, 1], 25)});
    const mirrored = b.cube(material, {scale: [-0.4, 0.4, 0.8], translation: [2, 0, 0]});
    b.json.scenes[0].nodes = [];
    const matrix = [0, 0, -1, 0, 0, 1, 0, 0, 1.5, 0, 0, 0, 1, 0, 0, 1];
    const inner = b.add('nodes', {children: [leaf], matrix});
    b.root({children: [inner, mirrored], rotation: about([1, 0, 0], 30)});
  });
}

/** A square that faces the light of files without one: it is lit fully, so that its colours are the material's own. */
function facingLight(material, colours) {
  return build((b) => {
    const [x, y, z] = kKeyDirection, length = Math.hypot(x, y, z);
    const axis = [-y, x, 0].map((c) => c / Math.hypot(x, y));
    const rotation = about(axis, Math.acos(z / length) * 180 / Math.PI);
    const attributes = colours ? {COLOR_0: b.accessor(colours, 'VEC3')} : {};
    b.square(b.material(material(b)), {attributes, node: {rotation}});
  });
}

/** Positions, normals and texture coordinates side by side, without indices. */
function interleaved() {
  return build((b) => {
    const corners = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]];
    const values = corners.flatMap(([u, v]) => [2 * u - 1, 2 * v - 1, 0, 0, 0, 1, u, 1 - v]);
    const bufferView = b.view(Buffer.from(Float32Array.from(values).buffer));
    b.json.bufferViews[bufferView].byteStride = 32;
    const part = (byteOffset, type, more = {}) =>
        b.add('accessors', {bufferView, byteOffset, componentType: kFloat, type, count: 6, ...more});
    const attributes = {
      POSITION: part(0, 'VEC3', {min: [-1, -1, 0], max: [1, 1, 0]}),
      NORMAL: part(12, 'VEC3'),
      TEXCOORD_0: part(24, 'VEC2'),
    };
    b.node({attributes, material: b.material({texture: b.texture(fieldsPng()), ...kUnlit})});
  });
}

/** Texture coordinates of one unsigned integer type, normalized. */
function integerTexcoords(type, full) {
  return build((b) => {
    const view = b.view(Buffer.from(new (type === kUbyte ? Uint8Array : Uint16Array)([
                                      0, full, 0, 0, full, full, 0, 0, full, 0, 0, 0, 0, 0, 0, 0
                                    ]).buffer));
    b.json.bufferViews[view].byteStride = type === kUbyte ? 4 : 8;
    const accessor = {bufferView: view, componentType: type, normalized: true, type: 'VEC2', count: 4};
    b.square(b.material({texture: b.texture(fieldsPng()), ...kUnlit}), {
      attributes: {TEXCOORD_0: b.add('accessors', accessor)},
    });
  });
}

/** Positions in 16 bits (KHR_mesh_quantization), texture coordinates in 8. */
function quantised() {
  return build((b) => {
    b.use('KHR_mesh_quantization', true);
    const places = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0].map((c) => 32767 * c);
    const padded = [0, 1, 2, 3].flatMap((i) => [...places.slice(3 * i, 3 * i + 3), 0]);
    const view = b.view(Buffer.from(Int16Array.from(padded).buffer));
    b.json.bufferViews[view].byteStride = 8;
    const POSITION = b.add('accessors', {
      bufferView: view,
      componentType: kShort,
      normalized: true,
      type: 'VEC3',
      count: 4,
      min: [-32767, -32767, 0],
      max: [32767, 32767, 0]
    });
    const texcoords = b.view(Buffer.from([0, 255, 0, 0, 255, 255, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0]));
    b.json.bufferViews[texcoords].byteStride = 4;
    const TEXCOORD_0 =
        b.add('accessors', {bufferView: texcoords, componentType: kUbyte, normalized: true, type: 'VEC2', count: 4});
    b.square(b.material({texture: b.texture(fieldsPng()), ...kUnlit}), {attributes: {POSITION, TEXCOORD_0}});
  });
}

/** Positions of which an accessor replaces one (sparse). */
function sparse() {
  return build((b) => {
    const POSITION = b.accessor([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 'VEC3');
    const indices = b.view(Buffer.from(Uint16Array.of(2).buffer)),
          values = b.view(Buffer.from(Float32Array.of(2, 2, 0).buffer));
    Object.assign(b.json.accessors[POSITION], {
      max: [2, 2, 0],
      sparse: {count: 1, indices: {bufferView: indices, componentType: kUshort}, values: {bufferView: values}},
    });
    b.square(b.material({colour: [0.5, 0.5, 0.5], ...kUnlit}), {attributes: {POSITION}});
  });
}

/** Of two scenes the second is the file's. */
function secondScene() {
  return build((b) => {
    b.square(b.material({colour: [0.8, 0.1, 0.1], ...kUnlit}), {at: [-2, 0, 0]});
    const second = b.square(b.material({colour: [0.1, 0.1, 0.8], ...kUnlit}), {at: [1, 1, 0], side: 1});
    b.json.scenes = [{nodes: [0]}, {nodes: [second]}];
    b.json.scene = 1;
  });
}

/** A cube, and cameras that look at it. */
function seen() {
  return build((b) => {
    b.cube(b.material({colour: [0.6, 0.6, 0.9]}));
    const turn = about([0, 1, 0], 30);
    const at = [6 * Math.sin(Math.PI / 6), 0.5, 6 * Math.cos(Math.PI / 6)];
    const wide = b.add(
        'cameras',
        {name: 'wide', type: 'perspective', perspective: {yfov: 0.8, aspectRatio: 1.5, znear: 0.1, zfar: 50}});
    const plain = b.add('cameras', {name: 'plain', type: 'perspective', perspective: {yfov: 0.6, znear: 0.1}});
    const flat =
        b.add('cameras', {name: 'flat', type: 'orthographic', orthographic: {xmag: 3, ymag: 2, znear: 0.1, zfar: 50}});
    for (const [name, camera] of [['wide', wide], ['plain', plain], ['flat', flat]]) {
      b.root({name, camera, rotation: turn, translation: at});
    }
  });
}

/** A glow of its own on what reflects nothing. */
function glowing(material) { return build((b) => b.square(b.material({colour: [0, 0, 0], ...material(b)}))); }

const kBlend = {
  alphaMode: 'BLEND'
},
      kMask = {
        alphaMode: 'MASK'
      };
const kRepeat = 10497, kMirror = 33648, kClamp = 33071;
const steps = (u, v) => [0, 96, 160, 255][(u + v) & 3];

/** Name to file. */
export const kGenerated = {
  'no-material': () => build((b) => b.square(undefined)),
  'colour-factor': () => build(
      (b) => [0.02, 0.2, 0.8].forEach(
          (c, i) => b.square(b.material({colour: [c, 0.8 - 0.5 * c, 0.1], ...kUnlit}), {at: [2.25 * i, 0, 0]}))),
  texture: () => pictured(fieldsPng()),
  'texture-rgb': () => pictured(rgbFields()),
  'texture-grey': () => pictured(greyFields()),
  'texture-palette': () => pictured(paletteFields()),
  'texture-12x20': () => pictured(fieldsPng(12, 20)),
  'texture-x-factor': () =>
      build((b) => b.square(b.material({texture: b.texture(fieldsPng()), colour: [0.8, 0.3, 0.5], ...kUnlit}))),
  'texture-tilted': () => build(
      (b) => b.square(
          b.material({texture: b.texture(fieldsPng()), ...kUnlit}), {node: {rotation: about([1, 0, 0], -60)}})),
  'second-texcoords': () =>
      build((b) => b.square(b.material({texture: b.texture(fieldsPng()), texcoord: 1, ...kUnlit}), {
        attributes: {TEXCOORD_1: b.accessor([0.5, 1, 1, 1, 1, 0.5, 0.5, 0.5], 'VEC2')}
      })),
  'transform-offset': () => transformed({offset: [0.25, 0.5]}, {offset: [-0.25, 0]}, {offset: [0, 1.75]}),
  'transform-scale': () => transformed({scale: [0.5, 0.5]}, {scale: [2, 1]}, {scale: [-1, 1]}),
  'transform-rotation': () =>
      transformed({rotation: Math.PI / 2}, {rotation: Math.PI / 6}, {rotation: -1, scale: [0.5, 0.5]}),
  'transform-all': () => transformed(
      {offset: [0.25, 0.25], rotation: 0.5, scale: [1.5, 1.5]}, {offset: [0.5, 0], scale: [0.5, 1]},
      {offset: [0, 0.5], rotation: Math.PI}),
  'transform-uneven': () => transformed({rotation: 0.5, scale: [1.5, 0.75]}),
  'transform-texcoord': () => build((b) => {
    const material =
        b.material({texture: b.texture(fieldsPng()), transform: {texCoord: 1, offset: [0.25, 0]}, ...kUnlit});
    const TEXCOORD_0 = b.accessor([0, 1, 1, 1, 1, 0, 0, 0], 'VEC2');
    const TEXCOORD_1 = b.accessor([0.5, 1, 1, 1, 1, 0.5, 0.5, 0.5], 'VEC2');
    b.square(material, {attributes: {TEXCOORD_0, TEXCOORD_1}});
  }),
  'wrap-repeat': () => wrapping(kRepeat, kRepeat),
  'wrap-mirror': () => wrapping(kMirror, kMirror),
  'wrap-clamp': () => wrapping(kClamp, kClamp),
  'wrap-mixed': () => wrapping(kMirror, kClamp),
  'vertex-colours': () => vertexColours(() => kUnlit),
  'vertex-colours-bytes': () => vertexColours(() => kUnlit, {type: kUbyte}),
  'vertex-colours-even': () => vertexColours(() => ({colour: [0.6, 1, 0.4], ...kUnlit}), {even: true, type: kUshort}),
  'vertex-alpha-even-blend': () => vertexColours(() => ({...kBlend, ...kUnlit}), {even: true, alpha: true}),
  'vertex-colours-x-factor': () => vertexColours(() => ({colour: [0.5, 1, 0.4], ...kUnlit})),
  'vertex-colours-x-texture': () =>
      vertexColours((b) => ({texture: b.texture(fieldsPng()), colour: [0.9, 0.6, 0.8], ...kUnlit})),
  'vertex-alpha-blend': () => vertexColours(() => ({...kBlend, ...kUnlit}), {alpha: true}),
  'vertex-alpha-mask': () => vertexColours(() => ({...kMask, alphaCutoff: 0.6, ...kUnlit}), {alpha: true}),
  'alpha-opaque': () =>
      before((b) => ({texture: b.texture(fieldsPng(8, 8, steps)), colour: [1, 1, 1, 0.5], ...kUnlit})),
  'alpha-mask': () => before((b) => ({texture: b.texture(fieldsPng(8, 8, steps)), ...kMask, ...kUnlit})),
  'alpha-mask-cutoff': () =>
      before((b) => ({texture: b.texture(fieldsPng(8, 8, steps)), ...kMask, alphaCutoff: 0.3, ...kUnlit})),
  'alpha-mask-factor': () =>
      before((b) => ({texture: b.texture(fieldsPng(8, 8, steps)), colour: [1, 1, 1, 0.7], ...kMask, ...kUnlit})),
  'alpha-blend-factor': () => before(() => ({colour: [0.9, 0.2, 0.2, 0.4], ...kBlend, ...kUnlit})),
  'alpha-blend-texture': () =>
      before((b) => ({texture: b.texture(fieldsPng(8, 8, steps)), colour: [1, 1, 1, 0.8], ...kBlend, ...kUnlit})),
  'alpha-blend-order': overlapping,
  'mask-alone': () =>
      build((b) => b.square(b.material({texture: b.texture(fieldsPng(8, 8, steps)), ...kMask, ...kUnlit}))),
  'facing-light-factor': () => facingLight(() => ({colour: [0.7, 0.2, 0.4]})),
  'facing-light-texture': () => facingLight((b) => ({texture: b.texture(fieldsPng()), colour: [0.8, 0.3, 0.5]})),
  'facing-light-vertices': () =>
      facingLight((b) => ({texture: b.texture(fieldsPng())}), Array(4).fill([0.3, 0.8, 0.5]).flat()),
  'texcoords-bytes': () => integerTexcoords(kUbyte, 255),
  'texcoords-shorts': () => integerTexcoords(kUshort, 65535),
  interleaved,
  'emissive-factor': () => glowing(() => ({emissiveFactor: [0.8, 0.3, 0.05]})),
  'emissive-texture': () =>
      glowing((b) => ({emissiveFactor: [1, 1, 1], emissiveTexture: {index: b.texture(fieldsPng())}})),
  'emissive-strength': () => glowing(
      () =>
          ({emissiveFactor: [0.1, 0.05, 0.2], extensions: {KHR_materials_emissive_strength: {emissiveStrength: 4}}})),
  sides,
  nested,
  quantised,
  sparse,
  'second-scene': secondScene,
  sphere: () => build((b) => b.sphere(b.material())),
  'no-normals': () => build((b) => b.sphere(b.material(), {attributes: [], rings: 6})),
  'light-directional': () => lit({type: 'directional', intensity: kFull}, {rotation: kFromTheRight}),
  'light-two-sided': () =>
      lit({type: 'directional', intensity: kFull}, {},
          (b) => b.square(b.material({doubleSided: true}), {node: {rotation: about([0, 1, 0], 150)}})),
  'light-point': () => lit({type: 'point', intensity: 9 * kFull}, {translation: [0, 0, 3]}),
  'light-spot': () =>
      lit({type: 'spot', intensity: 9 * kFull, spot: {innerConeAngle: 0.1, outerConeAngle: 0.3}},
          {translation: [0, 0, 3]}),
  'light-spot-inside': () =>
      lit({type: 'spot', intensity: 9 * kFull, spot: {innerConeAngle: 0.5, outerConeAngle: 0.6}},
          {translation: [0, 0, 3]}),
  'shared-mesh': shared,
  cameras: seen,
  ...kMovingFiles,
};
