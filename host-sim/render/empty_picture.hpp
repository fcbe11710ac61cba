// Why pictures show nothing of their scene.
#pragma once

#include <cstdint>
#include <string>

#include "render/stage.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Whether a frame's pixels are those of the stage's first frame without anything of the scene in it.
bool is_background(Stage& stage, const View& view, std::uint32_t crc32);

/// Why what was drawn is not seen: alpha, by the material's name, or colours.
std::string why_unseen(Stage& stage);

/// Why most of a model is smaller than a pixel where its camera shows all of it; empty: it is not, or no file.
std::string why_too_small(const Stage& stage, const View& view);

}  // namespace zstrip::sim
