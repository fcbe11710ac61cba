// "Did you mean": the known name that is nearest to what was typed.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// Returns the name that `text` becomes by inserting, deleting or replacing the fewest letters, whatever their case. If
/// all names are numbers, returns the one that differs least. The first one wins a tie. `names`: at least one.
std::string_view nearest_name(std::string_view text, std::span<const std::string_view> names);

/// Returns "'st778' is unknown, did you mean st7789? Known are st7789, ...". If all names are numbers and `text` is
/// not one: "'four' is not a number. Known are 1, 2, 4". If an earlier version had the name: "'w16' is gone: use z24
/// ... Known are ...". `names`: at least one.
std::string unknown_value(std::string_view text, std::span<const std::string_view> names);
/// Returns the text of unknown_value after the option's name.
std::string unknown_name(std::string_view option, std::string_view text, std::span<const std::string_view> names);

}  // namespace zstrip::sim
