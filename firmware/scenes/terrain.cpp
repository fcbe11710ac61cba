// The hills, computed at compile time: products of waves, coloured by height and by their angle to the sun.
#include "zstrip_scenes/terrain.hpp"

#include "bounding_sphere.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

constexpr std::size_t kSide = kTerrainTiles * kTerrainTileQuads + 1;  // vertices of the whole grid
constexpr double kExtent = 120, kHeight = 9, kStep = 2 * kExtent / (kSide - 1);

/// height * sin(across x + x_phase) * sin(along z + z_phase)
struct Wave {
  double height, across, x_phase, along, z_phase;
};
constexpr Wave kWaves[] = {{5, 0.045, 2.9, 0.04, 1.9}, {2.6, 0.13, 2.2, 0.11, 0.4}, {1, 0.31, 2.2, 0.29, 2}};

/// The grid has one more row and column beyond each border, for slopes: point i lies at (i - 1) * kStep - kExtent.
constexpr std::size_t kPoints = kSide + 2;
using Heights = std::array<std::array<double, kPoints>, kPoints>;

consteval Heights heights() {
  Heights result{};
  for (const Wave& wave : kWaves) {
    std::array<double, kPoints> along{};
    for (std::size_t i = 0; i < kPoints; ++i) {
      along[i] = compile_time::sine(wave.along * ((static_cast<double>(i) - 1) * kStep - kExtent) + wave.z_phase);
    }
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double x = (static_cast<double>(i) - 1) * kStep - kExtent;
      const double across = wave.height * compile_time::sine(wave.across * x + wave.x_phase);
      for (std::size_t j = 0; j < kPoints; ++j) result[i][j] += across * along[j];
    }
  }
  return result;
}

constexpr Heights kHeights = heights();

/// The grid point of a tile's vertex.
struct GridPoint {
  std::size_t x, z;
};

constexpr GridPoint grid_point(std::size_t vertex) {
  const std::size_t tile = vertex / kTerrainTileVertices, local = vertex % kTerrainTileVertices;
  return {tile % kTerrainTiles * kTerrainTileQuads + local % (kTerrainTileQuads + 1),
          tile / kTerrainTiles * kTerrainTileQuads + local / (kTerrainTileQuads + 1)};
}

consteval std::array<Position, kTerrainVertices> positions() {
  const auto on_grid = [](double value, double extent) consteval {
    return compile_time::grid_step(compile_time::nearest(value * 32767 / extent));
  };
  std::array<Position, kTerrainVertices> result{};
  for (std::size_t i = 0; i < kTerrainVertices; ++i) {
    const GridPoint at = grid_point(i);
    const double x = static_cast<double>(at.x) * kStep - kExtent, z = static_cast<double>(at.z) * kStep - kExtent;
    result[i] = {on_grid(x, kExtent), on_grid(kHeights[at.x + 1][at.z + 1], kHeight), on_grid(z, kExtent)};
  }
  return result;
}

/// Returns colours from grass over rock to snow.
consteval std::array<Colour, kTerrainVertices> colours() {
  constexpr double kGround[3][3] = {{70, 125, 55}, {140, 120, 90}, {250, 250, 255}};
  std::array<Colour, kTerrainVertices> result{};
  for (std::size_t i = 0; i < kTerrainVertices; ++i) {
    const GridPoint at = grid_point(i);
    const double height = kHeights[at.x + 1][at.z + 1];
    const double slope_x = (kHeights[at.x + 2][at.z + 1] - kHeights[at.x][at.z + 1]) / (2 * kStep);
    const double slope_z = (kHeights[at.x + 1][at.z + 2] - kHeights[at.x + 1][at.z]) / (2 * kStep);
    const double length = compile_time::square_root(1 + slope_x * slope_x + slope_z * slope_z);
    const double sun = (0.6 + 0.7 * slope_x - 0.4 * slope_z) / length;  // from the left, in front
    const double light = 0.3 + (sun > 0 ? 0.8 * sun : 0);
    const double above = (height + 5) / 6;  // 0 grass, 1 rock, 2 snow
    const double clamped = above < 0 ? 0 : above > 1.999 ? 1.999 : above;
    const auto lower = static_cast<std::size_t>(clamped);
    const auto channel = [&](std::size_t c) {
      const double share = clamped - static_cast<double>(lower);
      const double value = light * (kGround[lower][c] * (1 - share) + kGround[lower + 1][c] * share);
      return static_cast<std::uint8_t>(value > 255 ? 255 : value);
    };
    result[i] = {channel(0), channel(1), channel(2), 255};
  }
  return result;
}

consteval std::array<Triangle, kTerrainTriangleCount> triangles() {
  std::array<Triangle, kTerrainTriangleCount> result{};
  std::size_t next = 0;
  for (std::size_t tile = 0; tile < kTerrainTiles * kTerrainTiles; ++tile) {
    for (std::size_t quad = 0; quad < kTerrainTileQuads * kTerrainTileQuads; ++quad) {
      const std::size_t row = quad / kTerrainTileQuads, column = quad % kTerrainTileQuads;
      const auto index = [tile](std::size_t x, std::size_t z) {
        return static_cast<std::uint16_t>(tile * kTerrainTileVertices + z * (kTerrainTileQuads + 1) + x);
      };
      const std::uint16_t a = index(column, row), b = index(column, row + 1), c = index(column + 1, row + 1),
                          d = index(column + 1, row);
      result[next++] = {a, b, c};
      result[next++] = {a, c, d};
    }
  }
  return result;
}

consteval std::array<Meshlet, kTerrainTiles * kTerrainTiles> meshlets(
    const std::array<Position, kTerrainVertices>& points) {
  std::array<Meshlet, kTerrainTiles * kTerrainTiles> result{};
  for (std::size_t tile = 0; tile < result.size(); ++tile) {
    const std::size_t first = tile * kTerrainTileVertices;
    const BoundingSphere bounds =
        bounding_sphere(std::span(points).subspan(first, kTerrainTileVertices), kTerrainHalfExtent);
    result[tile] = {.first_triangle = static_cast<std::uint32_t>(tile * kTerrainTileTriangles),
                    .first_vertex = static_cast<std::uint16_t>(first),
                    .vertex_count = kTerrainTileVertices,
                    .triangle_count = kTerrainTileTriangles,
                    .radius = bounds.radius,
                    .centre = bounds.centre};
  }
  return result;
}

}  // namespace

constexpr std::array<Position, kTerrainVertices> kTerrainPositions = positions();
constexpr std::array<Colour, kTerrainVertices> kTerrainColours = colours();
constexpr std::array<Triangle, kTerrainTriangleCount> kTerrainTriangles = triangles();
constexpr std::array<Meshlet, kTerrainTiles* kTerrainTiles> kTerrainMeshlets = meshlets(kTerrainPositions);

static_assert(validate(terrain.scene));

}  // namespace zstrip::scenes
