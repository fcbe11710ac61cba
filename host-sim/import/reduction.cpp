// Makes a model smaller before it is converted: shrinks textures, removes triangles.
#include "import/reduction.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "image/resample.hpp"
#include "import/area_filter.hpp"
#include "import/moving_body.hpp"
#include "import/quantised_skins.hpp"

namespace zstrip::sim {
namespace {

/// Returns the mean length in the file, at rest, of a unit of the mesh's vertices.
double unit_of(const SourceModel& model, const SourceMesh& mesh, const std::vector<Affine>& joints) {
  if (!mesh.has_skin) return 1;
  std::vector<bool> used(model.joints.size());
  for (const SourceVertex& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (vertex.weights[i] > 0) used[vertex.joints[i]] = true;
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const auto& m = (joints[i] * model.joints[i].inverse_bind).m;
    const double volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    largest = std::max(largest, std::cbrt(std::abs(volume)));
  }
  return std::isfinite(largest) && largest > 0 ? largest : 1;
}

/// Groups the meshes that move together.
std::vector<MovingBody> bodies_of(const SourceModel& model) {
  const std::vector<Affine> joints = joint_places(model, nullptr, 0);
  struct Group {
    std::vector<std::size_t> meshes;
    double unit = 1;
  };
  constexpr int kUnitsOfTwo = 4;  // units that differ by less than a fifth are the same
  std::map<std::tuple<bool, std::int32_t, long>, Group> groups;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const SourceMesh& mesh = model.meshes[i];
    if (mesh.indices.empty()) continue;
    const double unit = unit_of(model, mesh, joints);
    Group& group = groups[{mesh.has_skin, mesh.node, std::lround(kUnitsOfTwo * std::log2(unit))}];
    group.meshes.push_back(i);
    group.unit = unit;
  }
  std::vector<MovingBody> bodies;
  for (auto& [key, group] : groups) bodies.emplace_back(model, std::move(group.meshes), group.unit);
  MovingBody::keep_shared_borders(bodies);
  return bodies;
}

std::uint64_t triangles_of(std::span<const MovingBody> bodies) {
  std::uint64_t sum = 0;
  for (const MovingBody& body : bodies) sum += body.triangles();
  return sum;
}

double error_of(std::span<const MovingBody> bodies) {
  double error = 0;
  for (const MovingBody& body : bodies) error = std::max(error, body.error());
  return error;
}

/// Simplifies by the smallest error whose result keeps the limit, in even steps of the error's logarithm. If there is
/// no such error, removes as many triangles as it can and returns false.
bool simplify(std::span<MovingBody> bodies, Held held, std::uint64_t limit) {
  constexpr double kSmallest = 1e-6;
  constexpr int kSteps = 10;
  double largest = 0;
  for (MovingBody& body : bodies) {
    body.hold(held);
    largest = std::max(largest, body.size());
  }
  const auto keeps_limit = [&](double error) {
    for (MovingBody& body : bodies) body.simplify(error);
    return triangles_of(bodies) <= limit;
  };
  if (!keeps_limit(largest)) return false;
  double low = std::log(largest * kSmallest), high = std::log(largest);
  for (int step = 0; step < kSteps; ++step) {
    const double middle = (low + high) / 2;
    (keeps_limit(std::exp(middle)) ? high : low) = middle;
  }
  return keeps_limit(std::exp(high));
}

}  // namespace

Shrunk fit_textures(SourceModel& model, std::uint32_t side) {
  Shrunk shrunk;
  for (RgbImage& texture : model.textures) {
    // The sides that a texture gets without a limit.
    std::uint32_t width = std::min(std::bit_ceil(texture.width), kMaxTextureSide);
    std::uint32_t height = std::min(std::bit_ceil(texture.height), kMaxTextureSide);
    if (side == 0 || std::max(width, height) <= side) {
      texture = resample_to_power_of_two(std::move(texture));
      continue;
    }
    ++shrunk.textures;
    shrunk.texels_before += std::uint64_t{width} * height;
    for (; std::max(width, height) > side; height = std::max(height / 2, 1U)) width = std::max(width / 2, 1U);
    shrunk.texels += std::uint64_t{width} * height;
    texture = shrink(texture, width, height);
  }
  return shrunk;
}

std::vector<ReducedMesh> reduce_each(SourceModel& model, double share) {
  std::vector<MovingBody> bodies;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) bodies.emplace_back(model, std::vector{i}, 1);
  MovingBody::keep_shared_borders(bodies);
  std::vector<ReducedMesh> reduced;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::size_t all = model.meshes[i].indices.size() / 3;
    bodies[i].hold(Held::all);
    bodies[i].simplify(bodies[i].size(), static_cast<std::size_t>(std::ceil(static_cast<double>(all) * share)));
    reduced.push_back({bodies[i].triangles(), bodies[i].error()});
  }
  for (const MovingBody& body : bodies) body.write_to(model);
  return reduced;
}

Reduced remove_triangles(SourceModel& model, const Reduction& reduction) {
  constexpr double kMaxErrorRatio = 2;  // for keeping vertices whose removal is visible
  Reduced reduced;
  for (const SourceMesh& mesh : model.meshes) reduced.triangles_before += mesh.indices.size() / 3;
  std::uint64_t limit = reduced.triangles_before;
  if (reduction.triangles > 0) limit = std::min(limit, reduction.triangles);
  if (reduction.triangle_share < 1) {
    limit = std::min(limit, static_cast<std::uint64_t>(
                                std::ceil(static_cast<double>(reduced.triangles_before) * reduction.triangle_share)));
  }
  reduced.triangles = reduced.triangles_before;
  if (reduced.triangles <= limit) return reduced;
  std::vector<MovingBody> bodies = bodies_of(model);
  std::vector<MovingBody> held = bodies;
  reduced.keeps_limit = simplify(bodies, Held::shared_borders, limit);
  reduced.slides = !simplify(held, Held::all, limit) || error_of(held) > kMaxErrorRatio * error_of(bodies);
  if (!reduced.slides) bodies = std::move(held);
  reduced.triangles = triangles_of(bodies);
  reduced.error = error_of(bodies);
  for (const MovingBody& body : bodies) body.write_to(model);
  return reduced;
}

}  // namespace zstrip::sim
