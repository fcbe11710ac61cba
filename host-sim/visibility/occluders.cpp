// Collects triangles by plane, and cuts them out of the region that they must hide.
#include "visibility/occluders.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include "zstrip/effects.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxPieces = 512;
constexpr double kNothing = 1e-10;  // an area in square units that counts as none

using PlanePolygon = std::vector<PlanePoint>;

double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area_of(const PlanePolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) twice += turn(polygon[0], polygon[i], polygon[i + 1]);
  return twice / 2;
}

/// Returns the convex hull, counter-clockwise (Andrew's monotone chain).
PlanePolygon hull_of(std::vector<PlanePoint> points) {
  const auto before = [](const PlanePoint& a, const PlanePoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), before);
  PlanePolygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const PlanePoint& p : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Returns the part of a convex polygon to the left of the line a, b (or to its right).
PlanePolygon part_of(const PlanePolygon& polygon, const PlanePoint& a, const PlanePoint& b, bool left) {
  PlanePolygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& p = polygon[i];
    const PlanePoint& q = polygon[(i + 1) % polygon.size()];
    const double dp = left ? turn(a, b, p) : -turn(a, b, p), dq = left ? turn(a, b, q) : -turn(a, b, q);
    if (dp >= 0) part.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
      const double t = dp / (dp - dq);
      part.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return part;
}

/// True if surfaces behind the material are not visible through it, and only nearer surfaces are drawn over it.
bool hides(const Scene& scene, const Material& material) {
  return !has_depth_state(material) && finish_of(scene, material).alpha_mode == AlphaMode::opaque;
}

}  // namespace

SoupPoint world_position(const Mesh& mesh, const Transform& transform, const Position& position) {
  const auto along = [](Fixed centre, Fixed half, std::int16_t p) { return centre + half * (p / 32768.0); };
  const SoupPoint p{along(mesh.centre.x, mesh.half_extent.x, position.x),
                    along(mesh.centre.y, mesh.half_extent.y, position.y),
                    along(mesh.centre.z, mesh.half_extent.z, position.z)};
  const auto row = [&](const auto& m) { return ((m[0] * p.x + m[1] * p.y + m[2] * p.z) / 65536 + m[3]) / 65536; };
  return {row(transform.m[0]), row(transform.m[1]), row(transform.m[2])};
}

Occluder::Occluder(const SoupPlane& plane) : plane_(plane) {
  const SoupPoint& n = plane.normal;
  const SoupPoint other = std::abs(n.x) < 0.6 ? SoupPoint{1, 0, 0} : SoupPoint{0, 1, 0};
  const SoupPoint side = cross(other, n);
  const double length = std::sqrt(dot(side, side));
  across_ = {side.x / length, side.y / length, side.z / length};
  up_ = cross(n, across_);
}

void Occluder::add(const std::array<SoupPoint, 3>& corners) {
  const std::array<PlanePoint, 3> triangle{projected(corners[0]), projected(corners[1]), projected(corners[2])};
  area_ += turn(triangle[0], triangle[1], triangle[2]) / 2;
  for (const PlanePoint& p : triangle) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  triangles_.push_back(triangle);
}

bool Occluder::cover(std::vector<PlanePoint> points) const {
  if (!std::ranges::all_of(points, [this](const PlanePoint& p) { return may_cover(p); })) return false;
  std::vector<PlanePolygon> left{hull_of(std::move(points))}, next;
  if (left[0].size() < 3) return false;
  for (const auto& triangle : triangles_) {
    next.clear();
    for (PlanePolygon& piece : left) {
      for (std::size_t i = 0; i < 3 && piece.size() >= 3; ++i) {
        PlanePolygon outside = part_of(piece, triangle[i], triangle[(i + 1) % 3], false);
        if (outside.size() >= 3 && area_of(outside) > kNothing) next.push_back(std::move(outside));
        piece = part_of(piece, triangle[i], triangle[(i + 1) % 3], true);
      }
    }
    left.swap(next);
    if (left.empty()) return true;
    if (left.size() > kMaxPieces) return false;
  }
  return false;
}

std::vector<Occluder> occluders_of(const Scene& scene, const std::vector<bool>& moves, std::size_t most) {
  constexpr double kAngle = 1.0 / 4096, kDistance = 1.0 / 4096, kOff = 1e-4;  // tolerances of equal planes
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t>;
  std::map<Key, Occluder> found;
  const auto add = [&](const std::array<SoupPoint, 3>& corners) {
    const SoupPlane plane = SoupPlane::of({{corners[0], {}}, {corners[1], {}}, {corners[2], {}}});
    if (plane.degenerate()) return;
    const Key key{std::llround(plane.normal.x / kAngle), std::llround(plane.normal.y / kAngle),
                  std::llround(plane.normal.z / kAngle), std::llround(plane.distance / kDistance)};
    Occluder& occluder = found.try_emplace(key, plane).first->second;
    const bool fits = std::ranges::all_of(
        corners, [&](const SoupPoint& corner) { return std::abs(occluder.plane().at(corner)) <= kOff; });
    if (fits) occluder.add(corners);
  };
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Material& material = scene.materials[instance.material];
    if (moves[i] || !hides(scene, material)) continue;
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const Triangle& t : mesh.triangles) {
      const auto at = [&](std::uint16_t index) {
        return world_position(mesh, instance.transform, mesh.positions[index]);
      };
      const SoupPoint a = at(t.a), b = at(t.b), c = at(t.c);
      add({a, b, c});
      if (material.double_sided) add({a, c, b});
    }
  }
  std::vector<Occluder> largest;
  for (auto& [key, occluder] : found) largest.push_back(std::move(occluder));
  std::ranges::stable_sort(largest, [](const Occluder& a, const Occluder& b) { return a.area() > b.area(); });
  if (largest.size() > most) largest.erase(largest.begin() + static_cast<std::ptrdiff_t>(most), largest.end());
  return largest;
}

}  // namespace zstrip::sim
