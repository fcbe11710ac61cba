// Shapes of coloured triangles, for the models of the gallery. +y is up; colours are "#rrggbb" or [red, green, blue], 0
// to 255. A shape is a list of faces: {points, colours, texcoords}, three of each, counter-clockwise from outside.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => times(a, 1 / (Math.hypot(...a) || 1));
export const rgb = (colour) =>
    (typeof colour === 'string' ? [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) : colour);
export const mix = (a, b, t) => rgb(a).map((v, i) => v + (rgb(b)[i] - v) * t);

// A repeatable random number below 1, of an integer.
export function random(n) {
  let v = Math.imul(n + 0x9e3779b9, 0x85ebca6b);
  v = Math.imul(v ^ (v >>> 13), 0xc2b2ae35);
  return ((v ^ (v >>> 16)) >>> 0) / 2 ** 32;
}

const face = (points, colour, texcoords = [[0, 0], [0, 0], [0, 0]]) => ({
  points,
  texcoords,
  colours: points.map((p) => rgb(typeof colour === 'function' ? colour(p) : colour)),
});

// A flat, convex polygon; its corners are counter-clockwise.
export function polygon(points, colour, texcoords) {
  return points.slice(2).map(
      (p, i) =>
          face([points[0], points[i + 1], p], colour, texcoords && [texcoords[0], texcoords[i + 1], texcoords[i + 2]]));
}

// A square that faces +z, with all of a texture.
export const card = (half, colour = '#ffffff') => polygon(
    [[-half, -half, 0], [half, -half, 0], [half, half, 0], [-half, half, 0]], colour, [[0, 1], [1, 1], [1, 0], [0, 0]]);

// A grid of points: at(i, j) returns a point, its colour and its texture coordinates. Its front is the side from which
// i goes to the right and j upwards.
export function grid(columns, rows, at) {
  const faces = [];
  const node = (i, j) =>
      ({colour: '#ffffff', texcoord: [i / columns, 1 - j / rows], ...at(i / columns, j / rows, i, j)});
  const corner = (nodes) => ({
    points: nodes.map((n) => n.point),
    colours: nodes.map((n) => rgb(n.colour)),
    texcoords: nodes.map((n) => n.texcoord)
  });
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      const [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
      // The shorter diagonal.
      const [ac, bd] = [Math.hypot(...minus(a.point, c.point)), Math.hypot(...minus(b.point, d.point))];
      const halves = ac <= bd ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]];
      faces.push(
          ...halves.filter(([p, q, r]) => Math.hypot(...cross(minus(q.point, p.point), minus(r.point, p.point))) > 1e-9)
              .map(corner));
    }
  }
  return faces;
}

// A profile of [radius, y, colour] from the top down to the bottom, turned around the y axis. colour may be left out.
// Texture coordinates go once around, and from top to bottom along the profile.
export function lathe(profile, sides, colour = '#ffffff', {from = 0, to = 360, squash = 1} = {}) {
  return grid(sides, profile.length - 1, (u, v, i, j) => {
    const [r, y, own] = profile[profile.length - 1 - j];
    const angle = (from + (to - from) * (u === 1 && to - from === 360 ? 0 : u)) * Math.PI / 180;
    const point = [r * Math.sin(angle), y, r * Math.cos(angle) * squash];
    return {point, colour: own ?? (typeof colour === 'function' ? colour(point) : colour)};
  });
}

export function ball(radius, rings, sides, colour) {
  return lathe(Array.from({length: rings + 1}, (_, i) => {
    const angle = Math.PI * i / rings;
    return [radius * Math.sin(angle) * (i % rings ? 1 : 0), radius * Math.cos(angle)];
  }), sides, colour);
}

// An upright cylinder that begins at y = 0.
export const cylinder = (radius, height, sides, colour, top = radius) =>
    lathe([[0, height], [top, height], [radius, 0], [0, 0]], sides, colour);

// A box around the origin; its edges are cut off by `bevel`.
export function box([x, y, z], colour, bevel = 0) {
  const half = [x / 2, y / 2, z / 2], inner = half.map((v) => v - bevel);
  const faces = [];
  const axes = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];
  const at = (axis, side, other, a, third, b) => {
    const p = [0, 0, 0];
    p[axis] = side * half[axis];
    p[other] = a * inner[other];
    p[third] = b * inner[third];
    return p;
  };
  const turned = (points, outwards) => {
    const n = cross(minus(points[1], points[0]), minus(points[2], points[0]));
    return dot(n, outwards) > 0 ? points : [...points].reverse();
  };
  for (const [a, b, c] of axes) {
    for (const s of [1, -1]) {
      const out = [0, 0, 0];
      out[a] = s;
      const quad = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i, j]) => at(a, s, b, i, c, j));
      const texcoords = [[0, 1], [1, 1], [1, 0], [0, 0]];
      const same = turned(quad, out) === quad;
      faces.push(...polygon(same ? quad : [...quad].reverse(), colour, same ? texcoords : [...texcoords].reverse()));
    }
    if (!bevel) continue;
    for (const s of [1, -1]) {
      for (const t of [1, -1]) {
        const out = [0, 0, 0];
        out[a] = s;
        out[b] = t;
        faces.push(...polygon(
            turned([at(a, s, b, t, c, -1), at(a, s, b, t, c, 1), at(b, t, c, 1, a, s), at(b, t, c, -1, a, s)], out),
            colour));
      }
    }
  }
  if (bevel) {
    for (const i of [1, -1]) {
      for (const j of [1, -1]) {
        for (const k of [1, -1]) {
          faces.push(...polygon(
              turned([at(0, i, 1, j, 2, k), at(1, j, 2, k, 0, i), at(2, k, 0, i, 1, j)], [i, j, k]), colour));
        }
      }
    }
  }
  return faces;
}

// A round bar along points, radius one number or one for each; `across` is a direction that the path never takes.
export function tube(path, radius, sides, colour, across = [1, 0, 0], closed = false) {
  const n = path.length;
  const ring = (j) => {
    const i = closed ? j % n : j;
    const r = radius[i] ?? radius, before = closed ? path[(i + n - 1) % n] : path[Math.max(i - 1, 0)];
    const behind = closed ? path[(i + 1) % n] : path[Math.min(i + 1, n - 1)];
    const along = unit(minus(behind, before)), first = unit(cross(along, across)), second = cross(first, along);
    return (angle) => add(path[i], add(times(first, r * Math.cos(angle)), times(second, r * Math.sin(angle))));
  };
  return grid(
      sides, closed ? n : n - 1, (u, v, i, j) => ({point: ring(j)(-2 * Math.PI * (i % sides) / sides), colour}));
}

// A flat convex outline of [x, y], counter-clockwise, extruded along z from 0 to depth.
export function extruded(outline, depth, colour) {
  const front = outline.map(([x, y]) => [x, y, depth]), back = outline.map(([x, y]) => [x, y, 0]);
  return [
    ...polygon(front, colour), ...polygon([...back].reverse(), colour), ...outline.flatMap((_, i) => {
      const k = (i + 1) % outline.length;
      return polygon([back[i], back[k], front[k], front[i]], colour);
    })
  ];
}

// Moves a shape: scaled, turned by degrees about x, then y, then z, then moved.
export function placed(faces, {at = [0, 0, 0], turn = [0, 0, 0], scale = 1}) {
  const [x, y, z] = turn.map((degrees) => degrees * Math.PI / 180);
  const by = typeof scale === 'number' ? [scale, scale, scale] : scale;
  const move = (p) => {
    let [a, b, c] = p.map((v, i) => v * by[i]);
    [b, c] = [b * Math.cos(x) - c * Math.sin(x), b * Math.sin(x) + c * Math.cos(x)];
    [a, c] = [a * Math.cos(y) + c * Math.sin(y), c * Math.cos(y) - a * Math.sin(y)];
    [a, b] = [a * Math.cos(z) - b * Math.sin(z), a * Math.sin(z) + b * Math.cos(z)];
    return add([a, b, c], at);
  };
  return faces.map((f) => ({...f, points: f.points.map(move)}));
}

export const textured = (faces, texcoord) =>
    faces.map((f) => ({...f, texcoords: f.points.map((p, i) => texcoord(p, f.texcoords[i]))}));
export const scaled = (faces, scale) => placed(faces, {scale});

// Marks the faces of which all corners satisfy `where`, because something else covers them. Models leave them out,
// after light and normals were computed for the whole shape.
export const covered = (faces, where) => faces.map((f) => (f.points.every(where) ? {...f, covered: true} : f));
