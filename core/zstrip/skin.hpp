// Moves vertices of a mesh by up to four joints of a skeleton, and joints by keyframes. There are two ways. Before a
// frame, into a mesh in RAM, which the scene draws like any other mesh, with every effect, method and mode, and without
// code for skins in the renderer:
//     pose(kWalk, milliseconds, joints);                      // JointPose joints[...], from kSkin.rest
//     skin_mesh(kSkin, joints, work, {positions, normals, meshlets});
//     renderer.begin_frame(...);
// Or during a frame, each meshlet each time that it is drawn, which needs RAM for one meshlet and more time
// (effect::skins):
//     pose_skin(skinning, joints);                            // Mesh::skinning = &skinning
//     renderer.begin_frame(...);
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

inline constexpr std::uint16_t kNoJoint = 0xFFFF;  ///< for Joint::parent
inline constexpr std::uint32_t kMaxJoints = 256;   ///< of a skin

/// A joint of the skeleton: the data that does not change.
struct Joint {
  Transform inverse_bind = Transform::identity();  ///< from the mesh's space to the joint's, as the mesh was modelled
  std::uint16_t parent = kNoJoint;                 ///< an index below the joint's own; kNoJoint: the mesh's space
};

/// The place of a joint in its parent's space. The joint is scaled, then rotated, then moved.
struct JointPose {
  std::int16_t rotation[4]{0, 0, 0, 32767};     ///< 1.15, a quaternion of about unit length: x, y, z, w
  Vec3 translation{0, 0, 0};                    ///< 16.16
  Vec3 scale{kFixedOne, kFixedOne, kFixedOne};  ///< 16.16, +-255
};

/// The joints that move a vertex, the joint with the largest weight first. Weights are in 1/256; the first weight is
/// 1/256 more than its value, so that the four values add up to 255. Joints of weight 0 must be last, and are ignored.
struct VertexJoints {
  std::uint8_t joints[4]{0, 0, 0, 0};     ///< indices into Skin::joints
  std::uint8_t weights[4]{255, 0, 0, 0};  ///< add up to 255
};

/// A mesh and its skeleton, in flash or in a blob.
struct Skin {
  const Mesh* mesh = nullptr;              ///< as it was modelled; its half extents are equal, and its box has room for
                                           ///< every pose
  std::span<const VertexJoints> vertices;  ///< one a vertex
  std::span<const Joint> joints;           ///< 1..kMaxJoints
  std::span<const JointPose> rest;         ///< one a joint: the pose of joints without a track
};

/// Memory for a moved mesh, in RAM. The mesh that is drawn is Skin::mesh with these tables instead of its own.
struct MovedVertices {
  std::span<Position> positions;  ///< as many as the mesh has
  std::span<Normal> normals;      ///< empty if the mesh has no normals
  std::span<Meshlet> meshlets;    ///< empty if the mesh has no meshlets
};

/// Returns the mesh to draw: `mesh` with the tables of `moved`.
constexpr Mesh moved_mesh(const Mesh& mesh, const MovedVertices& moved) {
  Mesh result = mesh;
  result.positions = moved.positions;
  result.normals = moved.normals;
  result.meshlets = moved.meshlets;
  return result;
}

/// A skin that is moved while its mesh is drawn: Mesh::skinning of `skin`'s mesh or of a copy. It lies in RAM, because
/// renderers write to it; two renderers that draw at the same time need one each. Until the first pose_skin the mesh is
/// drawn as it was modelled.
struct Skinning {
  const Skin* skin = nullptr;      ///< must outlive this object
  std::span<Transform> matrices;   ///< one a joint
  std::span<Position> positions;   ///< as many as the mesh's largest meshlet
  std::span<Normal> normals{};     ///< as many as `positions`; empty if the mesh has no normals
  std::int32_t fraction_bits = 0;  ///< binary point of `matrices`, set by pose_skin; 0: no matrices yet
  Mesh moved{};                    ///< written by the renderer
};

/// Returns Error::skin (`needed` = index of the joint or vertex) if counts differ, a parent does not come before its
/// children, a matrix or a scale at rest is out of range, a rotation is shorter than a half, weights do not add up, a
/// joint does not exist, or half extents differ. Check an animation of joints with validate(animation, joints).
constexpr Status validate(const Skin& skin) {
  const auto wrong = [](std::size_t index) {
    return Status{.error = Error::skin, .needed = static_cast<std::uint32_t>(index)};
  };
  if (skin.mesh == nullptr || skin.joints.empty() || skin.joints.size() > kMaxJoints) return wrong(0);
  const Mesh& mesh = *skin.mesh;
  const Vec3& half = mesh.half_extent;
  if (skin.vertices.size() != mesh.positions.size() || skin.rest.size() != skin.joints.size() || half.x <= 0 ||
      half.x != half.y || half.x != half.z || mesh.billboard != Billboard::none) {
    return wrong(0);
  }
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const std::uint16_t parent = skin.joints[i].parent;
    if (parent != kNoJoint && parent >= i) return wrong(i);
    for (const auto& row : skin.joints[i].inverse_bind.m) {
      for (int column = 0; column < 3; ++column) {
        if (row[column] <= -256 * kFixedOne || row[column] >= 256 * kFixedOne) return wrong(i);
      }
    }
    const JointPose& rest = skin.rest[i];
    for (const Fixed scale : {rest.scale.x, rest.scale.y, rest.scale.z}) {
      if (scale < -255 * kFixedOne || scale > 255 * kFixedOne) return wrong(i);
    }
    std::int64_t square = 0;  // 2.30
    for (const std::int64_t c : rest.rotation) square += c * c;
    if (square < 1 << 28) return wrong(i);
  }
  for (std::size_t i = 0; i < skin.vertices.size(); ++i) {
    const VertexJoints& vertex = skin.vertices[i];
    std::uint32_t sum = 0;
    for (int k = 0; k < 4; ++k) {
      if (vertex.joints[k] >= skin.joints.size()) return wrong(i);
      if (k > 1 && vertex.weights[k - 1] == 0 && vertex.weights[k] != 0) return wrong(i);
      sum += vertex.weights[k];
    }
    if (sum != 255) return wrong(i);
  }
  return {};
}

/// Sets all joints that have tracks (Track::instance is the joint) to their values `time` milliseconds after the start;
/// any time is valid. `joints`: as many as in validate. The result has the same bits on every target.
void pose(const Animation& animation, std::uint32_t time, std::span<JointPose> joints);

/// Moves `joints` towards `others` (as many) by `share` / 65536: rotations along the shorter arc, all other values
/// linearly.
void blend(std::span<JointPose> joints, std::span<const JointPose> others, std::uint32_t share);

/// Writes the mesh as its joints move it: positions, normals of unchanged length, and meshlets with new bounding
/// spheres. `work`: one a joint; its contents are not needed afterwards. Safe for skins and animations that passed
/// validate(skin) and validate(animation, joints). Error::skin if the mesh leaves its box (`needed` = the vertex), a
/// joint moves its vertices too far away (`needed` = the joint), or a span has another size (`needed` = 0); `moved`
/// then holds vertices of the old and of the new pose. Time: about 40 products for each joint of each vertex.
Status skin_mesh(const Skin& skin, std::span<const JointPose> pose, std::span<Transform> work,
                 const MovedVertices& moved);

/// Makes the matrices of `skinning`, before the frame that shows them. The frame gets the same vertices as from
/// skin_mesh, except that a vertex outside of the box is moved to the box's side: pose_skin does not see the vertices.
/// Error::skin if a joint moves its vertices too far away (`needed` = the joint) or a span has another size (`needed` =
/// 0).
Status pose_skin(Skinning& skinning, std::span<const JointPose> pose);

}  // namespace zstrip
