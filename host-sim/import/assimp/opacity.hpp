// Reads the alpha of materials that Assimp has read: factors, and maps that become the alpha of a texture.
#pragma once

#include <assimp/material.h>
#include <assimp/scene.h>

#include "image/rgb_image.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Returns the alpha of a material's colour, 0 to 1; 1 if the file has none.
double alpha_of(const aiMaterial& material);

/// Returns how a picture's alpha is drawn: as a mask if it has only 0 and 255. A picture without alpha is opaque.
AlphaMode alpha_mode_of(const RgbImage& image);

/// Returns a picture whose alpha is that of `map`, or its luminance if it has no alpha. The colours are white.
RgbImage white_with_alpha_of(const RgbImage& map, bool inverted);

/// Replaces a picture's alpha by that of `map`, resampled to the picture's size.
void set_alpha(const RgbImage& map, RgbImage& image);

/// Replaces alpha by 1 - alpha, with a warning, if some of the materials that meshes use have an alpha of 0 and none
/// has 1: some exporters write transparency in place of alpha. A file that would show nothing becomes opaque.
void correct_reversed_alpha(const aiScene& scene, SourceModel& model);

}  // namespace zstrip::sim
