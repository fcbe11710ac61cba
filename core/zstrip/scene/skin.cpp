// Moves the joints of a skin, in 64 bits.
#include "zstrip/skin.hpp"

#include <algorithm>
#include <cstddef>

#include "zstrip/base/math.hpp"
#include "zstrip/base/unit_vector.hpp"
#include "zstrip/scene/keyframes.hpp"
#include "zstrip/scene/move_vertices.hpp"

namespace zstrip {
namespace {

using detail::Quaternion;

/// Returns |q|^2 in 2.30, of a quaternion in 1.15. Four components of -1.0 overflow to 0.
std::uint32_t square_of(const std::int16_t (&q)[4]) {
  std::uint32_t sum = 0;  // of four products of at most 2^30
  for (const std::int32_t c : q) sum += static_cast<std::uint32_t>(c * c);
  return sum;
}

/// Normalises a quaternion and stores it in 1.15. With a quaternion of length 0 the pose keeps its rotation.
void set_rotation(JointPose& pose, const Quaternion& q) {
  const std::int64_t components[4] = {q.x, q.y, q.z, q.w};
  std::uint64_t square = 0;  // 4.60
  for (const std::int64_t c : components) square += static_cast<std::uint64_t>(c * c);
  const auto length = static_cast<std::int64_t>(square_root(square));  // 2.30
  if (length == 0) return;
  for (int i = 0; i < 4; ++i) pose.rotation[i] = static_cast<std::int16_t>(components[i] * 32767 / length);
}

/// Upper limit for the entries of a joint's matrix, 16.16.
constexpr std::int64_t kMaxEntry = std::int64_t{1} << 24;

/// Sets `to` = a b, both affine, 16.16, entries of `a` below kMaxEntry. Returns false if the result is out of range.
bool multiply(const Transform& a, const Transform& b, Transform& to) {
  Transform result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      std::int64_t sum = std::int64_t{kFixedOne} / 2;  // below 3 * 2^55
      for (int k = 0; k < 3; ++k) sum += std::int64_t{a.m[row][k]} * b.m[k][column];
      sum >>= kFixedBits;
      if (column == 3) sum += a.m[row][3];
      const std::int64_t limit = column == 3 ? INT32_MAX : kMaxEntry;
      if (sum <= -limit || sum >= limit) return false;
      result.m[row][column] = static_cast<Fixed>(sum);
    }
  }
  to = result;
  return true;
}

/// Limit for the positions to which a joint's matrix moves the mesh's box, 20.4: then no sum overflows.
constexpr std::int64_t kReach = std::int64_t{8} * 32768 * 16;

/// The mapping between the space of a mesh and the space of its positions.
struct Grid {
  Vec3 centre;
  Fixed half;  ///< 16.16
  int bits;    ///< fraction bits of a matrix' first three columns, at most 14: no row adds up to more than 2^16

  /// Converts `bind`, from the mesh as it was modelled to the mesh as the joint moves it, to a matrix for positions,
  /// whose last column is 20.4. Returns false if a position may be moved too far away.
  bool turn(const Transform& bind, Transform& to) const {
    const std::int64_t centres[3] = {centre.x, centre.y, centre.z};
    Transform grid;
    for (int row = 0; row < 3; ++row) {
      const auto& m = bind.m[row];
      std::int64_t moved = (std::int64_t{m[3]} - centres[row]) * kFixedOne;  // 32.32
      std::int64_t sum = 0;
      for (int k = 0; k < 3; ++k) {
        moved += m[k] * centres[k];
        sum += m[k] < 0 ? -std::int64_t{m[k]} : m[k];
        const int shift = kFixedBits - bits;
        grid.m[row][k] = (m[k] + (1 << (shift - 1))) >> shift;
      }
      const std::int64_t offset = moved * 8 / half;  // 32.32 / 16.16, in 1/32768 of a half extent: 20.4
      if ((offset < 0 ? -offset : offset) + sum * 8 >= kReach) return false;
      grid.m[row][3] = static_cast<std::int32_t>(offset);
    }
    to = grid;
    return true;
  }
};

/// Returns the largest number of fraction bits with which no row of the matrices adds up to more than 2^16. It is at
/// least 6, because entries are below kMaxEntry.
int fraction_bits(std::span<const Transform> matrices) {
  std::uint32_t largest = 0;  // 16.16, sum of three entries
  for (const Transform& matrix : matrices) {
    for (const auto& row : matrix.m) {
      std::uint32_t sum = 0;
      for (int k = 0; k < 3; ++k) sum += static_cast<std::uint32_t>(row[k] < 0 ? -(row[k] + 1) : row[k]) >> 2;
      largest = std::max(largest, sum);
    }
  }
  int bits = 14;
  // Subtract the amount that three entries lose here and gain when they are rounded.
  while (largest >= kFixedOne - 8U) largest >>= 1, --bits;
  return bits;
}

/// True if the joint has a weight at a vertex. The first joint of a vertex always has one.
bool has_weight(const Skin& skin, std::size_t joint) {
  for (const VertexJoints& vertex : skin.vertices) {
    for (int k = 0; k < 4; ++k) {
      if (vertex.joints[k] == joint && (k == 0 || vertex.weights[k] != 0)) return true;
    }
  }
  return false;
}

}  // namespace

Status detail::make_matrices(const Skin& skin, std::span<const JointPose> pose, std::span<Transform> work, int& bits) {
  const Mesh& mesh = *skin.mesh;
  const std::size_t joints = skin.joints.size();
  if (pose.size() != joints || work.size() != joints || skin.vertices.size() != mesh.positions.size())
    return detail::wrong_skin(0);
  for (std::size_t i = 0; i < joints; ++i) {
    if (square_of(pose[i].rotation) < 1U << 28)
      return detail::wrong_skin(i);  // shorter than a half: no direction to rotate to
    const Transform own =
        detail::placed(detail::between(pose[i].rotation, pose[i].rotation, 0), pose[i].translation, pose[i].scale);
    const std::uint16_t parent = skin.joints[i].parent;
    if (parent == kNoJoint) {
      work[i] = own;
    } else if (!multiply(work[parent], own, work[i])) {
      return detail::wrong_skin(i);
    }
  }
  for (std::size_t i = 0; i < joints; ++i) {
    if (!multiply(work[i], skin.joints[i].inverse_bind, work[i])) return detail::wrong_skin(i);
  }
  bits = fraction_bits(work);
  const Grid grid{mesh.centre, mesh.half_extent.x, bits};
  // Joints that move none of these vertices may be far away: other meshes of the skeleton may need them there.
  for (std::size_t i = 0; i < joints; ++i) {
    if (!grid.turn(work[i], work[i]) && has_weight(skin, i)) return detail::wrong_skin(i);
  }
  return {};
}

void pose(const Animation& animation, std::uint32_t time, std::span<JointPose> joints) {
  for (const Track& track : animation.tracks) {
    const auto [from, to, share] = detail::interval_at(animation, track, time);
    JointPose& joint = joints[track.instance];
    set_rotation(joint, detail::between(from->rotation, to->rotation, share));
    joint.translation = detail::between(from->translation, to->translation, share);
    joint.scale = detail::between(from->scale, to->scale, share);
  }
}

void blend(std::span<JointPose> joints, std::span<const JointPose> others, std::uint32_t share) {
  share = std::min<std::uint32_t>(share, 65536);
  for (std::size_t i = 0; i < joints.size() && i < others.size(); ++i) {
    JointPose& joint = joints[i];
    std::int16_t other[4];
    std::int32_t cosine = 0;  // 4.28
    for (int k = 0; k < 4; ++k) cosine += (std::int32_t{joint.rotation[k]} * others[i].rotation[k]) >> 2;
    for (int k = 0; k < 4; ++k) {
      const std::int32_t c = others[i].rotation[k];
      other[k] = static_cast<std::int16_t>(std::min<std::int32_t>(cosine < 0 ? -c : c, 32767));
    }
    set_rotation(joint, detail::between(joint.rotation, other, share));
    joint.translation = detail::between(joint.translation, others[i].translation, share);
    joint.scale = detail::between(joint.scale, others[i].scale, share);
  }
}

Status pose_skin(Skinning& skinning, std::span<const JointPose> pose) {
  int bits = 0;
  const Status status = detail::make_matrices(*skinning.skin, pose, skinning.matrices, bits);
  skinning.fraction_bits = status ? bits : 0;
  return status;
}

}  // namespace zstrip
