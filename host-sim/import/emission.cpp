// Materials with a separate texture for emission.
#include "import/emission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "image/resample.hpp"
#include "import/surface.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array<std::uint8_t, 3> kNoLight{}, kAllLight{255, 255, 255};

/// Returns the base colour, times `base` if there is one, plus the emission's texels times its colour.
RgbImage sum_of(const SourceMaterial& material, const RgbImage* base, const RgbImage& emission) {
  const auto side = [](std::uint32_t a, std::uint32_t b) { return std::min(std::max(a, b), kMaxTextureSide); };
  RgbImage sum{side(emission.width, base == nullptr ? 1 : base->width),
               side(emission.height, base == nullptr ? 1 : base->height),
               {}};
  sum.rgb.reserve(std::size_t{3} * sum.width * sum.height);
  const auto pixel_of = [&sum](const RgbImage& image, std::uint32_t x, std::uint32_t y) {
    const auto at = [](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
      return static_cast<std::uint32_t>(std::uint64_t{i} * to / from);
    };
    return std::pair{at(x, sum.width, image.width), at(y, sum.height, image.height)};
  };
  for (std::uint32_t y = 0; y < sum.height; ++y) {
    for (std::uint32_t x = 0; x < sum.width; ++x) {
      const auto [u, v] = pixel_of(emission, x, y);
      const auto [s, t] = base == nullptr ? std::pair{0U, 0U} : pixel_of(*base, x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        const int lit = base == nullptr ? 255 : int{base->pixel(s, t)[c]};
        const int value = lit * material.colour[c] + emission.pixel(u, v)[c] * material.emissive[c];
        sum.rgb.push_back(static_cast<std::uint8_t>(std::min((value + 127) / 255, 255)));
      }
      if (base != nullptr && !base->alpha.empty()) sum.alpha.push_back(base->alpha_at(s, t));
    }
  }
  return sum;
}

/// Returns the sum of a picture's channels at texture coordinates, as a share of white.
double brightness_at(const RgbImage& image, const std::array<TextureWrap, 2>& wrap,
                     const std::array<std::uint8_t, 3>& colour, const std::array<double, 2>& texcoord) {
  const auto texel = [&](std::size_t axis, std::uint32_t side) {
    const double at = wrap[axis] == TextureWrap::clamp ? std::clamp(texcoord[axis], 0.0, 0.999999)
                                                       : texcoord[axis] - std::floor(texcoord[axis]);
    return std::min(static_cast<std::uint32_t>(at * side), side - 1);
  };
  const std::uint8_t* const pixel = image.pixel(texel(0, image.width), texel(1, image.height));
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += pixel[c] * colour[c];
  return sum / (3.0 * 255 * 255);
}

/// The light of a triangle: reflected by its base colour, and its own.
struct Glow {
  double base = 0, emission = 0;
};

/// Returns the means of four places of a triangle. `base`: null for the colour alone.
Glow glow_of(const SourceMesh& mesh, std::size_t first, const SourceMaterial& material, const RgbImage* base,
             const RgbImage& emission) {
  constexpr std::array<std::array<double, 3>, 4> kPlaces{
      {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}}};
  static const RgbImage white{1, 1, {255, 255, 255}};
  Glow glow;
  for (const auto& place : kPlaces) {
    std::array<double, 2> at{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto& texcoord = mesh.vertices[mesh.indices[first + corner]].texcoord;
      for (std::size_t axis = 0; axis < 2; ++axis) at[axis] += place[corner] * double{texcoord[axis]};
    }
    if (!std::isfinite(at[0]) || !std::isfinite(at[1])) return {};
    glow.base += brightness_at(base == nullptr ? white : *base, material.wrap, material.colour, at) / kPlaces.size();
    glow.emission += brightness_at(emission, material.wrap, material.emissive, at) / kPlaces.size();
  }
  return glow;
}

/// Gives triangles that glow more than they reflect an unlit material. Returns true if others glow visibly.
bool part_glowing(SourceModel& model, std::uint32_t index, const SourceMaterial& before, const RgbImage& emission) {
  constexpr double kSeen = 0.1;
  const RgbImage* const base = before.texture == kNoSourceTexture ? nullptr : &model.textures[before.texture];
  bool others = false;
  std::vector<SourceMesh> parts;
  for (SourceMesh& mesh : model.meshes) {
    if (mesh.material != index || !mesh.has_texcoords) continue;
    std::vector<std::uint32_t> lit, glowing;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const Glow glow = glow_of(mesh, i, before, base, emission);
      const bool glows = glow.emission > std::max(glow.base, kSeen);
      others = others || (!glows && glow.emission > kSeen);
      std::vector<std::uint32_t>& to = glows ? glowing : lit;
      to.insert(to.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(i),
                mesh.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
    }
    if (glowing.empty()) continue;
    SourceMesh part = mesh;
    part.material = static_cast<std::uint32_t>(model.materials.size());
    part.indices = std::move(glowing);
    weld(part);
    mesh.indices = std::move(lit);
    if (!mesh.indices.empty()) weld(mesh);
    parts.push_back(std::move(part));
  }
  if (parts.empty()) return others;
  SourceMaterial unlit = model.materials[index];
  unlit.lit = false;
  model.materials.push_back(std::move(unlit));
  std::erase_if(model.meshes, [](const SourceMesh& mesh) { return mesh.indices.empty(); });
  model.meshes.insert(model.meshes.end(), parts.begin(), parts.end());
  return others;
}

/// Gives meshes without texture coordinates, which show no texel, a material with the colour from before.
void keep_colour_without_texcoords(SourceModel& model, std::uint32_t index, const SourceMaterial& before) {
  const auto count = static_cast<std::uint32_t>(model.materials.size());
  for (SourceMesh& mesh : model.meshes) {
    if (mesh.material == index && !mesh.has_texcoords) mesh.material = count;
  }
  if (std::ranges::none_of(model.meshes, [&](const SourceMesh& mesh) { return mesh.material == count; })) return;
  SourceMaterial plain = model.materials[index];
  plain.colour = before.colour;
  model.materials.push_back(std::move(plain));
}

}  // namespace

void show_emission(SourceModel& model) {
  for (std::uint32_t i = 0; i < model.materials.size(); ++i) {
    SourceMaterial& material = model.materials[i];
    const std::uint32_t emission = std::exchange(material.emissive_texture, kNoSourceTexture);
    if (emission == kNoSourceTexture || emission == material.texture || !material.lit) continue;
    const bool textured = material.texture != kNoSourceTexture;
    if (material.colour == kNoLight && !textured) {
      material.texture = emission;
      continue;
    }
    const SourceMaterial before = material;
    RgbImage sum = sum_of(material, textured ? &model.textures[material.texture] : nullptr, model.textures[emission]);
    material.texture = static_cast<std::uint32_t>(model.textures.size());
    model.textures.push_back(std::move(sum));
    model.texture_names.push_back(model.texture_names[emission]);
    material.colour = kAllLight;
    material.emissive = kNoLight;
    keep_colour_without_texcoords(model, i, before);
    if (!part_glowing(model, i, before, model.textures[emission])) continue;
    model.warnings.push_back(
        fmt::format("material '{}' drawn with its emission lit like the rest of it: it has a texture of its own",
                    printable(before.name)));
  }
}

}  // namespace zstrip::sim
