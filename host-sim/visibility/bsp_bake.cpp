// Chooses planes, splits by them, and writes the nodes in the order in which the renderer reads them.
#include "visibility/bsp_bake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace zstrip::sim {
namespace {

/// Planes that are tried for a node: more cost time, and save splits.
constexpr std::size_t kCandidates = 12;
constexpr std::size_t kMostPieces = 20000;

struct TreeNode {
  SoupPlane plane;
  std::vector<SoupPolygon> polygons;  ///< in the plane, facing either way
  std::uint32_t front = 0, back = 0;
};

class Builder {
 public:
  Result<Done> build(std::vector<SoupPolygon> polygons, std::uint32_t level) {
    deepest_ = std::max(deepest_, level);
    if (level > kMostBspDepth) {
      return Failure{ExitStatus::usage, fmt::format("the tree would be deeper than {} nodes", kMostBspDepth)};
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back({SoupPlane::of(polygons[best_of(polygons)]), {}, 0, 0});
    const SoupPlane plane = nodes_[index].plane;
    std::vector<SoupPolygon> front, back;
    for (SoupPolygon& polygon : polygons) {
      SoupSplit parts = split(polygon, plane);
      if (parts.front.empty() && parts.back.empty()) {
        nodes_[index].polygons.push_back(std::move(polygon));
        continue;
      }
      splits_ += !parts.front.empty() && !parts.back.empty();
      if (!parts.front.empty()) front.push_back(std::move(parts.front));
      if (!parts.back.empty()) back.push_back(std::move(parts.back));
    }
    pieces_ += nodes_[index].polygons.size();
    if (pieces_ + front.size() + back.size() > kMostPieces) {
      return Failure{ExitStatus::usage, fmt::format("planes cut the scene into more than {} pieces", kMostPieces)};
    }
    polygons = {};
    if (!front.empty()) {
      nodes_[index].front = static_cast<std::uint32_t>(nodes_.size());
      if (Result<Done> built = build(std::move(front), level + 1); !built) return built;
    }
    if (!back.empty()) {
      nodes_[index].back = static_cast<std::uint32_t>(nodes_.size());
      if (Result<Done> built = build(std::move(back), level + 1); !built) return built;
    }
    return Done{};
  }

  const std::vector<TreeNode>& nodes() const { return nodes_; }
  std::uint32_t deepest() const { return deepest_; }
  std::size_t splits() const { return splits_; }

 private:
  /// The polygon whose plane splits few others and leaves about as many in front as behind.
  static std::size_t best_of(const std::vector<SoupPolygon>& polygons) {
    std::size_t best = 0;
    double least = 1e300;
    const std::size_t step = std::max<std::size_t>(1, polygons.size() / kCandidates);
    for (std::size_t i = 0; i < polygons.size(); i += step) {
      const SoupPlane plane = SoupPlane::of(polygons[i]);
      if (plane.degenerate()) continue;
      double front = 0, back = 0, both = 0;
      for (const SoupPolygon& polygon : polygons) {
        bool any_front = false, any_back = false;
        for (const SoupCorner& corner : polygon) {
          const double side = plane.at(corner.position);
          any_front |= side > kOnPlane;
          any_back |= side < -kOnPlane;
        }
        both += any_front && any_back;
        front += any_front;
        back += any_back;
      }
      const double cost = 4 * both + std::abs(front - back);
      if (cost < least) least = cost, best = i;
    }
    return best;
  }

  std::vector<TreeNode> nodes_;
  std::uint32_t deepest_ = 0;
  std::size_t splits_ = 0, pieces_ = 0;
};

/// The plane in the mesh's bounding box, where the renderer asks for the eye's side.
BspNode in_box(const SoupPlane& plane, const Mesh& mesh) {
  const SoupPoint centre{mesh.centre.x / 65536.0, mesh.centre.y / 65536.0, mesh.centre.z / 65536.0};
  SoupPoint n{plane.normal.x * mesh.half_extent.x, plane.normal.y * mesh.half_extent.y,
              plane.normal.z * mesh.half_extent.z};
  double distance = (plane.distance - dot(plane.normal, centre)) * 65536;
  const double length = std::sqrt(dot(n, n));
  n = {n.x / length, n.y / length, n.z / length};
  distance /= length;
  // A plane of a polygon cuts the box, so that its distance is below sqrt(3): the format's 2.
  const auto fixed_30 = [](double value) { return static_cast<std::int32_t>(std::lround(value * (1 << 30))); };
  BspNode node{};
  node.x = fixed_30(n.x), node.y = fixed_30(n.y), node.z = fixed_30(n.z);
  node.distance = fixed_30(std::clamp(distance, -1.99, 1.99));
  return node;
}

}  // namespace

Result<BakedBsp> bake_bsp(const PolygonSoup& soup) {
  if (soup.polygons.empty()) return Failure{ExitStatus::usage, "the scene has no triangle of any area to sort"};
  Builder builder;
  if (const Result<Done> built = builder.build(soup.polygons, 1); !built) return built.failure();
  PolygonSoup ordered{{}, soup.double_sided, soup.smooth, soup.background};
  for (const TreeNode& node : builder.nodes()) {
    ordered.polygons.insert(ordered.polygons.end(), node.polygons.begin(), node.polygons.end());
  }
  Result<SoupScene> scene = SoupScene::of(ordered);
  if (!scene) return scene.failure();
  BakedBsp baked{std::move(*scene), {}, builder.deepest(), builder.splits()};
  std::size_t polygon = 0;
  for (const TreeNode& node : builder.nodes()) {
    BspNode written = in_box(node.plane, baked.scene.mesh());
    const std::size_t first = polygon;
    polygon += node.polygons.size();
    const std::size_t end =
        polygon < ordered.polygons.size() ? baked.scene.first_triangle(polygon) : baked.scene.mesh().triangles.size();
    const std::size_t begin = first < ordered.polygons.size() ? baked.scene.first_triangle(first) : end;
    written.first_triangle = static_cast<std::uint32_t>(begin);
    written.triangle_count = static_cast<std::uint32_t>(end - begin);
    written.front = node.front;
    written.back = node.back;
    baked.nodes.push_back(written);
  }
  return baked;
}

}  // namespace zstrip::sim
