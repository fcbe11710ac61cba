// Projects all vertices in each frame of a motion: see shown_edges.hpp.
#include "bake/shown_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kMaxFrames = 4096;

/// A vertex in the picture, in sub-pixels of 1/16 pixel, y upwards. x is not a number if it is too near to the camera.
struct Projected {
  double x = std::numeric_limits<double>::quiet_NaN(), y = 0;
};

Projected project(const Mesh& mesh, const Transform& transform, const Camera& camera, const View& view,
                  const Position& position) {
  constexpr double kPositionOne = 32768, kAxisOne = 1 << 30, kSubPixels = 16;
  const double p[3] = {mesh.centre.x + mesh.half_extent.x * (position.x / kPositionOne),
                       mesh.centre.y + mesh.half_extent.y * (position.y / kPositionOne),
                       mesh.centre.z + mesh.half_extent.z * (position.z / kPositionOne)};
  const auto world = [&](std::size_t row) {
    const Fixed(&m)[4] = transform.m[row];
    return (m[0] * p[0] + m[1] * p[1] + m[2] * p[2]) / kFixedOne + m[3];
  };
  const double from_eye[3] = {world(0) - camera.eye.x, world(1) - camera.eye.y, world(2) - camera.eye.z};
  const auto along = [&](const Vec3& axis) {
    return (axis.x * from_eye[0] + axis.y * from_eye[1] + axis.z * from_eye[2]) / kAxisOne;
  };
  const bool parallel = camera.projection == Projection::orthographic;
  const double distance = parallel ? kFixedOne : -along(camera.back);
  if (distance < camera.near_plane && !parallel) return {};
  const double scale = static_cast<double>(camera.focal) / kFixedOne * view.height / 2 * kSubPixels / distance;
  return {along(camera.right) * scale, along(camera.up) * scale};
}

/// The side of a face that is seen, if rounded corners cannot change it.
enum class Side { front, back, unknown };

Side side_of(const Projected& a, const Projected& b, const Projected& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const double twice_area = ux * vy - vx * uy;
  // The error of a corner is half a sub-pixel and the transform's rounding, that of a difference less than 2.
  const double error = 2 * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy)) + 8;
  if (twice_area > error) return Side::front;
  return twice_area < -error ? Side::back : Side::unknown;
}

/// True unless the edge is certainly not shown: see detail::ShownFaces.
bool may_show(const Edge& edge, std::span<const Projected> vertices, bool double_sided) {
  const Projected &a = vertices[edge.a], &b = vertices[edge.b];
  const Side left = side_of(a, b, vertices[edge.left]);
  if (edge.right == kNoFace) return left != Side::back || double_sided;
  const Side right = side_of(b, a, vertices[edge.right]);
  if (left != right || left == Side::unknown) return true;
  return edge.a > edge.b && (left == Side::front || double_sided);
}

bool same(const Transform& a, const Transform& b) {
  return std::ranges::equal(a.m, b.m,
                            [](const auto& one, const auto& other) { return std::ranges::equal(one, other); });
}

std::uint32_t frames_of(const scenes::AtRest& at_rest) {
  if (!at_rest.animation.tracks.empty()) return std::clamp(at_rest.animation.duration, 1U, kMaxFrames);
  return at_rest.turn.what == Turning::nothing ? 1 : kMaxFrames;
}

}  // namespace

ShownEdges::ShownEdges(const scenes::AtRest& at_rest, const View& view, std::span<const std::size_t> bent) {
  const Scene& scene = at_rest.scene;
  std::vector<Instance> instances(scene.instances.size());
  std::vector<LineSet> lines(scene.lines.size());
  std::vector<std::optional<Transform>> seen(instances.size());
  std::vector<std::vector<bool>> shown;
  for (const EdgeSet& set : scene.edges) {
    const bool all =
        scene.meshes[set.mesh].billboard != Billboard::none || std::ranges::find(bent, set.mesh) != bent.end();
    shown.emplace_back(set.edges.size(), all);
  }
  std::vector<Projected> vertices;
  const std::uint32_t frames = frames_of(at_rest);
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    const auto [moved, camera] = scenes::stage(at_rest, frame, frames, {.instances = instances, .lines = lines});
    for (std::size_t i = 0; i < moved.instances.size(); ++i) {
      const Instance& instance = moved.instances[i];
      if (at_rest.turn.what != Turning::camera && seen[i] && same(*seen[i], instance.transform)) continue;
      seen[i] = instance.transform;
      const Mesh& mesh = scene.meshes[instance.mesh];
      for (std::size_t s = 0; s < scene.edges.size(); ++s) {
        if (scene.edges[s].mesh != instance.mesh || std::ranges::find(shown[s], false) == shown[s].end()) continue;
        vertices.clear();
        for (const Position& position : mesh.positions) {
          vertices.push_back(project(mesh, instance.transform, camera, view, position));
        }
        const bool double_sided = scene.materials[instance.material].double_sided;
        for (std::size_t e = 0; e < shown[s].size(); ++e) {
          if (!shown[s][e]) shown[s][e] = may_show(scene.edges[s].edges[e], vertices, double_sided);
        }
      }
    }
  }
  for (std::size_t s = 0; s < scene.edges.size(); ++s) {
    std::vector<Edge>& list = lists_.emplace_back();
    for (std::size_t e = 0; e < shown[s].size(); ++e) {
      if (shown[s][e]) list.push_back(scene.edges[s].edges[e]);
    }
    left_out_ += shown[s].size() - list.size();
    if (!list.empty()) sets_.push_back({list, scene.edges[s].mesh});
  }
}

}  // namespace zstrip::sim
