// The one place where floating point becomes the renderer's fixed point.
#pragma once

#include <cstddef>
#include <vector>

#include "import/model.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// What was found out about a source mesh.
struct MeshTraits {
  int texcoord_bits = 12;
  bool double_sided = false;
};

/// Of meshes, and of materials in use: indices have 16 bits, and one value means "none".
inline constexpr std::size_t kMaxMeshes = 65535;
inline constexpr const char* kTooManyMeshes = "needs more than 65,535 meshes or materials; simplify the model";

/// `traits` has one entry for each mesh. Expects finite positions, textures with sides that are powers of two, and
/// texture coordinates that fit. Fails only beyond 65,535 meshes or materials; the message starts with a verb.
Result<Model> quantise(const SourceModel& source, const std::vector<MeshTraits>& traits);

/// Row by row, each channel rounded to nearest.
std::vector<std::uint16_t> to_rgb565(const RgbImage& image);
/// Makes TextureFormat::rgb565_alpha of these texels, if the picture has alpha.
void append_alpha(const RgbImage& image, std::vector<std::uint16_t>& words);

/// A length, coordinate or scale in 16.16, rounded to nearest; the value must fit.
Fixed to_fixed(double value);
/// The exact inverse.
constexpr double from_fixed(Fixed value) { return static_cast<double>(value) / kFixedOne; }

}  // namespace zstrip::sim
