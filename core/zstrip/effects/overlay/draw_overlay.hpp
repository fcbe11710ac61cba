// Draws an overlay over finished pixels.
#pragma once

#include <cstdint>

#include "zstrip/overlay.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// Over the RGB565 pixels of a rectangle of the picture, which have no gaps. Renderers with effect::overlay do it by
/// themselves; this is for pixels of draw_over, and of other origin. `overlay` has passed validate().
void draw_overlay(const Overlay& overlay, const Rect& area, std::uint16_t* pixels);

}  // namespace zstrip
