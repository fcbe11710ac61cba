// Smooth metals mirror a studio: the renderer has no metal, but environment maps.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// The least share of metal, and the greatest roughness, of a material that mirrors. Rougher metal looks like its
/// colour under diffuse light, which is how it is drawn otherwise.
inline constexpr double kMinMetal = 0.5, kMaxMirrorRoughness = 0.7;

/// Sides of an environment map, in texels.
inline constexpr std::uint32_t kStudioSide = 64;

/// Returns a picture of a mirrored ball of a metal in a grey studio: a bright floor, darker walls, four lamps. It is
/// blurred by a cosine lobe with this exponent, a power of two from 2 to 128. `colour`: the metal's, as on the screen.
RgbImage studio_map(unsigned exponent, const std::array<std::uint8_t, 3>& colour);

/// Gives smooth metals without a texture, without emission and without alpha an environment map in place of light and
/// highlights. Metals of one colour and nearly the same roughness share a map. On meshes with vertex colours the map is
/// grey and the colours are multiplied with it; in files with lights it is grey and the lit colours are.
void show_metals(SourceModel& model);

}  // namespace zstrip::sim
