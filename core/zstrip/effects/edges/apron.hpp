// The apron of a strip: one pixel more on each side, inside the picture, because edges are blended with neighbours.
#pragma once

#include <algorithm>

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::edges {

template <Effects effects>
bool has_apron(const FrameState& frame) {
  if constexpr (effects.has(effect::edges)) return effect_block(frame).has(effect::edges);
  return false;
}

constexpr std::size_t cells_of(const Rect& area) {
  return static_cast<std::size_t>(area.width()) * static_cast<std::size_t>(area.height());
}

/// Returns a strip, or another area of the picture, with its apron.
inline Rect strip_with_apron(const Rect& area, const View& view) {
  return {std::max<std::int32_t>(area.left - 1, 0), std::max<std::int32_t>(area.top - 1, 0),
          std::min<std::int32_t>(area.right + 1, view.width), std::min<std::int32_t>(area.bottom + 1, view.height)};
}

/// Returns a box that touches every strip whose apron `box` touches.
inline Rect box_with_apron(const Rect& box) {
  return box.empty() ? box : Rect{box.left - 1, box.top - 1, box.right + 1, box.bottom + 1};
}

/// Returns the memory of the strip's pixels after edges are blended. Nothing uses it before.
inline std::uint16_t* blended_pixels(const FrameState& frame, const StripImage& image) {
  if (drawn_in_place(frame.view.format)) return reinterpret_cast<std::uint16_t*>(image.out);
  return frame.working_colour + cells_of(image.area);
}

/// Copies the pixels of `area` from those of `drawn`, the strip with its apron. Both have no gaps.
void copy_without_apron(const std::uint16_t* from, const Rect& drawn, std::uint16_t* to, const Rect& area);

/// Checks a request with edges: the plan must have room for aprons, and no effect that excludes edges may be in use.
Status check_request(const FrameRequest& request);
/// Checks that the plan has room for the codes that shadows save.
Status check_saved(const FrameRequest& request);

}  // namespace zstrip::detail::edges
