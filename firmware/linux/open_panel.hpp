// Opens the panels with a controller of their own, on spidev, I2C or bit-banged lines.
#pragma once

#include <string>
#include <variant>

#include "open_display.hpp"

namespace zstrip::panel {

/// The kinds of addresses that open_panel takes, one after the other with blanks.
std::string panel_kinds();

/// As open_display, for an address whose kind is one of panel_kinds().
std::variant<DisplayPointer, Failure> open_panel(DisplayAddress& address);

}  // namespace zstrip::panel
