// Opens panels with their own controller, on spidev, I2C or bit-banged lines.
#pragma once

#include <string>
#include <variant>

#include "open_display.hpp"

namespace zstrip::panel {

/// Returns the kinds of addresses that open_panel accepts, separated by spaces.
std::string panel_kinds();

/// Does the same as open_display, for an address whose kind is one of panel_kinds().
std::variant<DisplayPointer, Failure> open_panel(DisplayAddress& address);

}  // namespace zstrip::panel
