// Tells stages and pixel loops, which all renderers have, what a method changes; they name no method themselves.
#pragma once

#include "zstrip/visibility/methods.hpp"

namespace zstrip::detail::methods {

/// Has no z-buffer.
constexpr bool has_no_depth(Effects effects) { return effects.has(method::painter); }
/// Keeps bounds of the depth in tiles, which whatever is drawn has to change.
constexpr bool keeps_bounds(Effects effects) { return effects.any(method::bounded); }
/// Looks at the bounds for meshlets and runs of pixels.
constexpr bool hides_by_bounds(Effects effects) { return effects.has(method::hierarchical_z); }
/// Splits triangles, and draws pieces.
constexpr bool splits(Effects effects) { return effects.any(method::splitting); }
/// Draws pieces by what samples say: other pixels than a z-buffer's.
constexpr bool guesses(Effects effects) { return effects.has(method::midpoint); }
/// Culls as VisibilityOptions say.
constexpr bool culls(Effects effects) { return effects.has(method::culling); }

/// Decided before a triangle is drawn: pixel loops are the same with and without.
inline constexpr Effects kOfOrder = method::front_to_back | method::orders;
/// Goes with another method or alone.
inline constexpr Effects kBesideOthers = method::culling;

}  // namespace zstrip::detail::methods
