// The knot cut into meshlets, with texture coordinates.
#include "zstrip_scenes/knot_meshlets.hpp"

#include "bounding_sphere.hpp"
#include "knot_shape.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

constexpr auto kShape = knot_shape::vertices();

constexpr std::size_t kPatchesAround = kKnotRingVertices / kKnotPatchSides;
static_assert(kKnotRings % kKnotPatchRings == 0 && kKnotRingVertices % kKnotPatchSides == 0);

/// A point in the grid of the open surface: ring 0..kKnotRings, side 0..kKnotRingVertices, both ends included.
struct GridPoint {
  std::size_t ring, side;
};

constexpr GridPoint grid_point(std::size_t cut_vertex) {
  const std::size_t patch = cut_vertex / kKnotPatchVertices, local = cut_vertex % kKnotPatchVertices;
  return {patch / kPatchesAround * kKnotPatchRings + local / (kKnotPatchSides + 1),
          patch % kPatchesAround * kKnotPatchSides + local % (kKnotPatchSides + 1)};
}

/// Returns one element for each vertex of the cut mesh, from the whole mesh.
template <class T>
consteval std::array<T, kKnotMeshletsVertices> cut(const std::array<T, kKnotVertices>& whole) {
  std::array<T, kKnotMeshletsVertices> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const GridPoint at = grid_point(i);
    result[i] = whole[at.ring % kKnotRings * kKnotRingVertices + at.side % kKnotRingVertices];
  }
  return result;
}

/// Repeats the texture eight times along the tube, once around it.
consteval std::array<TexCoord, kKnotMeshletsVertices> texcoords() {
  std::array<TexCoord, kKnotMeshletsVertices> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const GridPoint at = grid_point(i);
    const std::size_t u = ((at.ring * 8 << kKnotTexcoordBits) + kKnotRings / 2) / kKnotRings;  // to nearest
    const std::size_t v = (at.side << kKnotTexcoordBits) / kKnotRingVertices;                  // exact
    result[i] = {static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
  }
  return result;
}

consteval std::array<Triangle, kKnotTriangleCount> triangles() {
  std::array<Triangle, kKnotTriangleCount> result{};
  std::size_t next = 0;
  for (std::size_t patch = 0; patch < kKnotPatches; ++patch) {
    const auto index = [patch](std::size_t ring, std::size_t side) {
      return static_cast<std::uint16_t>(patch * kKnotPatchVertices + ring * (kKnotPatchSides + 1) + side);
    };
    for (std::size_t i = 0; i < kKnotPatchRings; ++i) {
      for (std::size_t j = 0; j < kKnotPatchSides; ++j) {
        const std::uint16_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
        result[next++] = {a, c, b};
        result[next++] = {a, d, c};
      }
    }
  }
  return result;
}

consteval std::array<Meshlet, kKnotPatches> meshlets(const std::array<Position, kKnotMeshletsVertices>& positions) {
  constexpr std::size_t kTriangles = 2 * kKnotPatchRings * kKnotPatchSides;
  std::array<Meshlet, kKnotPatches> result{};
  for (std::size_t patch = 0; patch < kKnotPatches; ++patch) {
    const std::size_t first = patch * kKnotPatchVertices;
    const BoundingSphere bounds =
        bounding_sphere(std::span(positions).subspan(first, kKnotPatchVertices), kKnotHalfExtent);
    result[patch] = {.first_triangle = static_cast<std::uint32_t>(patch * kTriangles),
                     .first_vertex = static_cast<std::uint16_t>(first),
                     .vertex_count = kKnotPatchVertices,
                     .triangle_count = kTriangles,
                     .radius = bounds.radius,
                     .centre = bounds.centre};
  }
  return result;
}

/// Returns tiles of 8 x 8 texels in two colours, with a light joint on two sides of each.
consteval std::array<std::uint16_t, kKnotTexels.size()> texels() {
  constexpr std::uint16_t kJoint = 0xEF5B, kDark = 0x9A46, kLight = 0xDD6B;  // RGB565
  std::array<std::uint16_t, kKnotTexels.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::size_t x = i % (1U << kKnotTextureLog2), y = i >> kKnotTextureLog2;
    const bool joint = x % 8 == 0 || y % 8 == 0;
    result[i] = joint ? kJoint : ((x ^ y) & 8) != 0 ? kDark : kLight;
  }
  return result;
}

}  // namespace

constexpr std::array<Position, kKnotMeshletsVertices> kKnotMeshletsPositions = cut(knot_shape::positions(kShape));
constexpr std::array<Normal, kKnotMeshletsVertices> kKnotMeshletsNormals = cut(knot_shape::normals(kShape));
constexpr std::array<Colour, kKnotMeshletsVertices> kKnotMeshletsColours = cut(knot_shape::colours(kShape));
constexpr std::array<TexCoord, kKnotMeshletsVertices> kKnotMeshletsTexcoords = texcoords();
constexpr std::array<Triangle, kKnotTriangleCount> kKnotMeshletsTriangles = triangles();
constexpr std::array<Meshlet, kKnotPatches> kKnotMeshletTable = meshlets(kKnotMeshletsPositions);
constexpr std::array<std::uint16_t, kKnotTexels.size()> kKnotTexels = texels();

static_assert(validate(knot_meshlets.scene) && validate(knot_textured.scene));

}  // namespace zstrip::scenes
