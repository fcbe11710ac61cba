// The data of workload R10k, and its meshlets: runs of triangles in the order in which they were drawn at random, so
// that each meshlet covers most of the picture. They save memory, not time.
#include "bounding_sphere.hpp"
#include "triangle_soup.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

consteval std::array<Meshlet, kRandom10kMeshlets> runs(const TriangleSoup<10000>& soup) {
  std::array<Meshlet, kRandom10kMeshlets> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::size_t first = i * kRandomMeshletTriangles;
    const std::size_t triangles = std::min(kRandomMeshletTriangles, soup.triangles.size() - first);
    const BoundingSphere bounds =
        bounding_sphere(std::span(soup.positions).subspan(3 * first, 3 * triangles), kRandom10kHalfExtent);
    result[i] = {.first_triangle = static_cast<std::uint32_t>(first),
                 .first_vertex = static_cast<std::uint16_t>(3 * first),
                 .vertex_count = static_cast<std::uint16_t>(3 * triangles),
                 .triangle_count = static_cast<std::uint16_t>(triangles),
                 .radius = bounds.radius,
                 .centre = bounds.centre};
  }
  return result;
}

}  // namespace

constexpr TriangleSoup<10000> kRandom10k = random_triangles<10000>(60, kRandom10kHalfExtent.x);
constexpr std::array<Meshlet, kRandom10kMeshlets> kRandom10kMeshletTable = runs(kRandom10k);

static_assert(validate(random10k_meshlets.scene));  // the same data as random10k

}  // namespace zstrip::scenes
