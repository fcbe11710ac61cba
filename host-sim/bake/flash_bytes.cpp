// Computes the flash of a scene, by kind of data, and the RAM of its skins and morph targets.
#include "bake/flash_bytes.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "zstrip/overlay.hpp"
#include "zstrip/scene/parts.hpp"

namespace zstrip::sim {
namespace {

// With addresses of 32 bits; core/zstrip/scene/scene_blob.cpp asserts these values on such targets.
constexpr std::uint64_t kCameraBytes = 64, kMeshBytes = 80;
constexpr std::uint64_t kOverlayBytes = 32, kImageBytes = 24, kFontBytes = 28, kLabelBytes = 24;
/// The bytes of records with addresses.
constexpr std::uint64_t bytes_with_addresses(const Mesh&) { return kMeshBytes; }
constexpr std::uint64_t bytes_with_addresses(const Texture&) { return 12; }
constexpr std::uint64_t bytes_with_addresses(const LineSet&) { return 64; }
constexpr std::uint64_t bytes_with_addresses(const EdgeSet&) { return 12; }
std::uint64_t bytes_with_addresses(const Overlay& overlay) {
  return kOverlayBytes + overlay.images.size() * kImageBytes + overlay.fonts.size() * kFontBytes +
         overlay.labels.size() * kLabelBytes;
}
template <class Record>
concept HasAddresses = requires(const Record& record) {
  bytes_with_addresses(record);
};

/// Sums up the bytes of the scene's records, without their tables.
class RecordBytes {
 public:
  template <class Record>
  void add(std::span<const Record> records) {
    for (const Record& record : records) add(&record);
  }
  template <class Record>
  void add(const Record* record) {
    if (record == nullptr) return;
    if constexpr (HasAddresses<Record>) {
      with_addresses += bytes_with_addresses(*record);
    } else {
      others += sizeof(Record);
    }
  }
  void add(const Colour&) {}  // the scene itself holds it

  std::uint64_t with_addresses = 0, others = 0;
};

RecordBytes record_bytes(const Scene& scene) {
  RecordBytes bytes;
  detail::for_each_part(scene, [&bytes](const char*, const auto& part) { bytes.add(part); });
  return bytes;
}

}  // namespace

std::uint64_t table_bytes(const Scene& scene) { return record_bytes(scene).with_addresses; }

FlashBytes flash_bytes(const Scene& scene, const Animation& animation, const BspTree& tree, const BakedSkins& skins,
                       std::span<const DetailLevel> levels) {
  FlashBytes bytes;
  std::set<std::pair<const void*, std::size_t>> seen;  // meshes may share arrays
  const auto add = [&seen](std::uint64_t& sum, const auto& records) {
    if (seen.insert({records.data(), records.size()}).second) sum += records.size_bytes();
  };
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh* const unmoved = skins.unmoved(i);
    const Mesh& mesh = unmoved == nullptr ? scene.meshes[i] : *unmoved;
    add(bytes.positions, mesh.positions);
    add(bytes.normals, mesh.normals);
    add(bytes.colours, mesh.colours);
    add(bytes.texcoords, mesh.texcoords);
    add(bytes.triangles, mesh.triangles);
    add(bytes.meshlets, mesh.meshlets);
  }
  for (const Texture& texture : scene.textures) add(bytes.texels, texture.texels);
  for (const LineSet& lines : scene.lines) bytes.tables += lines.segments.size_bytes();
  for (const EdgeSet& set : scene.edges) bytes.edges += set.edges.size_bytes();
  if (scene.overlay != nullptr) {
    const Overlay& over = *scene.overlay;
    for (const OverlayImage& image : over.images) {
      add(bytes.texels, image.colours);
      add(bytes.texels, image.coverage);
    }
    for (const Font& font : over.fonts) {
      add(bytes.texels, font.coverage);
      add(bytes.tables, font.glyphs);
    }
    for (const Label& label : over.labels) add(bytes.tables, label.text);
    bytes.tables += over.sprites.size_bytes();
  }
  bytes.tree = tree.nodes.size_bytes();
  bytes.joints = skins.joints.size_bytes() + skins.rest.size_bytes();
  for (const ModelSkin& skin : skins.meshes) add(bytes.joints, skin.vertices);
  bytes.keyframes = animation.keyframes.size_bytes() + animation.tracks.size_bytes() +
                    skins.animation.keyframes.size_bytes() + skins.animation.tracks.size_bytes();
  bytes.keyframes += skins.weight_animation.keys.size_bytes() + skins.weight_animation.tracks.size_bytes();
  for (const ModelMorph& morph : skins.morphs) {
    for (const MorphTarget& target : morph.targets) {
      bytes.morphs += target.runs.size_bytes() + target.positions.size_bytes() + target.normals.size_bytes();
    }
  }
  if (skins.move()) {
    constexpr std::uint64_t kSkinBytes = 28, kMovedBytes = 24, kMorphBytes = 12 + 2, kTargetBytes = 28;
    bytes.tables +=
        scene.meshes.size() * kMeshBytes + skins.meshes.size() * kSkinBytes + skins.morphs.size() * kMorphBytes;
    for (const ModelMorph& morph : skins.morphs) bytes.tables += morph.targets.size() * kTargetBytes;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      if (skins.unmoved(i) != nullptr) bytes.tables += kMovedBytes;
      if (skins.find(i) != nullptr && skins.find_morph(i) != nullptr) bytes.tables += kMeshBytes;
    }
  }
  const RecordBytes records = record_bytes(scene);
  bytes.tables += levels.size_bytes() + records.with_addresses + records.others + detail::scene_bytes(4) + kCameraBytes;
  return bytes;
}

SkinRam skin_ram(const BakedSkins& skins) {
  SkinRam ram{.joints = skins.joints.size() * (sizeof(JointPose) + sizeof(Transform))};
  const auto add = [&ram](const Mesh& mesh) {
    ram.vertices += mesh.positions.size_bytes() + mesh.normals.size_bytes() + mesh.meshlets.size_bytes();
  };
  for (const ModelSkin& skin : skins.meshes) add(skin.bind);
  for (const ModelMorph& morph : skins.morphs) {
    if (skins.find(morph.mesh) == nullptr) add(morph.base);
  }
  if (!skins.morphs.empty()) ram.weights = skins.weights * sizeof(MorphWeight);
  return ram;
}

SkinRam skin_ram(std::span<const Skinning> skinnings, std::size_t joints, std::span<const MovedMorph> morphs,
                 std::size_t weights) {
  SkinRam ram{.joints = joints * sizeof(JointPose), .weights = weights * sizeof(MorphWeight)};
  std::uint64_t positions = 0, normals = 0;  // of a meshlet, which all skins share
  for (const Skinning& skinning : skinnings) {
    positions = std::max<std::uint64_t>(positions, skinning.positions.size_bytes());
    normals = std::max<std::uint64_t>(normals, skinning.normals.size_bytes());
    ram.joints += skinning.matrices.size_bytes();
  }
  ram.vertices = positions + normals;
  for (const MovedMorph& morph : morphs) {
    const MovedVertices& vertices = morph.vertices;
    ram.vertices += vertices.positions.size_bytes() + vertices.normals.size_bytes() + vertices.meshlets.size_bytes();
  }
  return ram;
}

}  // namespace zstrip::sim
