// "Did you mean": the known name that is nearest to what was typed.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// The name that the fewest letters inserted, deleted or replaced make of `text`, in any case; where all of them are
/// numbers, the one that differs least. Of several the first. `names`: at least one.
std::string_view nearest_name(std::string_view text, std::span<const std::string_view> names);

/// "'st778' is unknown, did you mean st7789? Known are st7789, ..."; where only numbers are known, of what is none:
/// "'four' is no number. Known are 1, 2, 4"; of what is gone: "'w16' is gone: use z24 ... Known are ...". `names`: at
/// least one.
std::string unknown_value(std::string_view text, std::span<const std::string_view> names);
/// The same behind the option's name.
std::string unknown_name(std::string_view option, std::string_view text, std::span<const std::string_view> names);

}  // namespace zstrip::sim
