// Converts skins to fixed point: the box that holds a mesh in every pose, the joints, and the mesh at rest.
#include "import/quantised_skins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "import/quantise.hpp"
#include "import/quantised_morphs.hpp"

namespace zstrip::sim {
namespace {

/// Returns boxes in the joints' coordinates, for the joints that have vertices of this mesh; other boxes are empty.
std::vector<SourceBox> boxes_of_joints(const SourceModel& source, const SourceMesh& mesh) {
  std::vector<SourceBox> boxes(source.joints.size());
  for (const SourceVertex& vertex : mesh.vertices) {
    for_each_place(source, vertex, [&](const Vector& place) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (k > 0 && vertex.weights[k] == 0) break;
        const std::size_t joint = vertex.joints[k];
        include(boxes[joint], source.joints[joint].inverse_bind * place);
      }
    });
  }
  return boxes;
}

std::int16_t to_15_bits(double value) { return static_cast<std::int16_t>(std::lround(32767 * value)); }

/// Returns false if the pose is out of range.
bool to_joint_pose(const Affine& local, JointPose& pose) {
  const Placement placement = to_placement(local);
  const auto within = [](const Vector& v, double limit) {
    return std::ranges::all_of(v, [limit](double c) { return std::abs(c) <= limit; });
  };
  if (!within(placement.translation, 32767) || !within(placement.scale, 255)) return false;
  for (std::size_t i = 0; i < 4; ++i) pose.rotation[i] = to_15_bits(placement.rotation[i]);
  const auto fixed = [](const Vector& v) { return Vec3{to_fixed(v[0]), to_fixed(v[1]), to_fixed(v[2])}; };
  pose.translation = fixed(placement.translation);
  pose.scale = fixed(placement.scale);
  return true;
}

bool to_transform(const Affine& from, Transform& to) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double value = from.m[row][column];
      if (!(std::abs(value) < (column == 3 ? 32767 : 255))) return false;
      to.m[row][column] = to_fixed(value);
    }
  }
  return true;
}

/// True if a joint rotates or scales so much between two poses that the poses between may not be close to either.
bool are_far_apart(const std::vector<Affine>& from, const std::vector<Affine>& to) {
  constexpr double kFar = 0.35;  // a rotation by 20 degrees
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t column = 0; column < 3; ++column) {
      double square = 0, change = 0;
      for (std::size_t row = 0; row < 3; ++row) {
        const double a = from[i].m[row][column], b = to[i].m[row][column];
        square += a * a;
        change += (b - a) * (b - a);
      }
      if (change > kFar * kFar * square) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Affine> joint_places(const SourceModel& source, const NodeAnimation* animation, double seconds) {
  std::vector<Affine> places;
  for (const SourceJoint& joint : source.joints) {
    const Affine parent = joint.parent == kNoSourceJoint ? Affine{} : places[joint.parent];
    places.push_back(joint.node == kNoNode ? parent : parent * source.nodes.local(animation, joint.node, seconds));
  }
  return places;
}

SourceBox box_of_poses(const SourceModel& source, const SourceMesh& mesh) {
  SourceBox box;
  for (const SourceVertex& vertex : mesh.vertices) {
    for_each_place(source, vertex, [&](const Vector& place) { include(box, place); });
  }
  const std::vector<SourceBox> boxes = boxes_of_joints(source, mesh);
  const auto include_pose = [&](const NodeAnimation* animation, double seconds) {
    std::vector<Affine> places = joint_places(source, animation, seconds);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!is_empty(boxes[i]))
        for_each_corner(boxes[i], [&](const Vector& corner) { include(box, places[i] * corner); });
    }
    return places;
  };
  include_pose(nullptr, 0);
  for (const NodeAnimation& animation : source.nodes.animations) {
    std::set<double> times = key_times(animation);
    constexpr double kMaxSampledTimes = 20000;
    const double count = std::min(kMaxSampledTimes, std::ceil(animation.duration * 60));
    for (double i = 0; i <= count; ++i) times.insert(animation.duration * i / count);
    double before = 0;
    std::vector<Affine> last;
    for (const double seconds : times) {
      std::vector<Affine> places = include_pose(&animation, seconds);
      constexpr int kSteps = 16;  // from one key to the next, which are at most 180 degrees apart
      if (!last.empty() && are_far_apart(last, places)) {
        for (int i = 1; i < kSteps; ++i) include_pose(&animation, before + (seconds - before) * i / kSteps);
      }
      before = seconds;
      last = std::move(places);
    }
  }
  return box;
}

Affine local_of(const Model& model, std::size_t joint, const NodeAnimation* animation, double seconds) {
  const ModelJoint& at = model.joint_nodes[joint];
  const double size = at.parent == kNoSourceJoint ? 1 : model.joint_nodes[at.parent].size;
  Affine local = at.node == kNoNode ? Affine{} : model.tree.local(animation, at.node, seconds);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) local.m[row][column] *= size / at.size;
    double& moved = local.m[row][3];
    if (at.parent == kNoSourceJoint) moved -= model.units.origin[row];
    moved *= size * model.units.scale;
  }
  return local;
}

Result<Done> set_joints(const SourceModel& source, Model& model) {
  if (model.skins.empty()) return Done{};
  const auto out_of_range = [] {
    return Failure{ExitStatus::input,
                   "has joints that are too far away, or too large or small for the meshes that they move"};
  };
  // An armature's own scale, often 1/100, would leave few significant bits in a matrix.
  const std::vector<Affine> at_rest = joint_places(source, nullptr, 0);
  for (std::size_t i = 0; i < source.joints.size(); ++i) {
    const double size = std::cbrt(std::abs(determinant(at_rest[i])));
    model.joint_nodes.push_back({.parent = source.joints[i].parent, .node = source.joints[i].node, .size = size});
  }
  for (std::size_t i = 0; i < source.joints.size(); ++i) {
    const SourceJoint& from = source.joints[i];
    JointPose pose;
    if (!to_joint_pose(local_of(model, i, nullptr, 0), pose)) return out_of_range();
    model.rest.push_back(pose);
    // Both sides in scene units: the scale is not included, and the origin is added first.
    Affine bind = from.inverse_bind;
    const Vector moved =
        from.inverse_bind * Vector{model.units.origin[0], model.units.origin[1], model.units.origin[2]};
    const double size = model.joint_nodes[i].size;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) bind.m[row][column] *= size;
      bind.m[row][3] = moved[row] * size * model.units.scale;
    }
    Joint joint;
    if (from.parent != kNoSourceJoint) joint.parent = static_cast<std::uint16_t>(from.parent);
    if (from.has_vertices && !to_transform(bind, joint.inverse_bind)) return out_of_range();
    model.joints.push_back(joint);
  }
  // The reach of each joint at rest: its own vertices, and those that its children move.
  for (const SourceMesh& mesh : source.meshes) {
    if (!mesh.has_skin) continue;
    const std::vector<SourceBox> boxes = boxes_of_joints(source, mesh);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (is_empty(boxes[i])) continue;
      for_each_corner(boxes[i], [&](Vector corner) {
        for (std::size_t joint = i; joint != kNoSourceJoint; joint = source.joints[joint].parent) {
          double& reach = model.joint_nodes[joint].reach;
          const double size = model.joint_nodes[joint].size * model.units.scale;
          reach = std::max(reach, std::hypot(corner[0], corner[1], corner[2]) * size);
          if (source.joints[joint].node != kNoNode) {
            corner = source.nodes.local(nullptr, source.joints[joint].node, 0) * corner;
          }
        }
      });
    }
  }
  std::vector<Transform> work(model.joints.size());
  for (ModelSkin& skin : model.skins) {
    MeshData& drawn = model.mesh_data.emplace_back();
    drawn.positions.resize(skin.bind.positions.size());
    drawn.normals.resize(skin.bind.normals.size());
    drawn.meshlets.resize(skin.bind.meshlets.size());
    const MovedVertices moved{drawn.positions, drawn.normals, drawn.meshlets};
    const Skin of_core{&skin.bind, skin.vertices, model.joints, model.rest};
    Status status = validate(of_core);
    if (status) status = skin_mesh(of_core, model.rest, work, moved);
    if (!status) {
      return Failure{ExitStatus::input, fmt::format("has a skin that cannot be drawn: {}", message(status.error))};
    }
    model.meshes[skin.mesh] = moved_mesh(skin.bind, moved);
  }
  return Done{};
}

}  // namespace zstrip::sim
