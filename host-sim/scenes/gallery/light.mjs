// Light that is baked into colours and texels: rays are traced to find how much of it arrives at a point.
import {add, cross, dot, minus, random, times, unit} from './shapes.mjs';

const toLinear = (c) => (c <= 10.31 ? c / 3294.6 : ((c / 255 + 0.055) / 1.055) ** 2.4);
const toScreen = (c) => 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

// Boxes in a tree of halves, as an array: of each node its six bounds, the index of its first face, how many it has (0:
// two halves follow), and the node after it and all below it.
const kNode = 9, kFacesOfALeaf = 4;
function boxes(corners, order, first, end, nodes) {
  const at = nodes.length, bounds = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
  for (const face of order.slice(first, end)) {
    for (const corner of corners[face]) {
      corner.forEach((v, k) => {
        // A little larger, so that rounding never loses a face.
        bounds[k] = Math.min(bounds[k], v - 1e-6);
        bounds[k + 3] = Math.max(bounds[k + 3], v + 1e-6);
      });
    }
  }
  nodes.push(...bounds, first, end - first, 0);
  if (end - first > kFacesOfALeaf) {
    nodes[at + 7] = 0;
    const sides = [0, 1, 2].map((k) => bounds[k + 3] - bounds[k]), axis = sides.indexOf(Math.max(...sides));
    const place = (face) => corners[face][0][axis] + corners[face][1][axis] + corners[face][2][axis];
    order.splice(first, end - first, ...order.slice(first, end).sort((a, b) => place(a) - place(b)));
    const middle = (first + end) >> 1;
    boxes(corners, order, first, middle, nodes);
    boxes(corners, order, middle, end, nodes);
  }
  nodes[at + 8] = nodes.length;
  return nodes;
}

// Returns (from, along, reach): whether one of these faces is on the way. `along` has length 1.
export function tracer(faces) {
  const size = 9, order = faces.map((_, i) => i), flat = new Float64Array(faces.length * size);
  const nodes = new Float64Array(boxes(faces.map(({points}) => points), order, 0, faces.length, []));
  order.forEach((face, i) => {
    const [p, q, r] = faces[face].points;
    flat.set([...p, ...minus(q, p), ...minus(r, p)], i * size);
  });
  return ([x, y, z], [a, b, c], reach) => {
    const ia = 1 / a, ib = 1 / b, ic = 1 / c, fromX = a < 0 ? 3 : 0, fromY = b < 0 ? 4 : 1, fromZ = c < 0 ? 5 : 2;
    for (let node = 0; node < nodes.length;) {
      // Which bounds are nearer depends on the ray alone.
      const nx = (nodes[node + fromX] - x) * ia, ny = (nodes[node + fromY] - y) * ib,
            nz = (nodes[node + fromZ] - z) * ic;
      const fx = (nodes[node + 3 - fromX] - x) * ia, fy = (nodes[node + 5 - fromY] - y) * ib,
            fz = (nodes[node + 7 - fromZ] - z) * ic;
      if (nx > fy || nx > fz || ny > fx || ny > fz || nz > fx || nz > fy || fx < 0 || fy < 0 || fz < 0 || nx > reach ||
          ny > reach || nz > reach) {
        node = nodes[node + 8];
        continue;
      }
      const end = (nodes[node + 6] + nodes[node + 7]) * size;
      for (let i = nodes[node + 6] * size; i < end; i += size) {
        const ex = flat[i + 3], ey = flat[i + 4], ez = flat[i + 5], fx = flat[i + 6], fy = flat[i + 7],
              fz = flat[i + 8];
        const hx = b * fz - c * fy, hy = c * fx - a * fz, hz = a * fy - b * fx, det = ex * hx + ey * hy + ez * hz;
        if (Math.abs(det) < 1e-12) continue;
        const sx = x - flat[i], sy = y - flat[i + 1], sz = z - flat[i + 2], u = (sx * hx + sy * hy + sz * hz) / det;
        if (u < 0 || u > 1) continue;
        const kx = sy * ez - sz * ey, ky = sz * ex - sx * ez, kz = sx * ey - sy * ex,
              v = (a * kx + b * ky + c * kz) / det;
        if (v < 0 || u + v > 1) continue;
        const t = (fx * kx + fy * ky + fz * kz) / det;
        if (t > 1e-4 && t < reach) return true;
      }
      node += kNode;
    }
    return false;
  };
}

// Returns (point, normal, colour, seed): the colour that is seen there, 0 to 255, of a surface of this colour.
//   ambient: light from everywhere, [red, green, blue], as far as nothing within `reach` hides it
//   lamps: {at, radius, light}, balls; `light` arrives at distance 1 and falls with its square
//   beams: {along, light, reach(point)}, parallel light, of which reach() is how far its opening is, 0 if it misses it
export function lit({blocked, ambient, reach = 1, lamps = [], beams = [], rays = 48}) {
  return (point, normal, colour, seed = 0) => {
    const from = point.map((p, i) => p + 0.004 * normal[i]);
    const side = unit(cross(normal, Math.abs(normal[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0])), other = cross(side, normal);
    let open = 0;
    for (let ray = 0; ray < rays; ++ray) {
      const r = Math.sqrt((ray + 0.5) / rays), turn = 2.39996 * ray + 6.28 * random(seed);
      const [n, s, o] = [Math.sqrt(1 - r * r), r * Math.cos(turn), r * Math.sin(turn)];
      const along = [
        normal[0] * n + side[0] * s + other[0] * o, normal[1] * n + side[1] * s + other[1] * o,
        normal[2] * n + side[2] * s + other[2] * o
      ];
      if (!blocked(from, along, reach)) ++open;
    }
    const light = times(ambient, open / rays);
    for (const lamp of lamps) {
      const samples = Math.max(1, Math.round(rays / 2));
      for (let i = 0; i < samples; ++i) {
        const h = 1 - 2 * (i + 0.5) / samples, turn = 2.39996 * i + 6.28 * random(seed + 7), w = Math.sqrt(1 - h * h);
        const to = minus(add(lamp.at, times([w * Math.cos(turn), h, w * Math.sin(turn)], lamp.radius)), from);
        const distance = Math.hypot(...to), along = times(to, 1 / distance), facing = dot(along, normal);
        if (facing <= 0 || blocked(from, along, distance - 2 * lamp.radius)) continue;
        lamp.light.forEach((v, k) => (light[k] += v * facing / distance ** 2 / samples));
      }
    }
    for (const beam of beams) {
      const along = times(unit(beam.along), -1), facing = dot(along, normal);
      const far = facing > 0 ? beam.reach(point) : 0;
      if (far <= 0 || blocked(from, along, far)) continue;
      beam.light.forEach((v, k) => (light[k] += v * facing));
    }
    // Bright light approaches white instead of being cut off.
    return colour.map((c, i) => toScreen(1 - Math.exp(-toLinear(c) * light[i])));
  };
}
