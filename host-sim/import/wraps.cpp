// Textures that do not repeat.
#include "import/wraps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "image/resample.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// The last coordinate of the texture; 1 itself is the first texel again. Fits in 15 bits.
constexpr float kLastPlace = 1 - 1.0F / 16384;

/// The range of a coordinate of a mesh.
struct Range {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
};

Range range_of(const std::vector<SourceMesh*>& meshes, std::size_t axis) {
  Range range;
  for (const SourceMesh* mesh : meshes) {
    for (const std::uint32_t index : mesh->indices) {
      const float value = mesh->vertices[index].texcoord[axis];
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  return range;
}

template <class Change>
void change_coordinates(const std::vector<SourceMesh*>& meshes, std::size_t axis, const Change& change) {
  for (SourceMesh* mesh : meshes) {
    for (SourceVertex& vertex : mesh->vertices) vertex.texcoord[axis] = change(vertex.texcoord[axis]) + 0.0F;
  }
}

/// Reduces the picture to the size in which it will be drawn.
RgbImage reduced(RgbImage image) {
  while (image.width > kMaxTextureSide || image.height > kMaxTextureSide) {
    image = halve(image, image.width > kMaxTextureSide, image.height > kMaxTextureSide);
  }
  return image;
}

/// Returns the picture with its mirror image next to or below it.
RgbImage doubled(const RgbImage& from, std::size_t axis) {
  RgbImage to{axis == 0 ? 2 * from.width : from.width, axis == 0 ? from.height : 2 * from.height, {}};
  const auto mirrored = [](std::uint32_t at, std::uint32_t side) { return at < side ? at : 2 * side - 1 - at; };
  to.rgb.reserve(2 * from.rgb.size());
  for (std::uint32_t y = 0; y < to.height; ++y) {
    for (std::uint32_t x = 0; x < to.width; ++x) {
      const std::uint32_t u = mirrored(x, from.width), v = mirrored(y, from.height);
      const std::uint8_t* const pixel = from.pixel(u, v);
      to.rgb.insert(to.rgb.end(), pixel, pixel + 3);
      if (!from.alpha.empty()) to.alpha.push_back(from.alpha_at(u, v));
    }
  }
  return to;
}

/// Returns a picture that begins at the tile `first` and is so many tiles wide, with the border's texels outside of the
/// original picture.
RgbImage padded(const RgbImage& from, std::size_t axis, int first, int tiles) {
  RgbImage to{from.width, from.height, {}};
  std::uint32_t& side = axis == 0 ? to.width : to.height;
  const auto length = static_cast<std::int64_t>(side);
  side *= static_cast<std::uint32_t>(tiles);
  const auto inside = [&](std::uint32_t at) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(at + first * length, 0, length - 1));
  };
  for (std::uint32_t y = 0; y < to.height; ++y) {
    for (std::uint32_t x = 0; x < to.width; ++x) {
      const std::uint32_t u = axis == 0 ? inside(x) : x, v = axis == 0 ? y : inside(y);
      const std::uint8_t* const pixel = from.pixel(u, v);
      to.rgb.insert(to.rgb.end(), pixel, pixel + 3);
      if (!from.alpha.empty()) to.alpha.push_back(from.alpha_at(u, v));
    }
  }
  return to;
}

/// True if each triangle lies inside the texture, or completely beyond one border.
bool is_clamped_by_vertices(const std::vector<SourceMesh*>& meshes, std::size_t axis, float tolerance) {
  for (const SourceMesh* mesh : meshes) {
    for (std::size_t i = 0; i + 2 < mesh->indices.size(); i += 3) {
      const auto at = [&](std::size_t k) { return mesh->vertices[mesh->indices[i + k]].texcoord[axis]; };
      const auto [low, high] = std::minmax({at(0), at(1), at(2)});
      if (!(low >= -tolerance && high <= 1 + tolerance) && low < 1 && high > 0) return false;
    }
  }
  return true;
}

class Wraps {
 public:
  explicit Wraps(SourceModel& model) : model_(model) {}

  void show(SourceMaterial& material, const std::vector<SourceMesh*>& meshes) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (material.wrap[axis] == TextureWrap::clamp) clamp(material, meshes, axis);
      if (material.wrap[axis] == TextureWrap::mirror) mirror(material, meshes, axis);
      material.wrap[axis] = TextureWrap::repeat;
    }
  }

 private:
  static float to_last_place(float value) { return std::clamp(value, 0.0F, kLastPlace); }

  void clamp(SourceMaterial& material, const std::vector<SourceMesh*>& meshes, std::size_t axis) {
    const RgbImage& image = model_.textures[material.texture];
    const std::uint32_t side = axis == 0 ? image.width : image.height;
    if (is_clamped_by_vertices(meshes, axis, 0.5F / static_cast<float>(side))) {
      change_coordinates(meshes, axis, to_last_place);
      return;
    }
    const Range range = range_of(meshes, axis);
    constexpr float kMaxTiles = 4;
    constexpr std::uint32_t kMaxPaddedSide = 1024;
    const float first = std::floor(range.low), tiles = std::ceil(range.high) - first;
    if (!(tiles <= kMaxTiles) || side * 4 > kMaxPaddedSide || std::abs(first) > kMaxTiles) {
      if (!warned_.insert(material.texture).second) return;
      model_.warnings.push_back(fmt::format("texture '{}' repeated: clamping it so far beyond its border is not drawn",
                                            printable(model_.texture_names[material.texture])));
      return;
    }
    const int count = tiles <= 2 ? 2 : 4;
    material.texture = own_texture({material.texture, axis, static_cast<int>(first), count}, [&](const RgbImage& from) {
      return padded(from, axis, static_cast<int>(first), count);
    });
    change_coordinates(meshes, axis,
                       [&](float value) { return to_last_place((value - first) / static_cast<float>(count)); });
  }

  void mirror(SourceMaterial& material, const std::vector<SourceMesh*>& meshes, std::size_t axis) {
    const Range range = range_of(meshes, axis);
    const float tile = std::floor(range.low);
    if (range.high <= tile + 1) {
      const bool odd = std::fmod(tile, 2.0F) != 0;
      change_coordinates(meshes, axis,
                         [&](float value) { return to_last_place(odd ? tile + 1 - value : value - tile); });
      return;
    }
    material.texture =
        own_texture({material.texture, axis, 0, 0}, [&](const RgbImage& from) { return doubled(reduced(from), axis); });
    change_coordinates(meshes, axis, [](float value) { return value / 2; });
  }

  /// A texture, the axis along which it is changed, and the change: the first tile and the number of tiles; 0: doubled.
  using Key = std::tuple<std::uint32_t, std::size_t, int, int>;

  template <class Make>
  std::uint32_t own_texture(const Key& key, const Make& make) {
    const auto [at, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(model_.textures.size()));
    if (!is_new) return at->second;
    RgbImage image = make(model_.textures[std::get<0>(key)]);
    model_.textures.push_back(std::move(image));
    model_.texture_names.push_back(model_.texture_names[std::get<0>(key)]);
    return at->second;
  }

  SourceModel& model_;
  std::set<std::uint32_t> warned_;
  std::map<Key, std::uint32_t> known_;
};

}  // namespace

void show_wraps(SourceModel& model) {
  std::map<std::uint32_t, std::vector<SourceMesh*>> users;
  for (SourceMesh& mesh : model.meshes) {
    const SourceMaterial& material = model.materials[mesh.material];
    if (material.texture != kNoSourceTexture && mesh.has_texcoords) users[mesh.material].push_back(&mesh);
  }
  Wraps wraps(model);
  for (const auto& [material, meshes] : users) wraps.show(model.materials[material], meshes);
}

}  // namespace zstrip::sim
