// Finds out why pictures show nothing of their scene.
#pragma once

#include <cstdint>
#include <string>

#include "render/stage.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// True if a frame's pixels equal the stage's first frame drawn without the scene.
bool is_background(Stage& stage, const View& view, std::uint32_t crc32);

/// Returns the reason why drawn surfaces are not visible: alpha, with the material's name, or colours.
std::string why_unseen(Stage& stage);

/// True if a part of the stage's first frame lies in the picture and is smaller than a pixel there.
bool is_below_a_pixel(Stage& stage, const View& view);

/// Returns the reason why most of a model is smaller than a pixel though its camera shows all of it; empty if it is
/// not, or without a file.
std::string why_too_small(const Stage& stage, const View& view);

}  // namespace zstrip::sim
