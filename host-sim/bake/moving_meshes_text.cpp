// See moving_meshes_text.hpp.
#include "bake/moving_meshes_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace zstrip::sim {
namespace {

/// The largest number of a skin's vertices, or of a mesh's morph offsets, that the compiler checks: with more, Clang
/// reaches its limit of steps. The import has checked all of them.
constexpr std::size_t kMaxChecked = 8192;

class MovingMeshes {
 public:
  MovingMeshes(const BakedSkins& skins, HeaderText& out) : skins_(skins), out_(out) {}

  /// Writes the mesh table, and the tables that move its meshes.
  void meshes(std::size_t count, const std::string& at_rest) {
    const std::vector<std::size_t> moved = moved_meshes();
    out_.line(
        fmt::format("\n/// The meshes before joints and morph targets move some of them.\n"
                    "inline constexpr zstrip::Mesh kBindMeshes[{}] = {{\n{}}};",
                    count, at_rest));
    std::string arrays, spans, meshes;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const Mesh& unmoved = *skins_.unmoved(moved[i]);
      const auto in_ram = [&](const char* type, const char* name, std::size_t length) {
        if (length == 0) return std::string("{}");
        arrays += fmt::format("inline zstrip::{} {}{}[{}];\n", type, name, i, length);
        return fmt::format("{}{}", name, i);
      };
      spans += "    {.positions = " + in_ram("Position", "moved_positions", unmoved.positions.size());
      spans += ", .normals = " + in_ram("Normal", "moved_normals", unmoved.normals.size());
      spans += ", .meshlets = " + in_ram("Meshlet", "moved_meshlets", unmoved.meshlets.size()) + "},\n";
    }
    out_.add(
        fmt::format("/// The moved vertices, in RAM: zeros, not the rest pose, before the first {2}.\n{1}"
                    "inline constexpr zstrip::MovedVertices kMoved[{0}] = {{\n{3}}};\n",
                    moved.size(), arrays, pose_function_of(skins_), spans));
    if (!skins_.morphs.empty()) morphs(moved);
    if (!skins_.meshes.empty()) skins_of_meshes();
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = std::ranges::find(moved, i);
      meshes += at == moved.end()
                    ? fmt::format("    kBindMeshes[{}],\n", i)
                    : fmt::format("    zstrip::moved_mesh(kBindMeshes[{}], kMoved[{}]),\n", i, at - moved.begin());
    }
    out_.add(fmt::format("/// The meshes that are drawn.\ninline constexpr zstrip::Mesh kMeshes[{}] = {{\n{}}};\n",
                         count, meshes));
  }

  void weight_animation() {
    out_.line(
        "\n/// The motion of the weights: Track::instance is the index of a weight. It lasts as long as kAnimation.");
    const WeightAnimation& animation = skins_.weight_animation;
    const std::string tracks = out_.array("zstrip::Track", "kWeightTracks", animation.tracks);
    const std::string keys = out_.array("zstrip::WeightKey", "kWeightKeys", animation.keys);
    out_.line(fmt::format(
        "inline constexpr zstrip::WeightAnimation kWeightAnimation{{.tracks = {}, .keys = {}, .duration = {}}};",
        tracks, keys, animation.duration));
    out_.add(fmt::format(
        "/// A weight of 0 is the file's weight at rest. Weights without a track are the program's.\n"
        "inline zstrip::MorphWeight morph_weights[{0}];\n"
        "/// Moves the vertices by morph_weights.\n"
        "inline zstrip::Status move_morphs() {{\n"
        "  for (std::uint32_t i = 0; i < {1}; ++i) {{\n"
        "    const zstrip::Status moved = zstrip::morph_mesh(kMorphs[i], morph_weights, kMoved[kMovedByMorph[i]]);\n"
        "    if (!moved) return moved;\n"
        "  }}\n"
        "  return {{}};\n"
        "}}\n"
        "/// Moves the vertices to their place at any time, in milliseconds after the animation's start. {2}\n"
        "inline zstrip::Status pose_morphs(std::uint32_t milliseconds) {{\n"
        "  zstrip::pose(kWeightAnimation, milliseconds, morph_weights);\n"
        "  return move_morphs();\n"
        "}}\n",
        skins_.weights, skins_.morphs.size(),
        skins_.meshes.empty() ? "Call it before\n/// begin_frame." : "pose_skins\n/// calls it."));
  }

  void joint_animation() {
    out_.line(
        "\n/// The motion of the joints: Track::instance is the index of a joint. It lasts as long as kAnimation.");
    const std::string tracks = out_.array("zstrip::Track", "kJointTracks", skins_.animation.tracks);
    const std::string keyframes = out_.array("zstrip::Keyframe", "kJointKeyframes", skins_.animation.keyframes);
    out_.line(fmt::format(
        "inline constexpr zstrip::Animation kJointAnimation{{.tracks = {}, .keyframes = {}, .duration = {}}};", tracks,
        keyframes, skins_.animation.duration));
    // The defaults of JointPose are not all zeros, so that they would take the same amount of flash again.
    std::string zeros;
    for (std::size_t i = 0; i < skins_.joints.size(); ++i) {
      constexpr std::size_t kInALine = 8;
      zeros += i == 0 ? "{{}, {}, {}}" : i % kInALine == 0 ? ",\n    {{}, {}, {}}" : ", {{}, {}, {}}";
    }
    out_.add(fmt::format(
        "inline zstrip::JointPose joint_poses[{0}] = {{\n    {1}}};\n"
        "inline zstrip::Transform joint_work[{0}];\n"
        "/// Moves the skins to their place at any time, in milliseconds after the animation's start. Call it before\n"
        "/// begin_frame.\n"
        "inline zstrip::Status pose_skins(std::uint32_t milliseconds) {{\n"
        "{3}"
        "  std::ranges::copy(kJointRest, joint_poses);\n"
        "  zstrip::pose(kJointAnimation, milliseconds, joint_poses);\n"
        "  for (std::uint32_t i = 0; i < {2}; ++i) {{\n"
        "    const zstrip::Status moved = zstrip::skin_mesh(kSkins[i], joint_poses, joint_work, kMoved[i]);\n"
        "    if (!moved) return moved;\n"
        "  }}\n"
        "  return {{}};\n"
        "}}\n",
        skins_.joints.size(), zeros, skins_.meshes.size(),
        skins_.morphs.empty()
            ? ""
            : "  if (const zstrip::Status morphed = pose_morphs(milliseconds); !morphed) return morphed;\n"));
  }

 private:
  /// Returns the meshes that move: those with skins, then the others with morph targets.
  std::vector<std::size_t> moved_meshes() const {
    std::vector<std::size_t> moved;
    for (const ModelSkin& skin : skins_.meshes) moved.push_back(skin.mesh);
    for (const ModelMorph& morph : skins_.morphs) {
      if (skins_.find(morph.mesh) == nullptr) moved.push_back(morph.mesh);
    }
    return moved;
  }

  /// Writes the skins, of bind meshes or of morphed meshes.
  void skins_of_meshes() {
    out_.array("zstrip::Joint", "kJoints", skins_.joints);
    out_.array("zstrip::JointPose", "kJointRest", skins_.rest);
    std::string skins, checks, morphed;
    std::size_t morphed_count = 0;
    for (std::size_t i = 0; i < skins_.meshes.size(); ++i) {
      const ModelSkin& skin = skins_.meshes[i];
      const std::string vertices = out_.array("zstrip::VertexJoints", fmt::format("kVertexJoints{}", i), skin.vertices);
      std::string mesh = fmt::format("kBindMeshes[{}]", skin.mesh);
      if (skins_.find_morph(skin.mesh) != nullptr) {
        morphed += fmt::format("    zstrip::moved_mesh({}, kMoved[{}]),\n", mesh, i);
        mesh = fmt::format("kMorphedMeshes[{}]", morphed_count++);
      }
      skins +=
          fmt::format("    {{.mesh = &{}, .vertices = {}, .joints = kJoints, .rest = kJointRest}},\n", mesh, vertices);
      if (skin.vertices.size() <= kMaxChecked) {
        checks += fmt::format("static_assert(zstrip::validate(kSkins[{}]));\n", i);
      }
    }
    if (morphed_count > 0) {
      out_.add(
          fmt::format("/// What morph targets have moved, and skins move further.\n"
                      "inline constexpr zstrip::Mesh kMorphedMeshes[{}] = {{\n{}}};\n",
                      morphed_count, morphed));
    }
    out_.add(fmt::format("inline constexpr zstrip::Skin kSkins[{0}] = {{\n{1}}};\n{2}\n", skins_.meshes.size(), skins,
                         checks));
  }

  /// Writes the morph targets. `moved`: the mesh of each element of kMoved.
  void morphs(const std::vector<std::size_t>& moved) {
    std::string morphs, indices, checks;
    for (std::size_t i = 0; i < skins_.morphs.size(); ++i) {
      const ModelMorph& morph = skins_.morphs[i];
      std::string targets;
      std::size_t offsets = 0;
      for (std::size_t k = 0; k < morph.targets.size(); ++k) {
        const MorphTarget& target = morph.targets[k];
        const auto name = [&](const char* what) { return fmt::format("k{}{}Of{}", what, k, i); };
        targets += fmt::format("    {{.weight = {}, .runs = {}, .positions = {}, .normals = {}}},\n", target.weight,
                               out_.array("zstrip::MorphRun", name("MorphRuns"), target.runs),
                               out_.array("zstrip::MorphOffset", name("MorphOffsets"), target.positions),
                               out_.array("zstrip::NormalOffset", name("NormalOffsets"), target.normals));
        offsets += target.positions.size();
      }
      out_.add(fmt::format("inline constexpr zstrip::MorphTarget kMorphTargets{}[{}] = {{\n{}}};\n", i,
                           morph.targets.size(), targets));
      morphs += fmt::format("    {{.mesh = &kBindMeshes[{}], .targets = kMorphTargets{}}},\n", morph.mesh, i);
      indices += fmt::format("{}{}", i == 0 ? "" : ", ", std::ranges::find(moved, morph.mesh) - moved.begin());
      if (offsets <= kMaxChecked) checks += fmt::format("static_assert(zstrip::validate(kMorphs[{}]));\n", i);
    }
    out_.add(
        fmt::format("/// The meshes that morph targets move, and their elements of kMoved.\n"
                    "inline constexpr zstrip::Morph kMorphs[{0}] = {{\n{1}}};\n"
                    "inline constexpr std::uint16_t kMovedByMorph[{0}] = {{{2}}};\n{3}\n",
                    skins_.morphs.size(), morphs, indices, checks));
  }

  const BakedSkins& skins_;
  HeaderText& out_;
};

}  // namespace

const char* pose_function_of(const BakedSkins& skins) { return skins.meshes.empty() ? "pose_morphs" : "pose_skins"; }

void add_moving_meshes(std::size_t count, const BakedSkins& skins, const std::string& meshes, HeaderText& out) {
  MovingMeshes(skins, out).meshes(count, meshes);
}

void add_motion(const BakedSkins& skins, HeaderText& out) {
  MovingMeshes moving(skins, out);
  if (!skins.morphs.empty()) moving.weight_animation();
  if (!skins.meshes.empty()) moving.joint_animation();
}

}  // namespace zstrip::sim
