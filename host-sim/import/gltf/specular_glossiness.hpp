// Materials of KHR_materials_pbrSpecularGlossiness as metal and roughness.
#pragma once

#include <array>

namespace zstrip::sim {

/// Linear channels, 0..1.
struct SpecularGlossiness {
  std::array<double, 3> diffuse{1, 1, 1}, specular{1, 1, 1};
};

struct MetallicBase {
  std::array<double, 3> colour{};  ///< linear, 0..1
  double metallic = 0;             ///< 0..1
};

/// Returns the base colour whose metal looks most like a diffuse and a specular colour: that of metal is all in the
/// specular one.
MetallicBase to_metallic(const SpecularGlossiness& from);

}  // namespace zstrip::sim
