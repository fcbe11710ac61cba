// Puts glTF files together: buffers, materials, squares, spheres and cubes.

export const kFloat = 5126, kShort = 5122, kUbyte = 5121, kUshort = 5123;
const kArrays = {
  [kFloat]: Float32Array,
  [kShort]: Int16Array,
  [kUbyte]: Uint8Array,
  [kUshort]: Uint16Array
};
const kWidths = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT4: 16
};

/** Adding returns the index of what was added. */
export class Builder {
  json = {
    asset: {version: '2.0'},
    scene: 0,
    scenes: [{nodes: []}],
    nodes: [],
    meshes: [],
    materials: [],
    accessors: [],
    bufferViews: [],
    buffers: []
  };
  #bytes = [];
  #length = 0;

  view(bytes) {
    this.#bytes.push(bytes, Buffer.alloc(-bytes.length & 3));
    this.json.bufferViews.push({buffer: 0, byteOffset: this.#length, byteLength: bytes.length});
    this.#length += bytes.length + (-bytes.length & 3);
    return this.json.bufferViews.length - 1;
  }

  accessor(values, type, componentType = kFloat, more = {}) {
    const array = kArrays[componentType].from(values);
    const bufferView = this.view(Buffer.from(array.buffer));
    const width = kWidths[type];
    const accessor = {bufferView, componentType, type, count: array.length / width, ...more};
    if (width <= 4) {
      const column = (c) => [...array].filter((_, i) => i % width === c);
      accessor.min = Array.from({length: width}, (_, c) => Math.min(...column(c)));
      accessor.max = Array.from({length: width}, (_, c) => Math.max(...column(c)));
    }
    this.json.accessors.push(accessor);
    return this.json.accessors.length - 1;
  }

  add(list, what) {
    (this.json[list] ??= []).push(what);
    return this.json[list].length - 1;
  }

  material(what = {}) {
    const {colour, texture, texcoord, transform, extensions, ...rest} = what;
    const pbrMetallicRoughness = {metallicFactor: 0, roughnessFactor: 1};
    if (colour) pbrMetallicRoughness.baseColorFactor = colour.length === 3 ? [...colour, 1] : colour;
    if (texture !== undefined) {
      pbrMetallicRoughness.baseColorTexture = {index: texture};
      if (texcoord) pbrMetallicRoughness.baseColorTexture.texCoord = texcoord;
      if (transform) {
        pbrMetallicRoughness.baseColorTexture.extensions = {KHR_texture_transform: transform};
        this.use('KHR_texture_transform');
      }
    }
    for (const name of Object.keys(extensions ?? {})) this.use(name);
    return this.add('materials', {pbrMetallicRoughness, ...(extensions ? {extensions} : {}), ...rest});
  }

  use(name, required = false) {
    for (const list of required ? ['extensionsUsed', 'extensionsRequired'] : ['extensionsUsed']) {
      this.json[list] = [...new Set([...(this.json[list] ?? []), name])];
    }
  }

  /** A texture of a PNG file. */
  texture(png, sampler = {}) {
    const source = this.add('images', {mimeType: 'image/png', bufferView: this.view(png)});
    return this.add(
        'textures', {source, sampler: this.add('samplers', {magFilter: 9728, minFilter: 9728, ...sampler})});
  }

  /** A node of the scene with a mesh of one primitive. */
  node(primitive, node = {}) { return this.root({mesh: this.add('meshes', {primitives: [primitive]}), ...node}); }

  root(node) {
    const index = this.add('nodes', node);
    this.json.scenes[0].nodes.push(index);
    return index;
  }

  /**
   * A square in the plane of x and y, seen from +z, its sides `side` long. `attributes`: accessors beside positions.
   */
  square(material, {at = [0, 0, 0], side = 2, texcoords = [0, 1], attributes = {}, back = false, node = {}} = {}) {
    const h = side / 2;
    const [low, high] = texcoords;
    const all = {POSITION: this.accessor([-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0], 'VEC3'), ...attributes};
    if (texcoords && !('TEXCOORD_0' in attributes)) {
      all.TEXCOORD_0 = this.accessor([low, high, high, high, high, low, low, low], 'VEC2');
    }
    all.NORMAL ??= this.accessor([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1], 'VEC3');
    const indices = this.accessor(back ? [0, 2, 1, 0, 3, 2] : [0, 1, 2, 0, 2, 3], 'SCALAR', kUshort);
    return this.node(
        {attributes: all, indices, ...(material === undefined ? {} : {material})}, {translation: at, ...node});
  }

  /** A sphere of radius 1, finely divided: what interpolation of light between vertices does is little. */
  sphere(material, {attributes = ['NORMAL'], rings = 48, node = {}} = {}) {
    const sectors = 2 * rings, places = [], indices = [];
    for (let i = 0; i <= rings; ++i) {
      for (let j = 0; j <= sectors; ++j) {
        const theta = (Math.PI * i) / rings, phi = (2 * Math.PI * j) / sectors;
        places.push(Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi));
        if (i === rings || j === sectors) continue;
        const at = i * (sectors + 1) + j, below = at + sectors + 1;
        indices.push(at, below, below + 1, at, below + 1, at + 1);
      }
    }
    const all = {POSITION: this.accessor(places, 'VEC3')};
    for (const name of attributes) all[name] = this.accessor(places, 'VEC3');
    return this.node({attributes: all, indices: this.accessor(indices, 'SCALAR', kUshort), material}, node);
  }

  /** A cube with normals, its sides 2 long. */
  cube(material, node = {}) {
    const places = [], normals = [], indices = [];
    for (const axis of [0, 1, 2]) {
      for (const sign of [-1, 1]) {
        const first = places.length / 3;
        for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
          const place = [0, 0, 0], normal = [0, 0, 0];
          place[axis] = normal[axis] = sign;
          place[(axis + 1) % 3] = sign * u;
          place[(axis + 2) % 3] = v;
          places.push(...place);
          normals.push(...normal);
        }
        indices.push(...[0, 1, 2, 0, 2, 3].map((i) => first + i));
      }
    }
    const attributes = {POSITION: this.accessor(places, 'VEC3'), NORMAL: this.accessor(normals, 'VEC3')};
    return this.node({attributes, indices: this.accessor(indices, 'SCALAR', kUshort), material}, node);
  }

  finish() {
    const bytes = Buffer.concat(this.#bytes);
    this.json.buffers =
        [{byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString('base64')}`}];
    for (const list of Object.keys(this.json)) {
      if (Array.isArray(this.json[list]) && this.json[list].length === 0) delete this.json[list];
    }
    return this.json;
  }
}

/** A file, made by `make(builder)`. */
export function build(make) {
  const builder = new Builder();
  make(builder);
  return builder.finish();
}

/** The quaternion of a turn about an axis of length 1. */
export const about = (axis, degrees) => {
  const half = (degrees * Math.PI) / 360;
  return [...axis.map((c) => c * Math.sin(half)), Math.cos(half)];
};
