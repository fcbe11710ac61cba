// Moves a whole mesh by its joints.
#include <algorithm>
#include <cstddef>

#include "zstrip/base/unit_vector.hpp"
#include "zstrip/scene/move_vertices.hpp"
#include "zstrip/skin.hpp"

namespace zstrip {
namespace {

/// Sets the meshlet's sphere: its centre is that of the bounding box of the vertices, its radius reaches all of them.
void bound(Meshlet& meshlet, std::span<const Position> positions) {
  std::int32_t low[3] = {32767, 32767, 32767}, high[3] = {-32768, -32768, -32768};
  const std::span vertices = positions.subspan(meshlet.first_vertex, meshlet.vertex_count);
  for (const Position& p : vertices) {
    const std::int32_t place[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], place[i]), high[i] = std::max(high[i], place[i]);
  }
  const auto middle = [&](int i) { return static_cast<std::int16_t>((low[i] + high[i]) >> 1); };
  meshlet.centre = {middle(0), middle(1), middle(2)};
  std::uint32_t farthest = 0;  // a square: at most three of 2^30
  for (const Position& p : vertices) {
    const std::int32_t x = p.x - meshlet.centre.x, y = p.y - meshlet.centre.y, z = p.z - meshlet.centre.z;
    farthest = std::max(farthest, static_cast<std::uint32_t>(x * x) + static_cast<std::uint32_t>(y * y) +
                                      static_cast<std::uint32_t>(z * z));
  }
  const std::uint32_t root = detail::root_of_word(farthest);
  meshlet.radius = static_cast<std::uint16_t>(root * root == farthest ? root : root + 1);
}

}  // namespace

Status skin_mesh(const Skin& skin, std::span<const JointPose> pose, std::span<Transform> work,
                 const MovedVertices& moved) {
  const Mesh& mesh = *skin.mesh;
  if (moved.positions.size() != mesh.positions.size() || moved.normals.size() != mesh.normals.size() ||
      moved.meshlets.size() != mesh.meshlets.size()) {
    return detail::wrong_skin(0);
  }
  int bits = 0;
  if (const Status status = detail::make_matrices(skin, pose, work, bits); !status) return status;
  const detail::JointMatrices matrices{work.data(), bits};
  const std::size_t outside = detail::move_positions(mesh.positions, skin.vertices, matrices, moved.positions);
  if (outside != mesh.positions.size()) return detail::wrong_skin(outside);
  detail::move_normals(mesh.normals, skin.vertices, matrices, moved.normals);
  for (std::size_t i = 0; i < mesh.meshlets.size(); ++i) {
    moved.meshlets[i] = mesh.meshlets[i];
    bound(moved.meshlets[i], moved.positions);
  }
  return {};
}

}  // namespace zstrip
