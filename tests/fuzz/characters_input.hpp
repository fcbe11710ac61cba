// Skins and morph targets of a scene's meshes and the clips that move them, read from the fuzzer's bytes.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "input.hpp"
#include "zstrip/base/math.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"

namespace fuzz {

/// Owns meshes, skins, morph targets and clips. A zero byte: none, and the meshes are the scene's.
class CharactersInput {
 public:
  CharactersInput(const zstrip::Scene& scene, Input& input) : meshes_(scene.meshes.begin(), scene.meshes.end()) {
    const std::uint32_t choice = input.below(4);
    if (choice == 0 || meshes_.empty()) return;
    is_hostile_ = choice == 3;
    read_joints(input);
    vertices_.resize(meshes_.size());
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      if (i == 0 || input.flag()) read_skin(i, input);
    }
    clips_.resize(input.below(3));
    parts_.resize(2 * clips_.size());
    const auto instances = static_cast<std::uint32_t>(scene.instances.size());
    for (std::size_t i = 0; i < clips_.size(); ++i) {
      const std::uint32_t duration = is_hostile_ ? input.below(2000) : 1 + input.below(2000);
      clips_[i] = {.name = i == 0 ? "walk" : "", .instances = {}, .joints = {}};
      if (instances != 0) read_tracks(parts_[2 * i], instances, input);
      read_tracks(parts_[2 * i + 1], static_cast<std::uint32_t>(joints_.size()), input);
      clips_[i].instances = {parts_[2 * i].tracks, parts_[2 * i].keyframes, duration};
      clips_[i].joints = {parts_[2 * i + 1].tracks, parts_[2 * i + 1].keyframes, duration};
    }
    if (input.flag()) read_morphs(input);
  }
  CharactersInput(const CharactersInput&) = delete;
  CharactersInput& operator=(const CharactersInput&) = delete;

  std::span<const zstrip::Mesh> meshes() const { return meshes_; }
  std::span<const zstrip::Skin> skins() const { return skins_; }
  std::span<const zstrip::Clip> clips() const { return clips_; }
  std::span<const zstrip::MovedMorph> morphs() const { return morphs_; }

  /// Whether a blob of `scene`, which is valid and has these meshes, opens.
  bool valid(const zstrip::Scene& scene) const {
    const auto is_skin = [this](std::size_t mesh) {
      return std::ranges::any_of(skins_, [&](const zstrip::Skin& skin) { return skin.mesh == &meshes_[mesh]; });
    };
    const auto of_skin = [&](const auto& set) { return is_skin(set.mesh); };
    if (std::ranges::any_of(scene.lines, of_skin) || std::ranges::any_of(scene.edges, of_skin)) return false;
    const auto csg = [&](const zstrip::CsgOperand& operand) { return is_skin(scene.instances[operand.instance].mesh); };
    if (std::ranges::any_of(scene.csg, csg)) return false;
    const auto right = [](const zstrip::Skin& skin) { return static_cast<bool>(zstrip::validate(skin)); };
    if (!std::ranges::all_of(skins_, right)) return false;
    const auto morphs = [](const zstrip::MovedMorph& mesh) { return static_cast<bool>(zstrip::validate(mesh.morph)); };
    if (!std::ranges::all_of(morphs_, morphs)) return false;
    const auto instances = static_cast<std::uint32_t>(scene.instances.size());
    return std::ranges::all_of(clips_, [&](const zstrip::Clip& clip) {
      if (!morphs_.empty() && !zstrip::validate(clip.weights, weights_)) return false;
      return clip.duration() != 0 && zstrip::validate(clip.instances, instances) &&
             zstrip::validate(clip.joints, skins_.empty() ? 0 : static_cast<std::uint32_t>(joints_.size()));
    });
  }

 private:
  struct Part {
    std::vector<zstrip::Track> tracks;
    std::vector<zstrip::Keyframe> keyframes;
  };

  static std::array<std::int16_t, 4> read_rotation(Input& input) {
    std::array<std::int16_t, 4> rotation{};
    const zstrip::Angle half = input.any<std::uint16_t>() / 4U;
    rotation[input.below(3)] = static_cast<std::int16_t>(zstrip::sine(half) / 32769);
    rotation[3] = static_cast<std::int16_t>(zstrip::cosine(half) / 32769);
    return rotation;
  }
  static zstrip::Vec3 read_vector(Input& input, zstrip::Fixed usual) {
    const zstrip::Fixed x = input.number(usual);
    const zstrip::Fixed y = input.number(usual);
    return {x, y, input.number(usual)};
  }

  void read_joints(Input& input) {
    joints_.resize(1 + input.below(4));
    rest_.resize(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (i != 0) joints_[i].parent = static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(i)));
      if (is_hostile_ && input.flag()) joints_[i].parent = input.any<std::uint16_t>();
      for (auto& row : joints_[i].inverse_bind.m) row[3] = input.number(0);
      std::ranges::copy(read_rotation(input), rest_[i].rotation);
      rest_[i].translation = read_vector(input, 0);
      if (is_hostile_) rest_[i].scale = read_vector(input, zstrip::kFixedOne);
    }
  }

  void read_skin(std::size_t index, Input& input) {
    zstrip::Mesh& mesh = meshes_[index];
    const zstrip::Vec3& half = mesh.half_extent;
    const zstrip::Fixed largest = std::max({half.x, half.y, half.z, 1});
    mesh.half_extent = {largest, largest, largest};
    if (!is_hostile_) mesh.billboard = zstrip::Billboard::none;
    vertices_[index].resize(mesh.positions.size());
    const auto joints = static_cast<std::uint32_t>(joints_.size());
    for (zstrip::VertexJoints& vertex : vertices_[index]) {
      for (std::uint8_t& joint : vertex.joints) joint = static_cast<std::uint8_t>(input.below(joints));
      const std::uint32_t second = input.below(128);
      vertex.weights[0] = static_cast<std::uint8_t>(255 - second);
      vertex.weights[1] = static_cast<std::uint8_t>(second);
      if (is_hostile_ && input.flag()) vertex.weights[3] = input.any<std::uint8_t>();
    }
    skins_.push_back({.mesh = &mesh, .vertices = vertices_[index], .joints = joints_, .rest = rest_});
  }

  /// A target's tables.
  struct Offsets {
    std::vector<zstrip::MorphRun> runs;
    std::vector<zstrip::MorphOffset> positions;
    std::vector<zstrip::NormalOffset> normals;
  };

  void read_morphs(Input& input) {
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      if (!input.flag()) continue;
      zstrip::Mesh& mesh = meshes_[i];
      const zstrip::Vec3& half = mesh.half_extent;
      const zstrip::Fixed largest = std::max({half.x, half.y, half.z, 1});
      mesh.half_extent = {largest, largest, largest};
      if (!is_hostile_) mesh.billboard = zstrip::Billboard::none;
      std::vector<zstrip::MorphTarget>& targets = targets_.emplace_back();
      for (std::uint32_t count = (is_hostile_ ? 0U : 1U) + input.below(3); count > 0; --count) {
        targets.push_back(read_target(mesh, input));
      }
      morphs_.push_back({.morph = {&mesh, targets}, .vertices = {}, .mesh = static_cast<std::uint16_t>(i)});
    }
    for (zstrip::Clip& clip : clips_) {
      std::vector<zstrip::WeightKey>& keys = weight_keys_.emplace_back();
      std::vector<zstrip::Track>& tracks = weight_tracks_.emplace_back();
      for (std::uint32_t i = weights_ == 0 ? 0 : input.below(3); i > 0; --i) {
        tracks.push_back({.instance = static_cast<std::uint16_t>(input.below(weights_ + (is_hostile_ ? 1 : 0))),
                          .count = 2,
                          .first = static_cast<std::uint32_t>(keys.size())});
        keys.push_back({0, input.any<std::int16_t>()});
        keys.push_back({is_hostile_ ? input.below(200) : 1 + input.below(200), input.any<std::int16_t>()});
      }
      clip.weights = {tracks, keys, clip.duration()};
    }
  }

  zstrip::MorphTarget read_target(const zstrip::Mesh& mesh, Input& input) {
    Offsets& offsets = offsets_.emplace_back();
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    std::uint32_t next = 0;
    for (std::uint32_t count = input.below(4); count > 0 && next < vertices; --count) {
      zstrip::MorphRun run{.first_vertex = static_cast<std::uint16_t>(next + input.below(vertices - next)),
                           .count = 1,
                           .first_offset = static_cast<std::uint16_t>(offsets.positions.size())};
      run.count = static_cast<std::uint16_t>(run.count + input.below(vertices - run.first_vertex));
      next = run.first_vertex + std::uint32_t{run.count};
      for (std::uint32_t i = 0; i < run.count; ++i) {
        offsets.positions.push_back({input.any<std::int16_t>(), input.any<std::int16_t>(), input.any<std::int16_t>()});
      }
      if (is_hostile_ && input.flag()) run.first_offset = input.any<std::uint16_t>();
      offsets.runs.push_back(run);
    }
    if (!mesh.normals.empty() && input.flag()) offsets.normals.assign(offsets.positions.size(), {50, -50, 127});
    const auto weight = static_cast<std::uint16_t>(input.below(4));
    weights_ = std::max(weights_, weight + 1U);
    return {.weight = weight, .runs = offsets.runs, .positions = offsets.positions, .normals = offsets.normals};
  }

  void read_tracks(Part& part, std::uint32_t moved, Input& input) const {
    for (std::uint32_t i = input.below(3); i > 0; --i) {
      zstrip::Track track{.instance = static_cast<std::uint16_t>(input.below(moved + (is_hostile_ ? 1 : 0))),
                          .count = static_cast<std::uint16_t>(1 + input.below(3)),
                          .first = static_cast<std::uint32_t>(part.keyframes.size())};
      std::uint32_t time = 0;
      for (std::uint32_t k = 0; k < track.count; ++k) {
        const std::array<std::int16_t, 4> q = read_rotation(input);
        part.keyframes.push_back(
            {time, {q[0], q[1], q[2], q[3]}, read_vector(input, 0), {65536, 65536, input.between(1, 1 << 24)}});
        time += is_hostile_ ? input.below(200) : 1 + input.below(200);
      }
      part.tracks.push_back(track);
    }
  }

  bool is_hostile_ = false;
  std::vector<zstrip::Mesh> meshes_;
  std::vector<zstrip::Skin> skins_;
  std::vector<zstrip::Joint> joints_;
  std::vector<zstrip::JointPose> rest_;
  std::vector<std::vector<zstrip::VertexJoints>> vertices_;
  std::vector<Part> parts_;
  std::vector<zstrip::Clip> clips_;
  std::uint32_t weights_ = 0;
  std::deque<Offsets> offsets_;
  std::deque<std::vector<zstrip::MorphTarget>> targets_;
  std::deque<std::vector<zstrip::WeightKey>> weight_keys_;
  std::deque<std::vector<zstrip::Track>> weight_tracks_;
  std::vector<zstrip::MovedMorph> morphs_;
};

}  // namespace fuzz
