// Surfaces that can be seen from both sides.
#include "import/sides.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace zstrip::sim {
namespace {

/// False for materials that only emit: they have the same colour from all sides.
bool is_shaded(const SourceMaterial& material) {
  return material.lit && material.colour != std::array<std::uint8_t, 3>{};
}

/// Reverses normals and the offsets that morph targets add to them. `turned`: the reversed entries of
/// SourceModel::morphs so far.
SourceMesh back_of(const SourceMesh& front, SourceModel& model, std::map<std::uint32_t, std::uint32_t>& turned) {
  SourceMesh back = front;
  const auto reverse = [](std::array<float, 3>& v) {
    for (float& component : v) component = 0.0F - component;
  };
  for (SourceVertex& vertex : back.vertices) {
    reverse(vertex.normal);
    if (vertex.morph == 0) continue;
    const auto [at, is_new] = turned.try_emplace(vertex.morph, static_cast<std::uint32_t>(model.morphs.size() + 1));
    if (is_new) {
      std::vector<SourceMorphOffset> offsets = model.morphs[vertex.morph - 1];
      for (SourceMorphOffset& offset : offsets) reverse(offset.normal);
      model.morphs.push_back(std::move(offsets));
    }
    vertex.morph = at->second;
  }
  for (std::size_t i = 0; i + 2 < back.indices.size(); i += 3) std::swap(back.indices[i + 1], back.indices[i + 2]);
  return back;
}

}  // namespace

void split_sides(SourceModel& model, std::vector<Outside>& outsides) {
  std::map<std::uint32_t, std::uint32_t> single_sided;  // by material
  std::map<std::uint32_t, std::uint32_t> turned;
  std::vector<SourceMesh> meshes;
  std::vector<Outside> seen;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    SourceMesh& mesh = model.meshes[i];
    const SourceMaterial& material = model.materials[mesh.material];
    const bool shows_both = material.double_sided.value_or(outsides[i].opening >= kMinOpening);
    const bool hidden = outsides[i].is_closed && material.alpha_mode == AlphaMode::opaque;
    if (shows_both && !hidden && is_shaded(material)) {
      const auto [at, is_new] =
          single_sided.try_emplace(mesh.material, static_cast<std::uint32_t>(model.materials.size()));
      if (is_new) {
        SourceMaterial one = material;
        one.double_sided = false;
        model.materials.push_back(std::move(one));
      }
      mesh.material = at->second;
      // For blended surfaces the back is first, because it is behind.
      meshes.push_back(back_of(mesh, model, turned));
      seen.push_back({});
    }
    meshes.push_back(std::move(mesh));
    seen.push_back(outsides[i]);
  }
  model.meshes = std::move(meshes);
  outsides = std::move(seen);
}

}  // namespace zstrip::sim
