// Computes the position of a camera with which a rotating model fills the picture.
#include "render/framing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

/// Calls visit(x, y, z) for each vertex of each instance and each set of lines, and for each corner of the box around
/// each quadric, after the transform, in the scene's units.
template <typename Visit>
void for_each_vertex(const Scene& scene, Visit visit) {
  const auto visit_moved = [&](const Transform& transform, double x, double y, double z) {
    const auto moved = [&](const Fixed(&row)[4]) {
      return from_fixed(row[0]) * x + from_fixed(row[1]) * y + from_fixed(row[2]) * z + from_fixed(row[3]);
    };
    visit(moved(transform.m[0]), moved(transform.m[1]), moved(transform.m[2]));
  };
  for (const Quadric& quadric : scene.quadrics) {
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        for (const double z : {-1, 1}) visit_moved(quadric.transform, x, y, z);
      }
    }
  }
  const auto visit_mesh = [&](const Mesh& mesh, const Transform& transform) {
    const auto coordinate = [](Fixed centre, Fixed half, std::int16_t steps) {
      return from_fixed(centre) + from_fixed(half) * steps / 32768;
    };
    for (const Position& p : mesh.positions) {
      visit_moved(transform, coordinate(mesh.centre.x, mesh.half_extent.x, p.x),
                  coordinate(mesh.centre.y, mesh.half_extent.y, p.y),
                  coordinate(mesh.centre.z, mesh.half_extent.z, p.z));
    }
  };
  // In every orientation a billboard stays within a sphere, which is within its cube.
  const auto visit_billboard = [&](const Mesh& mesh, const Transform& transform) {
    double reach = 0;
    for (const Fixed Vec3::*const member : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double corner = std::abs(from_fixed(mesh.centre.*member)) + from_fixed(mesh.half_extent.*member);
      reach = std::hypot(reach, corner);
    }
    double scale = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto entry = [&](std::size_t r) { return from_fixed(transform.m[r][c]); };
      scale = std::max(scale, std::hypot(entry(0), entry(1), entry(2)));
    }
    const double x = from_fixed(transform.m[0][3]), y = from_fixed(transform.m[1][3]),
                 z = from_fixed(transform.m[2][3]);
    const double r = reach * scale;
    for (const double across : {-r, r}) {
      for (const double up : {-r, r}) {
        for (const double along : {-r, r}) visit(x + across, y + up, z + along);
      }
    }
  };
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    mesh.billboard == Billboard::none ? visit_mesh(mesh, instance.transform)
                                      : visit_billboard(mesh, instance.transform);
  }
  for (const LineSet& lines : scene.lines) visit_mesh(scene.meshes[lines.mesh], lines.transform);
}

/// The largest values so far of a linear expression and of its negative.
struct Extent {
  double plus = -std::numeric_limits<double>::infinity();
  double minus = -std::numeric_limits<double>::infinity();
  void include(double with_plus, double with_minus) {
    plus = std::max(plus, with_plus);
    minus = std::max(minus, with_minus);
  }
  double half() const { return (plus + minus) / 2; }
  double middle() const { return (plus - minus) / 2; }
};

}  // namespace

Framing frame_scene(const Scene& scene, const FramingView& view) {
  const double sine = std::sin(kTilt * std::numbers::pi / 180);
  const double cosine = std::cos(kTilt * std::numbers::pi / 180);
  const double yaw_sine = std::sin(view.yaw * std::numbers::pi / 180);
  const double yaw_cosine = std::cos(view.yaw * std::numbers::pi / 180);
  // A vertex (x, y, depth z in view space) is inside if |y - target| <= tangent (distance - z), and so for x with the
  // tangent of the width: distance >= z + (y - target) / tangent and distance >= z - (y - target) / tangent. Both are
  // linear, so the extremes over all vertices, and over all angles of a rotation, have closed forms. Orthographic:
  // without z.
  const double depth_share = view.orthographic ? 0 : 1;
  const double slope_y = 1 / (view.filled * (view.orthographic ? 1 : view.half_tangent));
  const double slope_x = slope_y / view.aspect;

  Extent vertical;
  Extent horizontal;
  double nearest = -std::numeric_limits<double>::infinity();
  for_each_vertex(scene, [&](double world_x, double y, double world_z) {
    const double x = world_x * yaw_cosine - world_z * yaw_sine;
    const double z = world_x * yaw_sine + world_z * yaw_cosine;
    const double on_axis_depth = depth_share * sine * y;
    const double on_axis_height = slope_y * cosine * y;
    const double depth_slope = depth_share * cosine;
    const double height_slope = slope_y * sine;
    if (view.whole_turn) {
      const double r = std::hypot(x, z);
      vertical.include(on_axis_depth + on_axis_height + r * std::abs(depth_slope - height_slope),
                       on_axis_depth - on_axis_height + r * (depth_slope + height_slope));
      const double across = on_axis_depth + r * std::hypot(depth_slope, slope_x);
      horizontal.include(across, across);
      nearest = std::max(nearest, sine * y + cosine * r);
    } else {
      vertical.include(on_axis_depth + on_axis_height + z * (depth_slope - height_slope),
                       on_axis_depth - on_axis_height + z * (depth_slope + height_slope));
      horizontal.include(on_axis_depth + z * depth_slope + slope_x * x, on_axis_depth + z * depth_slope - slope_x * x);
      nearest = std::max(nearest, sine * y + cosine * z);
    }
  });

  const double up = vertical.middle() / slope_y;
  const double right = horizontal.middle() / slope_x;
  constexpr double kClearance = 0.05;  // flat models seen edge-on would otherwise touch the eye
  const double fitted = std::max({vertical.half(), horizontal.half(), kClearance});
  Framing framing;
  framing.target = {right * yaw_cosine - up * sine * yaw_sine, up * cosine, -right * yaw_sine - up * sine * yaw_cosine};
  framing.yaw = view.yaw;
  framing.distance = std::max(view.orthographic ? 0 : fitted, nearest + kClearance);
  framing.half_height = view.orthographic ? fitted : framing.distance * view.half_tangent;
  return framing;
}

double radius_about_origin(const Scene& scene) {
  double radius = 0;
  for_each_vertex(scene, [&](double x, double y, double z) { radius = std::max(radius, std::hypot(x, y, z)); });
  return radius;
}

}  // namespace zstrip::sim
