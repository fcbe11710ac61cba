// Selects the textures that get smaller levels, and adds the finish that their materials need.
#include "bake/mipmaps.hpp"

#include <bit>
#include <set>

#include "bake/plain_finish.hpp"
#include "image/mipmaps.hpp"

namespace zstrip::sim {
namespace {

std::uint64_t words_of(const Texture& texture) {
  std::uint64_t words = 0;
  for (const std::size_t texels : level_sizes(texture)) {
    words += level_words(texture.format, static_cast<std::uint32_t>(std::bit_width(texels) - 1));
  }
  return words;
}

}  // namespace

MipmappedScene::MipmappedScene(const Scene& scene, MipmapChoice choice)
    : scene_(scene),
      textures_(scene.textures.begin(), scene.textures.end()),
      materials_(scene.materials.begin(), scene.materials.end()),
      finishes_(scene.finishes.begin(), scene.finishes.end()) {
  if (choice == MipmapChoice::on && finishes_.size() < kNoFinish) add_levels();
  if (choice == MipmapChoice::off) {
    for (Texture& texture : textures_) {
      if (texture.smaller_levels != 0) texture = without_smaller_levels(texture);
    }
  }
  scene_.textures = textures_;
  scene_.materials = materials_;
  scene_.finishes = finishes_;
}

void MipmappedScene::add_levels() {
  std::set<const Material*> drawn;  // quadrics have no finish and no levels
  for (const Instance& instance : scene_.instances) drawn.insert(&materials_[instance.material]);
  for (const Quadric& quadric : scene_.quadrics) drawn.erase(&materials_[quadric.material]);
  std::set<std::size_t> used;
  for (const Material* material : drawn) used.insert(material->texture);
  for (const std::size_t i : used) {
    if (i >= textures_.size()) continue;
    Texture& texture = textures_[i];
    const std::uint8_t levels = most_smaller_levels(texture);
    texture.texels = words_.emplace_back(with_smaller_levels(texture, levels));
    texture.smaller_levels = levels;
  }
  add_plain_finish(materials_, textures_, finishes_, [&](const Material& material) {
    return drawn.contains(&material) && textures_[material.texture].smaller_levels != 0;
  });
}

std::vector<MipmapRecord> mipmap_records(const Scene& scene) {
  std::set<std::size_t> used;
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[instance.material];
    if (material.finish != kNoFinish) used.insert(material.texture);
  }
  std::vector<MipmapRecord> records;
  for (const std::size_t i : used) {
    if (i >= scene.textures.size() || scene.textures[i].smaller_levels == 0) continue;
    const Texture& texture = scene.textures[i];
    const std::uint64_t words = words_of(texture) - words_of(without_smaller_levels(texture));
    records.push_back({i, texture.smaller_levels, words * sizeof(std::uint16_t)});
  }
  return records;
}

}  // namespace zstrip::sim
