// Highlights of glTF materials: roughness, metal and refraction as a colour and an exponent.
#include "import/gltf/highlights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/screen_channel.hpp"

namespace zstrip::sim {
namespace {

/// The least channel that RGB565 can show.
constexpr std::uint8_t kFaintest = 8;

/// Returns the reflected share of perpendicular light, for materials other than metal.
std::array<double, 3> reflected_straight(const GltfJson& material) {
  const double ior = number_in(extension(material, "KHR_materials_ior"), "ior", 1.5);
  const double amplitude = (ior - 1) / (ior + 1);  // 0 stands for mirrors, which reflect all light
  const GltfJson& specular = extension(material, "KHR_materials_specular");
  const double factor = share(number_in(specular, "specularFactor", 1));
  const auto colour = numbers_in<3>(specular, "specularColorFactor", {1, 1, 1});
  std::array<double, 3> reflected{};
  for (std::size_t i = 0; i < 3; ++i) reflected[i] = factor * share(amplitude * amplitude * colour[i]);
  return reflected;
}

}  // namespace

void set_highlight(const GltfJson& material, const GltfRoughness& texture, SourceMaterial& to) {
  const GltfJson& base = member(material, "pbrMetallicRoughness");
  const double roughness = share(number_in(base, "roughnessFactor", 1)) * texture.roughness;
  const double metallic = share(number_in(base, "metallicFactor", 1)) * texture.metallic;
  const auto colour = numbers_in<4>(base, "baseColorFactor", {1, 1, 1, 1});
  const std::array<double, 3> reflected = reflected_straight(material);
  const double alpha = roughness * roughness;
  const double exponent = std::clamp(2 / (alpha * alpha) - 2, 1.0, 255.0);
  std::array<std::uint8_t, 3> peak{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double metal = share(colour[i]);
    const double straight = (1 - metallic) * reflected[i] + metallic * metal;
    peak[i] = to_screen_channel(straight * (exponent + 2) / 8 - metallic * metal, false);
  }
  if (*std::ranges::max_element(peak) < kFaintest) return;
  to.specular = peak;
  to.shininess = static_cast<std::uint8_t>(std::lround(exponent));
}

}  // namespace zstrip::sim
