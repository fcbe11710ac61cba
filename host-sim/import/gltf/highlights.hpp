// Highlights of glTF materials: roughness, metal and refraction as a colour and an exponent.
#pragma once

#include "import/gltf/json.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// What the factors of a material are multiplied with: the means of its texture of both.
struct GltfRoughness {
  double roughness = 1, metallic = 1;
};

/// Sets the highlight of a lit material; none where it would be fainter than RGB565 shows. Its peak, of full light, is
/// that of a normalised Blinn-Phong lobe, less the diffuse light that is drawn although metal has none.
void set_highlight(const GltfJson& material, const GltfRoughness& texture, SourceMaterial& to);

}  // namespace zstrip::sim
