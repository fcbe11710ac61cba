// Moves a whole mesh by its joints.
#include <cstddef>

#include "zstrip/scene/bound_meshlet.hpp"
#include "zstrip/scene/move_vertices.hpp"
#include "zstrip/skin.hpp"

namespace zstrip {

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
    detail::bound(moved.meshlets[i], moved.positions);
  }
  return {};
}

}  // namespace zstrip
