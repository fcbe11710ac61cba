// Writes teapot.cpp and teapot_meshlets.cpp from the Utah teapot of the npm package `teapot` 1.0.0 (public domain).
// Usage: node generate.mjs <path to the package's teapot.js>; prints what teapot.hpp and teapot_meshlets.hpp declare.
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const GRID = 32767; // largest Position
const MESHLET_VERTICES = 64;
const source = createRequire(import.meta.url)(resolve(process.argv[2]));

const subtract = (a, b) => a.map((value, axis) => value - b[axis]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = (a) => Math.hypot(...a);

// One vertex for each position: the patches of the source repeat the vertices along their seams.
function weld(positions, cells) {
  const indexOf = new Map();
  const welded = [];
  const target = positions.map((position) => {
    const key = position.join();
    if (!indexOf.has(key)) indexOf.set(key, welded.push(position) - 1);
    return indexOf.get(key);
  });
  const triangles = cells
    .map((cell) => cell.map((vertex) => target[vertex]))
    .filter(([a, b, c]) => a !== b && b !== c && c !== a);
  return { positions: welded, triangles };
}

// The sum of the face normals around a vertex, weighted by the angle of each face there: does not depend on how
// the quads of the source were cut into triangles.
function smoothNormals(positions, triangles) {
  const sums = positions.map(() => [0, 0, 0]);
  for (const corners of triangles) {
    const [a, b, c] = corners.map((vertex) => positions[vertex]);
    const normal = cross(subtract(b, a), subtract(c, a));
    const scale = 1 / length(normal);
    corners.forEach((vertex, corner) => {
      const here = positions[vertex];
      const next = subtract(positions[corners[(corner + 1) % 3]], here);
      const previous = subtract(positions[corners[(corner + 2) % 3]], here);
      const angle = Math.atan2(length(cross(next, previous)), dot(next, previous));
      for (let axis = 0; axis < 3; ++axis) sums[vertex][axis] += angle * scale * normal[axis];
    });
  }
  return sums.map((sum) => sum.map((value) => Math.round((127 * value) / length(sum)))); // 1.7
}

// The bounding box becomes the grid; its longest side is two world units.
function quantise(positions) {
  const axes = [0, 1, 2];
  const low = axes.map((axis) => Math.min(...positions.map((p) => p[axis])));
  const high = axes.map((axis) => Math.max(...positions.map((p) => p[axis])));
  const centre = axes.map((axis) => (low[axis] + high[axis]) / 2);
  const half = axes.map((axis) => (high[axis] - low[axis]) / 2);
  const unit = Math.max(...half);
  return {
    grid: positions.map((p) => axes.map((axis) => Math.round(((p[axis] - centre[axis]) / half[axis]) * GRID))),
    halfExtent: half.map((value) => Math.round(((value / unit) * 65536 * 32768) / GRID)), // 16.16
  };
}

// Grows one meshlet after another: always the neighbouring triangle that adds the fewest vertices, then the nearest.
function cutIntoMeshlets(positions, triangles) {
  const remaining = new Set(triangles.keys());
  const meshlets = [];
  while (remaining.size > 0) {
    const vertices = new Set();
    const members = [];
    const sum = [0, 0, 0];
    let next = remaining.values().next().value;
    while (next !== undefined) {
      members.push(next);
      remaining.delete(next);
      for (const vertex of triangles[next]) {
        if (vertices.has(vertex)) continue;
        vertices.add(vertex);
        positions[vertex].forEach((value, axis) => (sum[axis] += value));
      }
      const centre = sum.map((value) => value / vertices.size);
      let best = [Infinity, Infinity];
      next = undefined;
      for (const candidate of remaining) {
        const added = triangles[candidate].filter((vertex) => !vertices.has(vertex));
        if (added.length === 3 || vertices.size + added.length > MESHLET_VERTICES) continue;
        const far = Math.max(0, ...added.map((vertex) => length(subtract(positions[vertex], centre))));
        if (added.length > best[0] || (added.length === best[0] && far >= best[1])) continue;
        best = [added.length, far];
        next = candidate;
      }
    }
    meshlets.push({ vertices: [...vertices], triangles: members });
  }
  return meshlets;
}

// The sphere around the centre of the box; its radius counts in grid steps of the longest axis, rounded up.
function boundingSphere(grid, halfExtent, vertices) {
  const axes = [0, 1, 2];
  const centre = axes.map((axis) => {
    const values = vertices.map((vertex) => grid[vertex][axis]);
    return Math.round((Math.min(...values) + Math.max(...values)) / 2);
  });
  const scale = halfExtent.map((value) => value / Math.max(...halfExtent));
  const distance = (vertex) => length(subtract(grid[vertex], centre).map((value, axis) => value * scale[axis]));
  return { centre, radius: Math.ceil(Math.max(...vertices.map(distance))) };
}

function table(type, name, size, rows) {
  let text = `constexpr ${type} ${name}[${size}] = {\n`;
  let line = "   ";
  for (const row of rows) {
    const item = ` {${row}},`;
    if (line.length + item.length > 120) {
      text += line + "\n";
      line = "   ";
    }
    line += item;
  }
  return text + line + "\n};\n";
}

function write(file, purpose, name, tables) {
  const text = `// ${purpose}
// Origin: Martin Newell's teapot (1975), public domain, as triangulated in the npm package \`teapot\` 1.0.0 (public
// domain). Generated by generate.mjs: welded, quantised to the bounding box, smooth normals.
#include "zstrip_scenes/${name}.hpp"

#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {

// clang-format off
${tables.join("\n")}// clang-format on

static_assert(validate(${name}.scene));

}  // namespace zstrip::scenes
`;
  writeFileSync(new URL(file, import.meta.url), text);
}

const { positions, triangles } = weld(source.positions, source.cells);
const normals = smoothNormals(positions, triangles);
const { grid, halfExtent } = quantise(positions);
write("teapot.cpp", "The Utah teapot as one piece.", "teapot", [
  table("Position", "kTeapotPositions", "kTeapotVertices", grid),
  table("Normal", "kTeapotNormals", "kTeapotVertices", normals.map((normal) => [...normal, 0])),
  table("Triangle", "kTeapotTriangles", "kTeapotTriangleCount", triangles),
]);

const cut = { grid: [], normals: [], triangles: [], meshlets: [] };
for (const meshlet of cutIntoMeshlets(positions, triangles)) {
  const { centre, radius } = boundingSphere(grid, halfExtent, meshlet.vertices);
  const first = cut.grid.length;
  const local = new Map(meshlet.vertices.map((vertex, index) => [vertex, first + index]));
  cut.meshlets.push(
    `${cut.triangles.length}, ${first}, ${meshlet.vertices.length}, ${meshlet.triangles.length}, ${radius}, {${centre}}`,
  );
  for (const vertex of meshlet.vertices) {
    cut.grid.push(grid[vertex]);
    cut.normals.push([...normals[vertex], 0]);
  }
  for (const triangle of meshlet.triangles) cut.triangles.push(triangles[triangle].map((vertex) => local.get(vertex)));
}
write("teapot_meshlets.cpp", "The Utah teapot cut into meshlets.", "teapot_meshlets", [
  table("Position", "kTeapotMeshletsPositions", "kTeapotMeshletsVertices", cut.grid),
  table("Normal", "kTeapotMeshletsNormals", "kTeapotMeshletsVertices", cut.normals),
  table("Triangle", "kTeapotMeshletsTriangles", "kTeapotTriangleCount", cut.triangles),
  table("Meshlet", "kTeapotMeshletTable", "kTeapotMeshletCount", cut.meshlets),
]);

console.log(`half extent ${halfExtent}; ${grid.length} vertices, ${triangles.length} triangles`);
console.log(`as meshlets: ${cut.grid.length} vertices in ${cut.meshlets.length} meshlets`);
