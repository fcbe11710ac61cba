// Colours written as hexadecimal digits.
#pragma once

#include <optional>
#include <string_view>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Parses "rrggbb", the six digits after '#'; nullopt if it is anything else.
std::optional<Colour> parse_colour(std::string_view digits);

}  // namespace zstrip::sim
