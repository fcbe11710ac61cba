// A skin of one of a scene's meshes, and what moves its joints, read from the fuzzer's bytes.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "input.hpp"
#include "require.hpp"
#include "zstrip/base/math.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip/skin.hpp"

namespace fuzz {

/// Owns the skin and the moved mesh, each array in heap memory of exactly its size. A zero byte: none.
class SkinInput {
 public:
  /// `scene` is valid.
  SkinInput(const zstrip::Scene& scene, Input& input) : meshes_(scene.meshes.begin(), scene.meshes.end()) {
    const std::uint32_t choice = input.below(4);
    if (choice == 0 || meshes_.empty()) return;
    is_hostile_ = choice == 3;
    zstrip::Mesh& mesh = meshes_[input.below(static_cast<std::uint32_t>(meshes_.size()))];
    bind_ = mesh;
    if (!is_hostile_) {
      const zstrip::Vec3& half = bind_.half_extent;
      const zstrip::Fixed largest = std::max({half.x, half.y, half.z, 1});
      bind_.half_extent = {largest, largest, largest};
      bind_.billboard = zstrip::Billboard::none;
    }
    read_joints(input);
    read_vertices(input);
    read_animation(input);
    time_ = input.any<std::uint16_t>();
    share_ = input.any<std::uint16_t>() * 2U;
    skin_ = {.mesh = &bind_, .vertices = vertices_, .joints = joints_, .rest = rest_};
    // The rest may be anything; only within the documented ranges the skin is moved.
    if (!zstrip::validate(skin_) || !zstrip::validate(animation(), static_cast<std::uint32_t>(joints_.size()))) return;
    mesh = bind_;
    zstrip::Scene bound = scene;
    bound.meshes = meshes_;
    if (!zstrip::validate(bound) || !move()) {
      meshes_.assign(scene.meshes.begin(), scene.meshes.end());
      return;
    }
    mesh = zstrip::moved_mesh(bind_, moved_.spans());
    bound.meshes = meshes_;
    const zstrip::Status status = zstrip::validate(bound);
    require(static_cast<bool>(status), "a moved mesh is as valid as the one that was modelled: %s",
            zstrip::message(status.error));
  }
  SkinInput(const SkinInput&) = delete;
  SkinInput& operator=(const SkinInput&) = delete;

  /// For Scene::meshes: as the skin moves them, or as they were.
  std::span<const zstrip::Mesh> meshes() const { return meshes_; }

 private:
  struct Moved {
    std::vector<zstrip::Position> positions;
    std::vector<zstrip::Normal> normals;
    std::vector<zstrip::Meshlet> meshlets;
    std::vector<zstrip::Transform> work;

    Moved() = default;
    Moved(const zstrip::Mesh& mesh, std::size_t joints, std::uint8_t garbage)
        : positions(mesh.positions.size()), normals(mesh.normals.size()), meshlets(mesh.meshlets.size()), work(joints) {
      fill(positions, garbage), fill(normals, garbage), fill(meshlets, garbage), fill(work, garbage);
    }
    zstrip::MovedVertices spans() { return {positions, normals, meshlets}; }

   private:
    template <class T>
    static void fill(std::vector<T>& array, std::uint8_t garbage) {
      if (!array.empty()) std::memset(static_cast<void*>(array.data()), garbage, array.size() * sizeof(T));
    }
  };

  template <class T>
  static bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
  }

  zstrip::Animation animation() const { return {.tracks = tracks_, .keyframes = keyframes_, .duration = duration_}; }

  /// About one axis, of unit length.
  static void read_rotation(Input& input, std::int16_t (&rotation)[4]) {
    const std::uint32_t axis = input.below(3);
    const zstrip::Angle half = input.any<std::uint16_t>() / 4U;  // so that the next one is less than half a turn away
    for (std::int16_t& component : rotation) component = 0;
    rotation[axis] = static_cast<std::int16_t>(zstrip::sine(half) / 32769);
    rotation[3] = static_cast<std::int16_t>(zstrip::cosine(half) / 32769);
  }
  zstrip::Vec3 read_vector(Input& input, zstrip::Fixed usual, zstrip::Fixed limit) const {
    const auto component = [&] {
      const zstrip::Fixed value = input.number(usual);
      return is_hostile_ ? value : std::clamp(value, -limit, limit);
    };
    const zstrip::Fixed x = component();
    const zstrip::Fixed y = component();
    return {x, y, component()};
  }

  void read_joints(Input& input) {
    joints_.resize(1 + input.below(5));
    rest_.resize(joints_.size());
    constexpr zstrip::Fixed kMaxScale = 255 * zstrip::kFixedOne;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      zstrip::Joint& joint = joints_[i];
      if (i != 0 && !input.flag())
        joint.parent = static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(i)));
      if (is_hostile_ && input.flag()) joint.parent = input.any<std::uint16_t>();
      if (input.flag()) {
        for (auto& row : joint.inverse_bind.m) {
          for (int column = 0; column < 3; ++column) row[column] = input.number(0);
        }
      }
      for (auto& row : joint.inverse_bind.m) row[3] = input.number(0);
      zstrip::JointPose& pose = rest_[i];
      read_rotation(input, pose.rotation);
      if (is_hostile_ && input.flag()) {
        for (std::int16_t& component : pose.rotation) component = input.any<std::int16_t>();
      }
      pose.translation = read_vector(input, 0, INT32_MAX);
      pose.scale = read_vector(input, zstrip::kFixedOne, kMaxScale);
    }
  }

  void read_vertices(Input& input) {
    vertices_.resize(is_hostile_ && input.flag() ? input.below(30) : bind_.positions.size());
    const auto joints = static_cast<std::uint32_t>(joints_.size());
    for (zstrip::VertexJoints& vertex : vertices_) {
      for (std::uint8_t& joint : vertex.joints) joint = static_cast<std::uint8_t>(input.below(joints));
      if (joints == 1) continue;
      const std::uint32_t second = input.below(128), third = second == 0 ? 0 : input.below(128);
      vertex.weights[0] = static_cast<std::uint8_t>(255 - second - third);
      vertex.weights[1] = static_cast<std::uint8_t>(second);
      vertex.weights[2] = static_cast<std::uint8_t>(third);
    }
    if (!is_hostile_ || vertices_.empty()) return;
    zstrip::VertexJoints& last = vertices_.back();
    for (std::uint8_t& joint : last.joints) joint = static_cast<std::uint8_t>(joint + input.below(3));
    for (std::uint8_t& weight : last.weights) weight = static_cast<std::uint8_t>(weight + input.below(3));
  }

  void read_animation(Input& input) {
    const std::uint32_t tracks = input.below(4);
    duration_ = 1 + input.below(2000);
    for (std::uint32_t i = 0; i < tracks; ++i) {
      zstrip::Track track{
          .instance = static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(joints_.size()))),
          .count = static_cast<std::uint16_t>(1 + input.below(3)),
          .first = static_cast<std::uint32_t>(keyframes_.size())};
      std::uint32_t time = 0;
      for (std::uint32_t k = 0; k < track.count; ++k) {
        zstrip::Keyframe& keyframe = keyframes_.emplace_back();
        keyframe.time = time;
        time += 1 + input.any<std::uint8_t>() * 8U;
        read_rotation(input, keyframe.rotation);
        keyframe.translation = read_vector(input, 0, INT32_MAX);
        keyframe.scale = read_vector(input, zstrip::kFixedOne, 255 * zstrip::kFixedOne);
      }
      if (is_hostile_ && input.flag()) {
        track.count = input.any<std::uint16_t>();
        track.first = input.any<std::uint32_t>();
      }
      tracks_.push_back(track);
    }
  }

  /// Twice, into memory with other contents. False if the pose is refused.
  bool move() {
    std::vector<zstrip::JointPose> poses = rest_;
    zstrip::pose(animation(), time_, poses);
    zstrip::blend(poses, rest_, share_);
    moved_ = Moved(bind_, joints_.size(), 0xA5);
    const zstrip::Status status = zstrip::skin_mesh(skin_, poses, moved_.work, moved_.spans());
    Moved again(bind_, joints_.size(), 0x5A);
    require(zstrip::skin_mesh(skin_, poses, again.work, again.spans()) == status, "the same status each time");
    require(
        zstrip::skin_mesh(skin_, poses, std::span(again.work).subspan(1), again.spans()).error == zstrip::Error::skin,
        "a span of another size is refused");
    if (!status) {
      require(status.error == zstrip::Error::skin && status.needed < std::max(joints_.size(), bind_.positions.size()),
              "a refusal names joint or vertex");
      return false;
    }
    require(same(moved_.positions, again.positions) && same(moved_.normals, again.normals) &&
                same(moved_.meshlets, again.meshlets),
            "the same mesh, whatever was in its memory");
    return true;
  }

  bool is_hostile_ = false;
  std::vector<zstrip::Mesh> meshes_;
  zstrip::Mesh bind_{};
  std::vector<zstrip::Joint> joints_;
  std::vector<zstrip::JointPose> rest_;
  std::vector<zstrip::VertexJoints> vertices_;
  std::vector<zstrip::Track> tracks_;
  std::vector<zstrip::Keyframe> keyframes_;
  std::uint32_t duration_ = 0, time_ = 0, share_ = 0;
  zstrip::Skin skin_;
  Moved moved_;
};

}  // namespace fuzz
