// Sets up every triangle in double precision and evaluates it at pixels.
#include "visibility/surface_judge.hpp"

#include <algorithm>
#include <cmath>

#include "motion/turned_billboard.hpp"

namespace zstrip::sim {
namespace {

struct Point {
  double x, y, z;
};

Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point scaled(const Vec3& v, double one) { return {v.x / one, v.y / one, v.z / one}; }

constexpr double kFixed = 65536, kUnit = 1 << 30;

/// Converts object space to view space: x right, y up, z the distance in front of the camera.
Point to_view(const Mesh& mesh, const Transform& transform, const Camera& camera, const Position& p) {
  const Point centre = scaled(mesh.centre, kFixed), half = scaled(mesh.half_extent, kFixed);
  const double object[3] = {centre.x + half.x * p.x / 32768, centre.y + half.y * p.y / 32768,
                            centre.z + half.z * p.z / 32768};
  double world[3];
  for (int i = 0; i < 3; ++i) {
    world[i] = transform.m[i][3] / kFixed;
    for (int j = 0; j < 3; ++j) world[i] += transform.m[i][j] / kFixed * object[j];
  }
  const Point eye = scaled(camera.eye, kFixed);
  const Point from_eye{world[0] - eye.x, world[1] - eye.y, world[2] - eye.z};
  return {dot(from_eye, scaled(camera.right, kUnit)), dot(from_eye, scaled(camera.up, kUnit)),
          -dot(from_eye, scaled(camera.back, kUnit))};
}

}  // namespace

double nearness_of_code(const Camera& camera, Fixed near, Fixed far) {
  const double n = near / kFixed, f = far / kFixed;
  return (camera.projection == Projection::perspective ? 1 / n - 1 / f : f - n) / 65533;
}

SurfaceJudge::SurfaceJudge(const Scene& scene, const Camera& camera, const View& view)
    : view_(view), nearest_(std::size_t{view.width} * view.height, kNothing) {
  const bool perspective = camera.projection == Projection::perspective;
  const double near = camera.near_plane / kFixed, far = camera.far_plane / kFixed;
  const double scale = camera.focal / kFixed * view.height / 2;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Transform transform = standing(scene, instance, camera);
    std::vector<Point> corners;  // of all vertices: x, y in pixels times w, and w; z is separate
    std::vector<double> distances;
    for (const Position& position : mesh.positions) {
      const Point v = to_view(mesh, transform, camera, position);
      const double w = perspective ? v.z : 1;
      corners.push_back({view.width / 2.0 * w + scale * v.x, view.height / 2.0 * w - scale * v.y, w});
      distances.push_back(v.z);
    }
    for (const Triangle& t : mesh.triangles) {
      const std::uint16_t index[3] = {t.a, t.b, t.c};
      const Point v[3] = {corners[t.a], corners[t.b], corners[t.c]};
      Surface surface;
      surface.near = perspective ? 1 / near : -near;
      surface.far = perspective ? 1 / far : -far;
      const double determinant = dot(v[0], cross(v[1], v[2]));
      const bool front = determinant < 0;  // y grows downwards
      surface.visible = std::abs(determinant) > 1e-12 && (front || scene.materials[instance.material].double_sided);
      for (std::size_t i = 0; i < 3; ++i) {
        const Point e = cross(v[(i + 1) % 3], v[(i + 2) % 3]);
        surface.edges[i] = {e.x / determinant, e.y / determinant, e.z / determinant};
        const double value = perspective ? 1 : -distances[index[i]];
        surface.nearness.x += value * surface.edges[i].x;
        surface.nearness.y += value * surface.edges[i].y;
        surface.nearness.c += value * surface.edges[i].c;
      }
      double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
      for (const Point& p : v) {
        if (p.z < near / 2 && perspective) left = top = -1e9, right = bottom = 1e9;  // may be anywhere
        left = std::min(left, p.x / p.z), right = std::max(right, p.x / p.z);
        top = std::min(top, p.y / p.z), bottom = std::max(bottom, p.y / p.z);
      }
      const auto pixel = [](double value, int limit) { return static_cast<int>(std::clamp(value, 0.0, 1.0 * limit)); };
      surface.left = pixel(std::floor(left) - 1, view.width);
      surface.top = pixel(std::floor(top) - 1, view.height);
      surface.right = pixel(std::ceil(right) + 1, view.width);
      surface.bottom = pixel(std::ceil(bottom) + 1, view.height);
      surfaces_.push_back(surface);
    }
  }
}

SurfaceJudge::Cover SurfaceJudge::covers(const Surface& surface, int column, int row) const {
  const double x = column + 0.5, y = row + 0.5;
  Cover cover = Cover::sure;
  for (const Line& edge : surface.edges) {
    const double value = edge.at(x, y), limit = tolerance_.pixels * std::hypot(edge.x, edge.y);
    if (value < -limit) return Cover::none;
    if (value <= limit) cover = Cover::unsure;
  }
  const double nearness = surface.nearness.at(x, y), limit = slack(surface);
  if (nearness > surface.near + limit || nearness < surface.far - limit) return Cover::none;
  if (nearness > surface.near - limit || nearness < surface.far + limit) return Cover::unsure;
  return cover;
}

double SurfaceJudge::slack(const Surface& surface) const {
  return tolerance_.nearness + tolerance_.pixels * (std::abs(surface.nearness.x) + std::abs(surface.nearness.y));
}

void SurfaceJudge::find_nearest(const Tolerance& tolerance) {
  tolerance_ = tolerance;
  std::ranges::fill(nearest_, kNothing);
  for (const Surface& surface : surfaces_) {
    if (!surface.visible) continue;
    for (int row = surface.top; row < surface.bottom; ++row) {
      for (int column = surface.left; column < surface.right; ++column) {
        if (covers(surface, column, row) != Cover::sure) continue;
        double& nearest = nearest_[at(column, row)];
        nearest = std::max(nearest, surface.nearness.at(column + 0.5, row + 0.5) - slack(surface));
      }
    }
  }
}

bool SurfaceJudge::may_be_seen(std::size_t triangle, int column, int row) const {
  if (triangle >= surfaces_.size()) return !is_covered(column, row);
  const Surface& surface = surfaces_[triangle];
  if (!surface.visible || covers(surface, column, row) == Cover::none) return false;
  return surface.nearness.at(column + 0.5, row + 0.5) + slack(surface) >= nearest_[at(column, row)];
}

std::vector<std::uint8_t> wrong_pixels(const SurfaceJudge& judge, std::span<const std::uint16_t> picture,
                                       const View& view) {
  std::vector<std::uint8_t> wrong(picture.size());
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const std::size_t at = static_cast<std::size_t>(row) * view.width + static_cast<std::size_t>(column);
      const std::size_t triangle = picture[at] == 0 ? SurfaceJudge::kBackground : picture[at] - std::size_t{1};
      wrong[at] = !judge.may_be_seen(triangle, column, row);
    }
  }
  return wrong;
}

}  // namespace zstrip::sim
