// Finds the instance and triangle that a pixel of a frame shows, such as the one under a finger. zstrip.hpp does not
// include it.
#pragma once

#include <cstdint>

#include "zstrip/frame/picker.hpp"
#include "zstrip/renderer.hpp"

namespace zstrip {

/// Finds the surface that pixel (x, y) shows in the frame that a renderer with `effects` has begun: the one that was
/// drawn there last. Coverage, clipping, depth test, and texels that a mask discards are those of the picture, because
/// the same code draws this one pixel. With several samples a pixel it is the sample to the lower right of the pixel's
/// centre; with effect::edges the surface at the pixel's centre. A surface that blends with alpha 0 is not shown.
///
/// Call it after begin_frame, before or after any draw_strip; scene and arena must be those of the frame. Later
/// draw_strip calls draw the same pixels as without it. It transforms the meshlets whose spheres touch the pixel, or in
/// Mode::binned reads the strip's list, and draws a triangle only if its box contains the pixel. A wrong
/// Meshlet::radius hides triangles from it. Error::not_begun; Error::view_size outside of the picture; Error::csg if
/// the scene has products (`needed` = their operands), whose surfaces have no triangle of their own.
template <Effects effects>
Status pick(const Frame& frame, std::uint16_t x, std::uint16_t y, Picked& picked) {
  static_assert(effects.methods == 0, "pick draws with the z-buffer, not with a visibility method");
  return detail::Picker<effects>(frame).pick(x, y, picked);
}
/// Does the same for the frame of this renderer.
template <Effects effects>
Status pick(const Renderer<effects>& renderer, std::uint16_t x, std::uint16_t y, Picked& picked) {
  return pick<effects>(renderer.frame(), x, y, picked);
}
/// Does the same for the frame of a FixedRenderer, or of another renderer that names its effects.
template <class Fixed>
requires(Fixed::kEffects.methods == 0) Status
    pick(const Fixed& renderer, std::uint16_t x, std::uint16_t y, Picked& picked) {
  return pick<Fixed::kEffects>(renderer.frame(), x, y, picked);
}

/// Returns the function that picks in frames of pipeline_for(effects), and so in those of AnyRenderer(effects). For
/// depth formats other than z16, sub-ranges and perspective runs it returns a function that refuses with
/// Error::depth_effects, for visibility methods with Error::visibility. For hosts (library zstrip::core_any).
PickFunction picker_for(Effects effects);

}  // namespace zstrip
