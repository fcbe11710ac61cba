// Materials of KHR_materials_pbrSpecularGlossiness as metal and roughness.
#include "import/gltf/specular_glossiness.hpp"

#include <algorithm>
#include <cmath>

namespace zstrip::sim {
namespace {

/// The share of light that other materials than metal reflect straight on, in glTF.
constexpr double kStraight = 0.04;

/// Perceived brightness, as KHR_materials_pbrSpecularGlossiness weighs it.
double brightness(const std::array<double, 3>& c) {
  return std::sqrt(0.299 * c[0] * c[0] + 0.587 * c[1] * c[1] + 0.114 * c[2] * c[2]);
}

}  // namespace

/// The root of how much metal there is comes from the formulas of both models of light.
MetallicBase to_metallic(const SpecularGlossiness& from) {
  const double rest = 1 - std::clamp(*std::ranges::max_element(from.specular), 0.0, 1.0);
  const double of_specular = brightness(from.specular);
  MetallicBase to;
  if (of_specular > kStraight) {
    const double b = brightness(from.diffuse) * rest / (1 - kStraight) + of_specular - 2 * kStraight;
    to.metallic =
        std::clamp((std::sqrt(b * b - 4 * kStraight * (kStraight - of_specular)) - b) / (2 * kStraight), 0.0, 1.0);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double plain = from.diffuse[i] * rest / (1 - kStraight) / std::max(1 - to.metallic, 1e-6);
    const double shiny = (from.specular[i] - kStraight * (1 - to.metallic)) / std::max(to.metallic, 1e-6);
    to.colour[i] = std::clamp(plain + (shiny - plain) * to.metallic * to.metallic, 0.0, 1.0);
  }
  return to;
}

}  // namespace zstrip::sim
