// Moves the vertices of a skin by the matrices of its joints; steps that skins and morph targets share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/base/unit_vector.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::detail {

/// Matrices from positions to positions. The first three columns have `fraction_bits`, and no row of them adds up to
/// more than 2^16; the last column is 20.4. A sum over a vertex' joints does not overflow.
struct JointMatrices {
  const Transform* of_joint;
  int fraction_bits;  ///< 6..14
};

constexpr Status wrong_skin(std::size_t index) {
  return {.error = Error::skin, .needed = static_cast<std::uint32_t>(index)};
}

/// Writes the joints' matrices of a pose into `work`. Errors as in skin_mesh.
Status make_matrices(const Skin& skin, std::span<const JointPose> pose, std::span<Transform> work, int& fraction_bits);

/// Writes as many positions as `from` has; positions outside of the box are moved to its side. Returns the index of the
/// first of these, or from.size() if there is none.
std::size_t move_positions(std::span<const Position> from, std::span<const VertexJoints> vertices,
                           const JointMatrices& matrices, std::span<Position> to);

/// Writes a normal with the direction of `unit` and the length of `from`, which may be `to`.
inline void set_direction(const Normal& from, const UnitVector& unit, Normal& to) {
  const auto square = static_cast<std::uint32_t>(from.x * from.x + from.y * from.y + from.z * from.z);
  const auto length = static_cast<std::int32_t>(root_of_word(square << 16) >> 4);  // 8.4; large roots are faster
  const auto component = [length](std::int32_t c) {
    return static_cast<std::int8_t>(std::clamp<std::int32_t>((c * length + (1 << 17)) >> 18, -128, 127));
  };
  to.x = component(unit.x), to.y = component(unit.y), to.z = component(unit.z);
  to.unused = from.unused;
}

/// Rotates normals with the joints. Their lengths do not change: hulls of outlines have normals longer than one.
void move_normals(std::span<const Normal> from, std::span<const VertexJoints> vertices, const JointMatrices& matrices,
                  std::span<Normal> to);

}  // namespace zstrip::detail
