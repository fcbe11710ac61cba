// glTF 2.0 files: read, changed, and written again beside the files that they name.
import {copyFileSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync} from 'node:fs';
import {basename, dirname, extname, join} from 'node:path';

const kMagic = 0x46546c67, kJson = 0x4e4f534a, kBinary = 0x004e4942;

/** `{ json, binary }`; binary: what follows in a GLB file. */
export function readGltf(path) {
  const file = readFileSync(path);
  if (extname(path) !== '.glb') return {json: JSON.parse(file)};
  if (file.readUInt32LE(0) !== kMagic || file.readUInt32LE(16) !== kJson) throw new Error(`${path} is no GLB file`);
  const length = file.readUInt32LE(12);
  return {json: JSON.parse(file.subarray(20, 20 + length)), binary: file.subarray(28 + length)};
}

function glb({json, binary}) {
  const padded = (bytes, filler) => Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, filler)]);
  const chunk = (type, body) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(body.length, 0);
    head.writeUInt32LE(type, 4);
    return Buffer.concat([head, body]);
  };
  const chunks = [chunk(kJson, padded(Buffer.from(JSON.stringify(json)), 0x20))];
  if (binary.length > 0) chunks.push(chunk(kBinary, padded(binary, 0)));
  const head = Buffer.alloc(12);
  head.writeUInt32LE(kMagic, 0);
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + chunks.reduce((sum, each) => sum + each.length, 0), 8);
  return Buffer.concat([head, ...chunks]);
}

export function writeGltf(path, gltf) {
  mkdirSync(dirname(path), {recursive: true});
  writeFileSync(path, gltf.binary ? glb(gltf) : JSON.stringify(gltf.json));
}

/** The folder's files beside `path`, without those that are models themselves, in the folder `to`. */
export function copyNeighbours(path, to) {
  mkdirSync(to, {recursive: true});
  for (const name of readdirSync(dirname(path))) {
    const from = join(dirname(path), name);
    if (name === basename(path) || /\.(gltf|glb)$/.test(name) || !statSync(from).isFile()) continue;
    copyFileSync(from, join(to, name));
  }
}

function eachPrimitive(json, visit) {
  for (const mesh of json.meshes ?? [])
    for (const primitive of mesh.primitives) visit(primitive);
}

/** What has no material gets one of its own, so that it can be changed. */
function giveMaterials(json) {
  json.materials ??= [];
  const added = json.materials.length;
  eachPrimitive(json, (primitive) => (primitive.material ??= added));
  json.materials.push({});
}

function uses(json, extension) { json.extensionsUsed = [...new Set([...(json.extensionsUsed ?? []), extension])]; }

/** Colours and texels as they are. */
export function withoutLight(json) {
  const kUnlit = 'KHR_materials_unlit';
  giveMaterials(json);
  for (const material of json.materials) (material.extensions ??= {})[kUnlit] = {};
  uses(json, kUnlit);
}

/** White, so that the light alone is to be seen. */
export function whitened(json) {
  giveMaterials(json);
  const pbrMetallicRoughness = {metallicFactor: 0, roughnessFactor: 1};
  json.materials = json.materials.map(({name, doubleSided}) => ({name, doubleSided, pbrMetallicRoughness}));
}
