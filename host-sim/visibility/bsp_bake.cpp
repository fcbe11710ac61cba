// Chooses planes, splits polygons by them, and writes the nodes in the order in which the renderer reads them.
#include "visibility/bsp_bake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/number.hpp"

namespace zstrip::sim {
namespace {

/// Number of polygons' planes that are tried for a node, and of polygons that each plane is tried on. A greater number
/// costs more time, and saves splits.
constexpr std::size_t kCandidates = 24;
constexpr std::size_t kTried = 600;
/// The cost of a split, expressed as a difference between the numbers of polygons on both sides.
constexpr double kCostOfSplit = 8;
constexpr std::size_t kMaxPieces = 65535;

struct TreeNode {
  SoupPlane plane;
  std::vector<SoupPolygon> polygons;  ///< in the plane, facing either way
  std::uint32_t front = 0, back = 0, parent = 0;
  std::uint32_t level = 1;
};

/// The polygons that a plane leaves on each side, and those that it cuts.
struct Sides {
  double front = 0, back = 0, cut = 0;
  double cost() const { return kCostOfSplit * cut + std::abs(front - back); }
};

Sides sides_of(const SoupPlane& plane, const std::vector<SoupPolygon>& polygons) {
  Sides sides;
  const std::size_t step = std::max<std::size_t>(1, polygons.size() / kTried);
  for (std::size_t i = 0; i < polygons.size(); i += step) {
    bool any_front = false, any_back = false;
    for (const SoupCorner& corner : polygons[i]) {
      const double side = plane.at(corner.position);
      any_front |= side > kOnPlane;
      any_back |= side < -kOnPlane;
    }
    sides.cut += any_front && any_back;
    sides.front += any_front && !any_back;
    sides.back += any_back && !any_front;
  }
  return sides;
}

/// Chooses planes that split few polygons and leave about as many on either side, so that a mesh's tree stays shallow.
/// It tries the planes of polygons, which have all of a convex surface behind them, and planes that halve the box along
/// an axis.
class PlaneChoice {
 public:
  explicit PlaneChoice(const std::vector<SoupPolygon>& polygons) : polygons_(polygons) {}

  SoupPlane best() const {
    double least = 1e300;
    SoupPlane chosen;
    const auto consider = [&](const SoupPlane& plane, const Sides& sides) {
      if (sides.cost() < least) least = sides.cost(), chosen = plane;
    };
    const std::size_t step = std::max<std::size_t>(1, polygons_.size() / kCandidates);
    for (std::size_t i = 0; i < polygons_.size(); i += step) {
      const SoupPlane plane = SoupPlane::of(polygons_[i]);
      consider(plane, sides_of(plane, polygons_));
    }
    constexpr std::size_t kWorthHalving = 16;
    if (polygons_.size() < kWorthHalving) return chosen;
    for (double SoupPoint::*axis : {&SoupPoint::x, &SoupPoint::y, &SoupPoint::z}) {
      const SoupPlane plane = halving(axis);
      const Sides sides = sides_of(plane, polygons_);
      if (sides.front > 0 && sides.back > 0) consider(plane, sides);  // otherwise all could be on one side
    }
    return chosen;
  }

 private:
  /// Returns the plane that leaves as many first corners on one side as on the other.
  SoupPlane halving(double SoupPoint::*axis) const {
    std::vector<double> places;
    for (const SoupPolygon& polygon : polygons_) places.push_back(polygon[0].position.*axis);
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), middle, places.end());
    SoupPlane plane;
    plane.normal.*axis = 1;
    plane.distance = *middle;
    return plane;
  }

  const std::vector<SoupPolygon>& polygons_;
};

class Builder {
 public:
  Result<Done> build(std::vector<SoupPolygon> all) {
    std::vector<Waiting> waiting;
    waiting.push_back({std::move(all), 0, nullptr});
    const std::size_t triangles = waiting.back().polygons.size();
    std::size_t pieces = triangles;
    while (!waiting.empty()) {
      Waiting now = std::move(waiting.back());
      waiting.pop_back();
      const auto index = static_cast<std::uint32_t>(nodes_.size());
      TreeNode node;
      if (now.side != nullptr) {
        node.parent = now.parent;
        node.level = nodes_[now.parent].level + 1;
        nodes_[now.parent].*now.side = index;
      }
      deepest_ = std::max(deepest_, node.level);
      const std::size_t before = now.polygons.size();
      Waiting front{{}, index, &TreeNode::front}, back{{}, index, &TreeNode::back};
      divide(std::move(now.polygons), node, front.polygons, back.polygons);
      pieces += node.polygons.size() + front.polygons.size() + back.polygons.size() - before;
      if (pieces > kMaxPieces) {
        return Failure{ExitStatus::usage,
                       fmt::format("the planes of the tree cut {} triangles into more than {} pieces",
                                   grouped(triangles), grouped(kMaxPieces))};
      }
      nodes_.push_back(std::move(node));
      if (!back.polygons.empty()) waiting.push_back(std::move(back));
      if (!front.polygons.empty()) waiting.push_back(std::move(front));
    }
    return Done{};
  }

  const std::vector<TreeNode>& nodes() const { return nodes_; }
  std::uint32_t deepest() const { return deepest_; }
  std::size_t splits() const { return splits_; }

 private:
  struct Waiting {
    std::vector<SoupPolygon> polygons;
    std::uint32_t parent;
    std::uint32_t TreeNode::*side;  ///< null: the root
  };

  void divide(std::vector<SoupPolygon> polygons, TreeNode& node, std::vector<SoupPolygon>& front,
              std::vector<SoupPolygon>& back) {
    node.plane = PlaneChoice(polygons).best();
    for (SoupPolygon& polygon : polygons) {
      SoupSplit parts = split(polygon, node.plane);
      if (parts.front.empty() && parts.back.empty()) {
        node.polygons.push_back(std::move(polygon));
        continue;
      }
      splits_ += !parts.front.empty() && !parts.back.empty();
      // A part that is too thin to have a plane also has no pixel.
      if (!SoupPlane::of(parts.front).degenerate()) front.push_back(std::move(parts.front));
      if (!SoupPlane::of(parts.back).degenerate()) back.push_back(std::move(parts.back));
    }
  }

  std::vector<TreeNode> nodes_;
  std::uint32_t deepest_ = 0;
  std::size_t splits_ = 0;
};

/// Converts the plane to the mesh's bounding box, where the renderer tests the eye's side.
BspNode in_box(const SoupPlane& plane, const Mesh& mesh) {
  const SoupPoint centre{mesh.centre.x / 65536.0, mesh.centre.y / 65536.0, mesh.centre.z / 65536.0};
  SoupPoint n{plane.normal.x * mesh.half_extent.x, plane.normal.y * mesh.half_extent.y,
              plane.normal.z * mesh.half_extent.z};
  double distance = (plane.distance - dot(plane.normal, centre)) * 65536;
  const double length = std::sqrt(dot(n, n));
  n = {n.x / length, n.y / length, n.z / length};
  distance /= length;
  // A polygon's plane cuts the box, so that its distance is below sqrt(3), and fits in the format, which ends at 2.
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
  if (const Result<Done> built = builder.build(soup.polygons); !built) return built.failure();
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
    written.first_triangle = static_cast<std::uint32_t>(
        first < ordered.polygons.size() ? baked.scene.first_triangle(first) : baked.scene.mesh().triangles.size());
    written.parent = node.parent;
    written.front = node.front;
    written.back = node.back;
    baked.nodes.push_back(written);
  }
  return baked;
}

}  // namespace zstrip::sim
