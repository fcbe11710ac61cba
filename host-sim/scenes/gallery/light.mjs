// Light that is baked into colours and texels: rays are traced to find how much of it arrives at a point.
import {cross, dot, minus, random, times, unit} from './shapes.mjs';

const toLinear = (c) => (c <= 10.31 ? c / 3294.6 : ((c / 255 + 0.055) / 1.055) ** 2.4);
const toScreen = (c) => 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

// Returns (from, along, reach): whether one of these faces is on the way. `along` has length 1.
export function tracer(faces) {
  const size = 13, flat = new Float64Array(faces.length * size);
  faces.forEach(({points: [p, q, r]}, i) => {
    const middle = [0, 1, 2].map((k) => (p[k] + q[k] + r[k]) / 3);
    const radius = Math.max(...[p, q, r].map((corner) => Math.hypot(...minus(corner, middle))));
    flat.set([...p, ...minus(q, p), ...minus(r, p), ...middle, radius], i * size);
  });
  return ([x, y, z], [a, b, c], reach) => {
    for (let i = 0; i < flat.length; i += size) {
      const mx = flat[i + 9] - x, my = flat[i + 10] - y, mz = flat[i + 11] - z, radius = flat[i + 12];
      const ahead = mx * a + my * b + mz * c;
      if (ahead < -radius || ahead > reach + radius) continue;
      if (mx * mx + my * my + mz * mz - ahead * ahead > radius * radius) continue;
      const ex = flat[i + 3], ey = flat[i + 4], ez = flat[i + 5], fx = flat[i + 6], fy = flat[i + 7], fz = flat[i + 8];
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
      if (!blocked(from, normal.map((v, i) => v * n + side[i] * s + other[i] * o), reach)) ++open;
    }
    const light = times(ambient, open / rays);
    for (const lamp of lamps) {
      const samples = Math.max(1, Math.round(rays / 2));
      for (let i = 0; i < samples; ++i) {
        const h = 1 - 2 * (i + 0.5) / samples, turn = 2.39996 * i + 6.28 * random(seed + 7), w = Math.sqrt(1 - h * h);
        const to = minus(lamp.at.map((v, k) => v + lamp.radius * [w * Math.cos(turn), h, w * Math.sin(turn)][k]), from);
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
