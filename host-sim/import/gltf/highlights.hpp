// Highlights of glTF materials: roughness, metal and refraction as a colour and an exponent.
#pragma once

#include "import/gltf/json.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// The means of a material's texture, by which its two factors are multiplied.
struct GltfRoughness {
  double roughness = 1, metallic = 1;
};

/// Sets the highlight of a lit material; none if RGB565 could not show it. Its peak, in full light, is that of a
/// normalised Blinn-Phong lobe, minus the diffuse light that is drawn although metal has none.
void set_highlight(const GltfJson& material, const GltfRoughness& texture, SourceMaterial& to);

}  // namespace zstrip::sim
