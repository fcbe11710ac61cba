// Writes shapes as model files: computes normals, darkens corners that other shapes shade, and writes binary glTF.
import fs from 'node:fs';

import {add, cross, dot, minus, random, times, unit} from './shapes.mjs';

const key = (values) => values.map((v) => Math.round(v * 1e4)).join();
const normalOf = ({points: [p, q, r]}) => cross(minus(q, p), minus(r, p));

// Makes vertices with normals: faces that meet at less than `crease` degrees are smooth. Faces of covered() are kept
// separate.
export function welded(faces, crease = 40) {
  const limit = Math.cos(crease * Math.PI / 180), around = new Map();
  const flat = faces.map((f) => ({...f, normal: normalOf(f)}));
  for (const f of flat) {
    for (const p of f.points) around.set(key(p), [...(around.get(key(p)) ?? []), f]);
  }
  const vertices = [], triangles = [], known = new Map();
  for (const f of flat.filter((face) => !face.covered)) {
    triangles.push(f.points.map((p, i) => {
      const near = around.get(key(p)).filter((g) => dot(unit(g.normal), unit(f.normal)) >= limit);
      const normal = unit(near.reduce((sum, g) => add(sum, unit(g.normal)), [0, 0, 0]));
      const own = `${key(p)} ${key(times(normal, 0.01))} ${key(f.colours[i])} ${key(f.texcoords[i])}`;
      if (!known.has(own)) {
        known.set(own, vertices.length);
        vertices.push({position: p, normal, colour: f.colours[i], texcoord: f.texcoords[i]});
      }
      return known.get(own);
    }));
  }
  return {vertices, triangles, covered: flat.filter((f) => f.covered)};
}

export const joined = (a, b) => ({
  vertices: [...a.vertices, ...b.vertices],
  triangles: [...a.triangles, ...b.triangles.map((t) => t.map((i) => i + a.vertices.length))],
  covered: [...a.covered ?? [], ...b.covered ?? []],
});

// A triangle as hit() takes it: a corner, and from it to both others.
const edged = ([p, q, r]) => [p, minus(q, p), minus(r, p)];

function hit([x, y, z], [a, b, c], [[px, py, pz], [ex, ey, ez], [fx, fy, fz]], reach) {
  const hx = b * fz - c * fy, hy = c * fx - a * fz, hz = a * fy - b * fx, det = ex * hx + ey * hy + ez * hz;
  if (Math.abs(det) < 1e-12) return false;
  const sx = x - px, sy = y - py, sz = z - pz, u = (sx * hx + sy * hy + sz * hz) / det;
  if (u < 0 || u > 1) return false;
  const kx = sy * ez - sz * ey, ky = sz * ex - sx * ez, kz = sx * ey - sy * ex, v = (a * kx + b * ky + c * kz) / det;
  if (v < 0 || u + v > 1) return false;
  const t = (fx * kx + fy * ky + fz * kz) / det;
  return t > 1e-3 * reach && t < reach;
}

// Darkens vertices by the share of the sky that faces of `others` and of the mesh itself hide, within `reach`. The
// deepest corner keeps the share `dark` of its colour.
export function occluded(mesh, {others = [], reach = 1, rays = 48, dark = [0.3, 0.3, 0.4]} = {}) {
  // Each with its corners, and how far from them it may hide something.
  const blockers = [
    ...mesh.triangles.map((t) => t.map((i) => mesh.vertices[i].position)),
    ...[...mesh.covered, ...others].map((f) => f.points)
  ].map((b) => ({corners: b.map((p, i) => [...p, reach + Math.hypot(...minus(p, b[(i + 1) % 3]))]), edges: edged(b)}));
  const shares = new Map();
  const share = ({position, normal}) => {
    const at = key([...position, ...normal]);
    if (shares.has(at)) return shares.get(at);
    const [px, py, pz] = position, near = [];
    for (const {corners, edges} of blockers) {
      if (corners.some(([x, y, z, far]) => Math.hypot(x - px, y - py, z - pz) < far)) near.push(edges);
    }
    const from = add(position, times(normal, 0.004 * reach));
    const side = unit(cross(normal, Math.abs(normal[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0])), other = cross(side, normal);
    let open = 0;
    for (let ray = 0; ray < rays; ++ray) {
      const r = Math.sqrt((ray + 0.5) / rays), turn = 2.39996 * ray + random(3);
      const along = add(
          times(normal, Math.sqrt(1 - r * r)), add(times(side, r * Math.cos(turn)), times(other, r * Math.sin(turn))));
      if (!near.some((b) => hit(from, along, b, reach))) ++open;
    }
    shares.set(at, open / rays);
    return open / rays;
  };
  for (const v of mesh.vertices) {
    const open = share(v);
    v.colour = v.colour.map((c, i) => c * (dark[i] + (1 - dark[i]) * open));
  }
  return mesh;
}

const BYTE = 5120, UNSIGNED_BYTE = 5121, SHORT = 5123, FLOAT = 5126;

// Collects the parts of a binary glTF file.
function packer(texcoords) {
  const chunks = [], bufferViews = [], accessors = [];
  let size = 0, triangles = 0, vertices = 0;
  const put = (buffer, accessor, byteStride) => {
    bufferViews.push({buffer: 0, byteOffset: size, byteLength: buffer.length, ...(byteStride && {byteStride})});
    chunks.push(Buffer.concat([buffer, Buffer.alloc((4 - buffer.length % 4) % 4)]));
    size += chunks.at(-1).length;
    accessors.push({bufferView: bufferViews.length - 1, ...accessor});
    return accessors.length - 1;
  };
  const floats = (rows) => Buffer.from(new Float32Array(rows.flat()).buffer);
  const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  // Returns the primitive of a mesh of welded().
  const primitive = (mesh, material) => {
    const count = mesh.vertices.length, places = mesh.vertices.map((v) => v.position);
    const bound = (f) => [0, 1, 2].map((i) => Math.fround(f(...places.map((p) => p[i]))));
    vertices += count;
    triangles += mesh.triangles.length;
    const attributes = {
      POSITION:
          put(floats(places), {componentType: FLOAT, count, type: 'VEC3', min: bound(Math.min), max: bound(Math.max)}),
      NORMAL:
          put(Buffer.from(mesh.vertices.flatMap((v) => [...v.normal.map((n) => Math.round(127 * n)), 0])),
              {componentType: BYTE, normalized: true, count, type: 'VEC3'}, 4),
    };
    if (mesh.vertices.some((v) => v.colour.some((c) => c < 254.5))) {
      const colours = mesh.vertices.flatMap(
          (v) => [...v.colour.map((c) => Math.round(65535 * linear(Math.min(c, 255) / 255))), 65535]);
      attributes.COLOR_0 = put(
          Buffer.from(new Uint16Array(colours).buffer), {componentType: SHORT, normalized: true, count, type: 'VEC4'});
    }
    if (texcoords) {
      attributes.TEXCOORD_0 =
          put(floats(mesh.vertices.map((v) => v.texcoord)), {componentType: FLOAT, count, type: 'VEC2'});
    }
    const indices =
        put(Buffer.from(new Uint16Array(mesh.triangles.flat()).buffer),
            {componentType: SHORT, count: 3 * mesh.triangles.length, type: 'SCALAR'});
    return {attributes, indices, material};
  };
  // Returns the accessor of keyframes' times, or of their values, which are lists.
  const times = (values) => put(floats(values), {
    componentType: FLOAT,
    count: values.length,
    type: 'SCALAR',
    min: [values[0]],
    max: [Math.fround(values.at(-1))]
  });
  const keys = (values) =>
      put(floats(values), {componentType: FLOAT, count: values.length, type: values[0].length === 4 ? 'VEC4' : 'VEC3'});
  const write = (file, materials, content) => {
    const text = JSON.stringify({
      asset: {version: '2.0', copyright: 'public domain'},
      extensionsUsed: ['KHR_mesh_quantization'],
      extensionsRequired: ['KHR_mesh_quantization'],
      scene: 0,
      ...content,
      materials: materials.map((name) => ({name, pbrMetallicRoughness: {metallicFactor: 0}})),
      accessors,
      bufferViews,
      buffers: [{byteLength: size}],
    });
    const json = Buffer.from(text + ' '.repeat((4 - Buffer.byteLength(text) % 4) % 4));
    const head = (length, type) => Buffer.from(new Uint32Array([length, type]).buffer);
    fs.writeFileSync(file, Buffer.concat([
      Buffer.from(new Uint32Array([0x46546c67, 2, 28 + json.length + size]).buffer),
      head(json.length, 0x4e4f534a),
      json,
      head(size, 0x004e4942),
      ...chunks,
    ]));
    console.log(`${file}: ${triangles} triangles, ${vertices} vertices`);
  };
  // Adds to a primitive the joints that move its vertices; returns the accessor of their matrices. places: of the
  // joints, by name; vertex.joints: {joint's name: weight}, at most four, whose sum is 1.
  const bind = (primitive, mesh, places) => {
    const names = Object.keys(places), four = (values) => [...values, 0, 0, 0, 0].slice(0, 4);
    const put4 = (rows, normalized) =>
        put(Buffer.from(rows.flat()), {componentType: UNSIGNED_BYTE, normalized, count: rows.length, type: 'VEC4'});
    primitive.attributes.JOINTS_0 =
        put4(mesh.vertices.map((v) => four(Object.keys(v.joints).map((name) => names.indexOf(name)))), false);
    primitive.attributes.WEIGHTS_0 = put4(
        mesh.vertices.map((v) => {
          const weights = four(Object.values(v.joints).map((weight) => Math.round(255 * weight)));
          weights[0] += 255 - weights.reduce((a, b) => a + b);
          return weights;
        }),
        true);
    const matrices = Object.values(places).map((at) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...at.map((v) => -v), 1]);
    return put(floats(matrices), {componentType: FLOAT, count: matrices.length, type: 'MAT4'});
  };
  return {primitive, times, keys, bind, write};
}

// Writes a binary glTF file. parts: {material name: mesh of welded()}; one node. Texture coordinates only where wanted.
export function writeModel(file, parts, {texcoords = false} = {}) {
  const {primitive, write} = packer(texcoords);
  const primitives = Object.values(parts).map(primitive);
  write(file, Object.keys(parts), {scenes: [{nodes: [0]}], nodes: [{mesh: 0}], meshes: [{primitives}]});
}

// Writes a binary glTF file of parts that move each other. bones: [{name, parent, at, mesh}], those above first; `at`
// is where the bone's joint is, seen from the joint above. clips: {name: {seconds, keys, pose(share)}}; pose() of 0 to
// 1 is {bone's name: {turn: degrees about x, then y, then z; move: from its place}}.
export function writeFigure(file, bones, clips) {
  const pack = packer(false);
  const meshes = bones.map(({mesh}) => ({primitives: [pack.primitive(mesh, 0)]}));
  const nodes = nodesOf(bones).map(({name, ...rest}, mesh) => ({name, mesh, ...rest}));
  pack.write(file, ['figure'], {scenes: [{nodes: [0]}], nodes, meshes, animations: animationsOf(bones, clips, pack)});
}

// Writes a binary glTF file of one mesh whose vertices several joints move. bones and clips: as of writeFigure(),
// without meshes; mesh: of welded(), with `joints` of each vertex: {bone's name: weight}.
export function writeSkin(file, bones, mesh, clips) {
  const pack = packer(false), primitive = pack.primitive(mesh, 0), places = {};
  for (const {name, parent, at} of bones) places[name] = add(places[parent] ?? [0, 0, 0], at);
  const skin = {joints: bones.map((_, i) => i), inverseBindMatrices: pack.bind(primitive, mesh, places)};
  pack.write(file, ['figure'], {
    scenes: [{nodes: [0, bones.length]}],
    nodes: [...nodesOf(bones), {mesh: 0, skin: 0}],
    skins: [skin],
    meshes: [{primitives: [primitive]}],
    animations: animationsOf(bones, clips, pack)
  });
}

function nodesOf(bones) {
  return bones.map(({name, at}) => {
    const children = bones.flatMap(({parent}, k) => (parent === name ? [k] : []));
    return {name, translation: at, ...(children.length && {children})};
  });
}

function animationsOf(bones, clips, {times, keys}) {
  const quaternion = (turn) => {
    const [x, y, z] = turn.map((degrees) => degrees * Math.PI / 360), {sin, cos} = Math;
    return [
      sin(x) * cos(y) * cos(z) - cos(x) * sin(y) * sin(z), cos(x) * sin(y) * cos(z) + sin(x) * cos(y) * sin(z),
      cos(x) * cos(y) * sin(z) - sin(x) * sin(y) * cos(z), cos(x) * cos(y) * cos(z) + sin(x) * sin(y) * sin(z)
    ];
  };
  return Object.entries(clips).map(([name, {seconds, keys: count, pose}]) => {
    const shares = Array.from({length: count + 1}, (_, i) => i / count), poses = shares.map(pose);
    const input = times(shares.map((share) => share * seconds)), samplers = [], channels = [];
    bones.forEach((bone, node) => {
      const add = (path, values) => {
        samplers.push({input, output: keys(values)});
        channels.push({sampler: samplers.length - 1, target: {node, path}});
      };
      if (poses.some((p) => p[bone.name]?.turn)) {
        add('rotation', poses.map((p) => quaternion(p[bone.name]?.turn ?? [0, 0, 0])));
      }
      if (poses.some((p) => p[bone.name]?.move)) {
        add('translation', poses.map((p) => bone.at.map((v, i) => v + (p[bone.name]?.move?.[i] ?? 0))));
      }
    });
    return {name, samplers, channels};
  });
}
