// The knot as one piece.
#include "zstrip_scenes/knot.hpp"

#include "knot_shape.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

constexpr auto kShape = knot_shape::vertices();

/// Returns two triangles for each quad of the closed grid, in the order of the workload and with its first vertices,
/// but counter-clockwise from outside: the workload's own (a, b, c), (a, c, d) face inwards.
consteval std::array<Triangle, kKnotTriangleCount> closed_grid() {
  const auto index = [](std::size_t ring, std::size_t side) {
    return static_cast<std::uint16_t>(ring % kKnotRings * kKnotRingVertices + side % kKnotRingVertices);
  };
  std::array<Triangle, kKnotTriangleCount> triangles{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < kKnotRings; ++i) {
    for (std::size_t j = 0; j < kKnotRingVertices; ++j) {
      const std::uint16_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      triangles[next++] = {a, c, b};
      triangles[next++] = {a, d, c};
    }
  }
  return triangles;
}

/// Returns FNV-1a of the coordinates, to prove that every compiler gets the same bits from floating point.
consteval std::uint32_t fingerprint(const std::array<Position, kKnotVertices>& positions) {
  std::uint32_t hash = 2166136261;
  for (const Position& p : positions) {
    for (const std::int16_t value : {p.x, p.y, p.z}) {
      hash = (hash ^ static_cast<std::uint16_t>(value)) * 16777619;
    }
  }
  return hash;
}

}  // namespace

constexpr std::array<Position, kKnotVertices> kKnotPositions = knot_shape::positions(kShape);
constexpr std::array<Normal, kKnotVertices> kKnotNormals = knot_shape::normals(kShape);
constexpr std::array<Colour, kKnotVertices> kKnotColours = knot_shape::colours(kShape);
constexpr std::array<Triangle, kKnotTriangleCount> kKnotTriangles = closed_grid();

static_assert(fingerprint(kKnotPositions) == 0xD69BD6EE);
static_assert(validate(knot.scene) && validate(knot_flat.scene) && validate(knot_lit.scene));

}  // namespace zstrip::scenes
