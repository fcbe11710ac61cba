// The skins, clips and morph targets of a model, as a blob holds them.
#include "bake/blob_characters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/text.hpp"
#include "zstrip/geometry/meshlet_range.hpp"

namespace zstrip::sim {

BlobCharacters::BlobCharacters(const Scene& scene, const BakedSkins& skins, std::span<const ModelClip> clips)
    : meshes_(scene.meshes.begin(), scene.meshes.end()),
      scene_(scene),
      skins_(skins.meshes.size()),
      skinnings_(skins.meshes.size()),
      matrices_(skins.meshes.size() * skins.joints.size()),
      pose_(skins.meshes.empty() ? 0 : skins.joints.size()),
      bases_(skins.morphs.size()),
      morphs_(skins.morphs.size()),
      morphed_(skins.morphs.size()),
      weights_(skins.morphs.empty() ? 0 : skins.weights) {
  std::vector<const ModelSkin*> ordered;
  for (const ModelSkin& skin : skins.meshes) ordered.push_back(&skin);
  std::ranges::sort(ordered, {}, &ModelSkin::mesh);
  std::size_t positions = 0, normals = 0;
  for (const ModelSkin* skin : ordered) {
    for (std::uint32_t i = 0; i < detail::meshlet_count(skin->bind); ++i) {
      const std::size_t vertices = detail::meshlet_range(skin->bind, i).vertex_count;
      positions = std::max(positions, vertices);
      if (!skin->bind.normals.empty()) normals = std::max(normals, vertices);
    }
  }
  positions_.resize(positions);
  normals_.resize(normals);
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    Mesh& mesh = meshes_[ordered[i]->mesh];
    mesh = ordered[i]->bind;
    skins_[i] = {.mesh = &mesh, .vertices = ordered[i]->vertices, .joints = skins.joints, .rest = skins.rest};
    skinnings_[i].skin = &skins_[i];
    skinnings_[i].matrices = std::span(matrices_).subspan(i * skins.joints.size(), skins.joints.size());
    skinnings_[i].positions = positions_;
    if (!mesh.normals.empty()) skinnings_[i].normals = normals_;
    mesh.skinning = &skinnings_[i];
  }
  std::vector<const ModelMorph*> ordered_morphs;
  for (const ModelMorph& morph : skins.morphs) ordered_morphs.push_back(&morph);
  std::ranges::sort(ordered_morphs, {}, &ModelMorph::mesh);
  for (std::size_t i = 0; i < morphs_.size(); ++i) {
    const std::size_t index = ordered_morphs[i]->mesh;
    MeshData& data = morphed_[i];
    bases_[i] = *skins.unmoved(index);
    data.positions.assign(bases_[i].positions.begin(), bases_[i].positions.end());
    data.normals.assign(bases_[i].normals.begin(), bases_[i].normals.end());
    data.meshlets.assign(bases_[i].meshlets.begin(), bases_[i].meshlets.end());
    morphs_[i] = {.morph = {&bases_[i], ordered_morphs[i]->targets},
                  .vertices = {data.positions, data.normals, data.meshlets},
                  .mesh = static_cast<std::uint16_t>(index)};
    Skinning* const skinning = meshes_[index].skinning;
    meshes_[index] = moved_mesh(bases_[i], morphs_[i].vertices);
    meshes_[index].skinning = skinning;
  }
  scene_.meshes = meshes_;
  for (const ModelClip& clip : clips) {
    clips_.push_back({.name = clip.name.c_str(),
                      .instances = clip.instances.view(),
                      .joints = clip.joints.view(),
                      .weights = clip.weights.view()});
  }
}

Result<Done> BlobCharacters::pose_all() {
  constexpr std::uint32_t kPoses = 24;
  PlayedClip played{};
  for (std::size_t i = clips_.size(); i-- > 0;) {
    played.clip = static_cast<std::uint16_t>(i);
    for (std::uint32_t n = kPoses; n-- > 0;) {
      played.time = time_of_frame(clips_[i].instances, n, kPoses);
      const bool posed{pose_clips(clips_, {&played, 1}, MovedSkins{skinnings_, pose_})};
      if (posed && pose_clips(clips_, {&played, 1}, MovedMorphs{morphs_, weights_})) continue;
      return Failure{ExitStatus::input, fmt::format("the animation '{}' {}; bake one of the others with --animation",
                                                    printable(clips_[i].name),
                                                    posed ? "has weights of morph targets that are too large together"
                                                          : "moves a joint too far away")};
    }
  }
  return Done{};
}

std::uint64_t BlobCharacters::table_bytes() const {
  // With addresses of 32 bits; core/zstrip/scene/scene_blob.cpp asserts these values on such targets.
  constexpr std::uint64_t kSkinBytes = 28, kSkinningBytes = 112, kClipBytes = 64, kMorphBytes = 40, kMeshBytes = 80,
                          kTargetBytes = 28;
  std::uint64_t targets = 0;
  for (const MovedMorph& mesh : morphs_) targets += mesh.morph.targets.size();
  return skins_.size() * (kSkinBytes + kSkinningBytes) + clips_.size() * kClipBytes +
         morphs_.size() * (kMorphBytes + kMeshBytes) + targets * kTargetBytes;
}

std::uint64_t BlobCharacters::keyframe_bytes() const {
  std::uint64_t bytes = 0;
  for (const Clip& clip : clips_) {
    for (const Animation& animation : {clip.instances, clip.joints}) {
      bytes += animation.keyframes.size_bytes() + animation.tracks.size_bytes();
    }
    bytes += clip.weights.keys.size_bytes() + clip.weights.tracks.size_bytes();
  }
  return bytes;
}

}  // namespace zstrip::sim
