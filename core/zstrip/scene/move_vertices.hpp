// The vertices of a skin, moved by the matrices of its joints.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/skin.hpp"

namespace zstrip::detail {

/// Of positions to positions: the first three columns with `fraction_bits`, no row adding up to more than 2^16, the
/// last 20.4. A sum over a vertex' joints does not wrap.
struct JointMatrices {
  const Transform* of_joint;
  int fraction_bits;  ///< 6..14
};

/// What is wrong with the joint or the vertex of this index.
constexpr Status wrong_skin(std::size_t index) {
  return {.error = Error::skin, .needed = static_cast<std::uint32_t>(index)};
}

/// The joints' matrices of a pose, into `work`. Errors as of skin_mesh.
Status make_matrices(const Skin& skin, std::span<const JointPose> pose, std::span<Transform> work, int& fraction_bits);

/// Writes as many as `from` has; what would leave the box stays on its side. Returns the first of these; from.size():
/// there is none.
std::size_t move_positions(std::span<const Position> from, std::span<const VertexJoints> vertices,
                           const JointMatrices& matrices, std::span<Position> to);

/// Their directions as the joints turn them, their lengths as they were: hulls of outlines have longer ones.
void move_normals(std::span<const Normal> from, std::span<const VertexJoints> vertices, const JointMatrices& matrices,
                  std::span<Normal> to);

}  // namespace zstrip::detail
