// Selects the textures that get a palette, and adds the finish that their materials need.
#include "bake/palettes.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "bake/plain_finish.hpp"
#include "image/mipmaps.hpp"

namespace zstrip::sim {
namespace {

/// The formats that are tried, in this order, and if each may change colours.
struct Candidate {
  TextureFormat format;
  bool lossy;
};

std::vector<Candidate> candidates(TextureChoice choice) {
  switch (choice) {
    case TextureChoice::automatic: return {{TextureFormat::palette4, false}, {TextureFormat::palette8, false}};
    case TextureChoice::palette8: return {{TextureFormat::palette4, false}, {TextureFormat::palette8, true}};
    case TextureChoice::palette4: return {{TextureFormat::palette4, true}};
    case TextureChoice::rgb565: break;
  }
  return {};
}

}  // namespace

PalettedScene::PalettedScene(const Scene& scene, TextureChoice choice)
    : scene_(scene),
      textures_(scene.textures.begin(), scene.textures.end()),
      materials_(scene.materials.begin(), scene.materials.end()),
      finishes_(scene.finishes.begin(), scene.finishes.end()) {
  if (finishes_.size() >= kNoFinish) return;  // no room for one more
  std::set<std::size_t> used;
  for (const Instance& instance : scene.instances) used.insert(materials_[instance.material].texture);
  for (const Quadric& quadric : scene.quadrics) used.erase(materials_[quadric.material].texture);
  for (const std::size_t i : used) {
    if (i >= textures_.size() || textures_[i].format != TextureFormat::rgb565) continue;
    Texture& texture = textures_[i];
    const std::vector<std::size_t> levels = level_sizes(texture);
    const auto texels = texture.texels.first(std::accumulate(levels.begin(), levels.end(), std::size_t{0}));
    for (const auto& [format, lossy] : candidates(choice)) {
      IndexedTexels indexed = index_texels(texels, format, levels);
      const bool loses = indexed.errors.largest != std::array<int, 3>{};
      if ((loses && !lossy) || indexed.words.size() >= texels.size()) continue;
      records_.push_back(
          {i, format, indexed.words.size() * sizeof(std::uint16_t), texels.size_bytes(), indexed.errors});
      words_.push_back(std::move(indexed.words));
      texture.texels = words_.back();
      texture.format = format;
      break;
    }
  }
  if (!records_.empty()) {
    add_plain_finish(materials_, textures_, finishes_,
                     [this](const Material& material) { return has_palette(textures_[material.texture].format); });
  }
  scene_.textures = textures_;
  scene_.materials = materials_;
  scene_.finishes = finishes_;
}

std::uint64_t PalettedScene::saved_bytes() const {
  std::uint64_t before = 0, after = 0;
  for (const PaletteRecord& record : records_) before += record.bytes_before, after += record.bytes;
  return before - after;
}

}  // namespace zstrip::sim
