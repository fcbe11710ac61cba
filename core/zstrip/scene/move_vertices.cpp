// Moves vertices with products of 32 bits. Most vertices have one joint and need no weights; the result has the same
// bits.
#include "zstrip/scene/move_vertices.hpp"

#include <algorithm>

#include "zstrip/base/unit_vector.hpp"

namespace zstrip::detail {
namespace {

struct Sum {
  std::int32_t x, y, z;
};

/// Sums `at_row`(row of a matrix) times the weight over the joints of a vertex. The weights add up to 256.
template <class AtRow>
Sum weighted(const VertexJoints& vertex, const Transform* matrices, const AtRow& at_row) {
  std::int32_t x = 0, y = 0, z = 0, weight = vertex.weights[0] + 1;
  for (int k = 0;;) {
    const Transform& matrix = matrices[vertex.joints[k]];
    x += at_row(matrix.m[0]) * weight;
    y += at_row(matrix.m[1]) * weight;
    z += at_row(matrix.m[2]) * weight;
    if (++k == 4 || vertex.weights[k] == 0) return {x, y, z};
    weight = vertex.weights[k];
  }
}

constexpr bool fits(std::int32_t value) { return static_cast<std::uint32_t>(value + 32767) <= 2 * 32767; }
constexpr std::int16_t limited(std::int32_t value) {
  return static_cast<std::int16_t>(std::clamp<std::int32_t>(value, -32767, 32767));
}

}  // namespace

std::size_t move_positions(std::span<const Position> from, std::span<const VertexJoints> vertices,
                           const JointMatrices& matrices, std::span<Position> to) {
  const std::size_t count = from.size();
  const int shift = matrices.fraction_bits - 4;
  std::size_t outside = count;
  for (std::size_t i = 0; i < count; ++i) {
    // Copies each member, because a Cortex-M0 would call memcpy for the whole struct.
    const std::int32_t x = from[i].x, y = from[i].y, z = from[i].z;
    const VertexJoints& vertex = vertices[i];
    const auto at_row = [x, y, z, shift](const Fixed(&row)[4]) {
      // Below 2^31, because a row's sum is below 2^16.
      return ((row[0] * x + row[1] * y + row[2] * z) >> shift) + row[3];  // 20.4
    };
    Sum moved;
    if (vertex.weights[1] == 0) {
      const Transform& matrix = matrices.of_joint[vertex.joints[0]];
      moved = {(at_row(matrix.m[0]) + 8) >> 4, (at_row(matrix.m[1]) + 8) >> 4, (at_row(matrix.m[2]) + 8) >> 4};
    } else {
      const Sum sum = weighted(vertex, matrices.of_joint, at_row);  // 20.12
      const auto rounded = [](std::int32_t value) { return (value + (1 << 11)) >> 12; };
      moved = {rounded(sum.x), rounded(sum.y), rounded(sum.z)};
    }
    if (!fits(moved.x) || !fits(moved.y) || !fits(moved.z)) {
      outside = std::min(outside, i);
      moved = {limited(moved.x), limited(moved.y), limited(moved.z)};
    }
    to[i].x = static_cast<std::int16_t>(moved.x);
    to[i].y = static_cast<std::int16_t>(moved.y);
    to[i].z = static_cast<std::int16_t>(moved.z);
  }
  return outside;
}

void move_normals(std::span<const Normal> from, std::span<const VertexJoints> vertices, const JointMatrices& matrices,
                  std::span<Normal> to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Normal& normal = from[i];
    const VertexJoints& vertex = vertices[i];
    const auto at_row = [&normal](const Fixed(&row)[4]) {
      // Below 2^20; below 2^23 with the weight added.
      return (row[0] * normal.x + row[1] * normal.y + row[2] * normal.z) >> 4;
    };
    Sum sum;
    if (vertex.weights[1] == 0) {
      const Transform& matrix = matrices.of_joint[vertex.joints[0]];
      sum = {at_row(matrix.m[0]), at_row(matrix.m[1]), at_row(matrix.m[2])};
    } else {
      sum = weighted(vertex, matrices.of_joint, at_row);
    }
    set_direction(normal, direction_of(sum.x, sum.y, sum.z).unit, to[i]);
  }
}

}  // namespace zstrip::detail
