// The properties of methods that stages and pixel loops of all renderers ask for, so that these name no method.
#pragma once

#include "zstrip/visibility/methods.hpp"

namespace zstrip::detail::methods {

/// True for methods without a z-buffer.
constexpr bool has_no_depth(Effects effects) { return effects.has(method::painter); }
/// True for methods that keep bounds of the depth of tiles; all drawing code must update these.
constexpr bool keeps_bounds(Effects effects) { return effects.any(method::bounded); }
/// True for methods that test meshlets and runs of pixels against the bounds.
constexpr bool hides_by_bounds(Effects effects) { return effects.has(method::hierarchical_z); }
constexpr bool splits(Effects effects) { return effects.any(method::splitting); }
/// True for methods that draw pieces by samples, and so may draw other pixels than the z-buffer.
constexpr bool guesses(Effects effects) { return effects.has(method::midpoint); }
constexpr bool culls(Effects effects) { return effects.has(method::culling); }

/// Methods that act before a triangle is drawn, so that pixel loops do not depend on them.
inline constexpr Effects kOfOrder = method::front_to_back | method::orders;
/// Can be combined with another method, or used alone.
inline constexpr Effects kBesideOthers = method::culling;

}  // namespace zstrip::detail::methods
