// The only place where floating point becomes the renderer's fixed point.
#pragma once

#include <cstddef>
#include <vector>

#include "import/model.hpp"
#include "import/source_model.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {

/// The properties of a source mesh that the steps before have found.
struct MeshTraits {
  int texcoord_bits = 12;
  bool double_sided = false;
};

/// Limit for meshes, and for used materials: indices have 16 bits, and one value means "none".
inline constexpr std::size_t kMaxMeshes = 65535;
inline constexpr const char* kTooManyMeshes = "needs more than 65,535 meshes or materials; simplify the model";

/// `traits` has one entry for each mesh. Expects finite positions, textures with sides that are powers of two, and
/// texture coordinates that fit. Fails only above 65,535 meshes or materials; the message starts with a verb.
Result<Model> quantise(const SourceModel& source, const std::vector<MeshTraits>& traits);

/// Converts row by row, each channel rounded to nearest.
std::vector<std::uint16_t> to_rgb565(const RgbImage& image);
/// Converts these texels to TextureFormat::rgb565_alpha if the picture has alpha.
void append_alpha(const RgbImage& image, std::vector<std::uint16_t>& words);

/// Converts a length, coordinate or scale to 16.16, rounded to nearest; the value must fit.
Fixed to_fixed(double value);
/// Converts back, exactly.
constexpr double from_fixed(Fixed value) { return static_cast<double>(value) / kFixedOne; }
Affine to_affine(const Transform& map);

}  // namespace zstrip::sim
