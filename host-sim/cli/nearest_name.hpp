// "Did you mean": the known name that is nearest to what was typed.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// The name that the fewest letters inserted, deleted or replaced make of `text`; of several the first. Not empty.
std::string_view nearest_name(std::string_view text, std::span<const std::string_view> names);

/// "'st7798' is unknown, did you mean st7789? Known are st7789, ..."
std::string unknown_name(std::string_view option, std::string_view text, std::span<const std::string_view> names);

}  // namespace zstrip::sim
