// The apron of a strip: a pixel more on each side that lies in the picture, for edges that are blended with neighbours.
#pragma once

#include <algorithm>

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::edges {

template <Effects effects>
bool has_apron(const FrameState& frame) {
  if constexpr (effects.has(effect::edges)) return effect_block(frame).has(effect::edges);
  return false;
}

/// `area`: of a strip, in pixels of the picture.
inline Rect strip_with_apron(const Rect& area, const View& view) {
  return {std::max<std::int32_t>(area.left - 1, 0), std::max<std::int32_t>(area.top - 1, 0),
          std::min<std::int32_t>(area.right + 1, view.width), std::min<std::int32_t>(area.bottom + 1, view.height)};
}

/// `box`: what is drawn in all strips whose aprons it touches, too.
inline Rect box_with_apron(const Rect& box) {
  return box.empty() ? box : Rect{box.left - 1, box.top - 1, box.right + 1, box.bottom + 1};
}

/// The pixels of `area` from those of `drawn`, its strip with the apron. Both lie without gaps.
void copy_without_apron(const std::uint16_t* from, const Rect& drawn, std::uint16_t* to, const Rect& area);

/// For a scene with edges: whether the plan has room for aprons, and nothing else in use excludes edges.
Status check_request(const FrameRequest& request);

}  // namespace zstrip::detail::edges
